# SPDX-License-Identifier: MIT
## The same grass in many lights and from many places: one view after the other, each with 4x MSAA and with TAA. Started with
## `-- --out DIR` (`./grass gallery`) it takes the pictures of all views, writes `gallery.json` with facts about them, then ends.
##   --only NAMES   only these views, separated by commas
##   --size small   small fields: for software rendering
## Otherwise the keys left and right change the view.
extends Node3D

const Options := preload("res://demo/options.gd")
const Views := preload("res://demo/gallery/views.gd")
const Place := preload("res://demo/gallery/place.gd")
const Light := preload("res://demo/gallery/light.gd")
const COMPILING := 150_000  # milliseconds
const SETTLE := {true: 6, false: 40}  # frames until TAA, fog and global light have settled: in software, on a GPU

var shown := 0

var _options := Options.read({"out": "", "only": "", "size": "large"})
var _place: Place
var _light: Light

@onready var _camera: Camera3D = $Camera


func _ready() -> void:
	if _options.out:
		await _record(_options.out)
		get_tree().quit()
	else:
		show_view(Views.ALL.keys()[shown])


## Builds the place and the light of a view, and puts the camera there.
func show_view(name: String) -> void:
	var view := Views.of(name)
	if _place == null or _place.kind != view.place:
		if _place:
			_place.free()
		_place = Place.new(view.place, _options.size == "small")
		add_child(_place)
	_place.show_at(view.target)
	_place.set_weather(view.with)
	if _light:
		_light.free()
	_light = Light.new(view)
	add_child(_light)
	_camera.fov = view.fov
	_camera.look_at_from_position(_place.on_ground(view.eye), _place.on_ground(view.target))


func _record(folder: String) -> void:
	DirAccess.make_dir_recursive_absolute(folder)
	var software: bool = RenderingServer.get_video_adapter_type() == RenderingDevice.DEVICE_TYPE_CPU
	var rows: Array[Dictionary] = []
	for name: String in Views.ALL:
		if not _options.only or name in _options.only.split(","):
			show_view(name)
			rows.append({name = name, about = Views.ALL[name].about, settings = Views.settings(name) + _place.facts()})
			var times := await _take(folder.path_join(name), SETTLE[software])
			if not software:
				rows[-1].settings.append("GPU time of a frame: %.1f ms, %.1f ms" % times)
			print("%s: %s; %.1f ms on the CPU" % [name, ", ".join(rows[-1].settings), _place.field.get_counters().frame_ms])
	var about := {device = RenderingServer.get_video_adapter_name(), views = rows}
	var file := FileAccess.open(folder.path_join("gallery.json"), FileAccess.WRITE)
	if file == null:
		push_error("Gallery: cannot write into %s (%s)." % [folder, error_string(FileAccess.get_open_error())])
		return
	file.store_string(JSON.stringify(about, "\t") + "\n")


## Returns the GPU's milliseconds for a frame of each picture.
func _take(path: String, settle: int) -> Array[float]:
	var times: Array[float] = []
	var viewport := get_viewport()
	RenderingServer.viewport_set_measure_render_time(viewport.get_viewport_rid(), true)
	for uses_taa: bool in [false, true]:
		viewport.msaa_3d = Viewport.MSAA_DISABLED if uses_taa else Viewport.MSAA_4X
		viewport.use_taa = uses_taa
		await _frames(2)
		var deadline := Time.get_ticks_msec() + COMPILING
		while _place.is_waiting() and Time.get_ticks_msec() < deadline:
			await get_tree().process_frame
		await _frames(settle)
		times.append(RenderingServer.viewport_get_measured_render_time_gpu(viewport.get_viewport_rid()))
		var error := viewport.get_texture().get_image().save_jpg(path + ("_taa.jpg" if uses_taa else "_msaa.jpg"), 0.92)
		if error != OK:
			push_error("Gallery: cannot write %s (%s)." % [path, error_string(error)])
	return times


func _frames(count: int) -> void:
	for i in count:
		await RenderingServer.frame_post_draw


func _unhandled_key_input(event: InputEvent) -> void:
	var step: int = int(event.keycode == KEY_RIGHT) - int(event.keycode == KEY_LEFT)
	if event.is_pressed() and step != 0:
		shown = posmod(shown + step, Views.ALL.size())
		show_view(Views.ALL.keys()[shown])
