# SPDX-License-Identifier: MIT
## The paper's figure 6: 128 mixed bodies thrown through a field. Started with `-- --out DIR` it takes its pictures
## and prints its table, then ends (`./grass demo` does that); started from the editor it runs until it is closed: bodies are thrown again
## every ten seconds, F1 shows the awake tiles, F2 the levels of detail, B begins the benchmark.
##   --out DIR      folder for the pictures and the table
##   --size SIZE    side of the field: large (64 m, 1,048,576 blades), small (20 m, 102,400 blades) or a number of metres;
##                  by default large on a GPU, small in software
##   --bodies N     default 128
##   --place NAME   another scene of this folder instead, which reads the other arguments: lawn, meadow, reeds, forces, burning, levels,
##                  walk, presets, gallery, pairs, film, benchmark (an exported project takes no scene's path)
extends Node3D

const Landscape := preload("res://demo/landscape.gd")
const Options := preload("res://demo/options.gd")
const Bodies := preload("res://demo/bodies.gd")
const Report := preload("res://demo/report.gd")
const Shots := preload("res://demo/shots.gd")

const SHOT_TIMES: Array[float] = [0.4, 0.8, 1.2, 1.8, 2.6, 4.0]  # seconds after the throw
const THROW_AGAIN := 10.0  # seconds
const SIZES := {"large": 64.0, "small": 20.0}  # metres

@onready var field: GrassField = $Field
@onready var camera: Camera3D = $Camera

var _options := Options.read({"out": "", "size": "", "bodies": 128, "place": "demo"})
var _landscape := Landscape.new()
var _bodies: Array[RigidBody3D] = []
var _time := 0.0  # seconds since the throw, in physics ticks


func _ready() -> void:
	if _options.place != "demo":
		get_tree().change_scene_to_file.call_deferred("res://demo/%s.tscn" % _options.place)
		return
	var software: bool = (
		RenderingServer.get_video_adapter_type() == RenderingDevice.DEVICE_TYPE_CPU
		or RenderingServer.get_current_rendering_method() == "gl_compatibility"
	)
	var size: String = _options.size if _options.size else ("small" if software else "large")
	var side: float = SIZES.get(size, size.to_float())
	field.size = Vector2(side, side)
	add_child(_landscape)
	_landscape.surround(field, null, software)
	Landscape.open_sky($World, $Sun)
	field.measure_time = true
	if software:  # one cascade instead of four: a frame takes seconds
		$Sun.directional_shadow_mode = DirectionalLight3D.SHADOW_ORTHOGONAL
		$Sun.directional_shadow_max_distance = side
	_look_along(0.0)
	if _options.out:
		await _record(side, software)
		get_tree().quit()
	else:
		_throw(side)


func _physics_process(delta: float) -> void:
	_time += delta
	if not _options.out and _time > THROW_AGAIN:
		_throw(field.size.x)


func _process(_delta: float) -> void:
	if not _options.out:
		_look_along(_time)


func _unhandled_key_input(event: InputEvent) -> void:
	if event.is_pressed() and event.keycode == KEY_B:
		get_tree().change_scene_to_file("res://demo/benchmark.tscn")
	if event.is_pressed() and event.keycode in [KEY_F1, KEY_F2]:
		var view := GrassField.DEBUG_VIEW_AWAKE_TILES if event.keycode == KEY_F1 else GrassField.DEBUG_VIEW_LOD
		_show(GrassField.DEBUG_VIEW_OFF if field.debug_view == view else view)


func _show(view: GrassField.DebugView) -> void:
	for each: GrassField in [field] + _landscape.country.fields:
		each.debug_view = view


func _throw(side: float) -> void:
	for body in _bodies:
		body.queue_free()
	_bodies.clear()
	var source := Bodies.new(7)
	for i: int in _options.bodies:
		var body := source.make()
		source.throw(body, side)
		_bodies.append(body)
		add_child(body)
	_time = 0.0


## The camera's path: low over the grass, along the way the bodies fly, looking across them.
func _look_along(seconds: float) -> void:
	var side := field.size.x
	var along := clampf(seconds / 6.0, 0.0, 1.0)
	camera.position = Vector3(lerpf(-0.34, 0.02, along) * side, lerpf(1.5, 2.4, along), 0.3 * side - 2.5 * along)
	camera.look_at(Vector3(lerpf(-0.16, 0.1, along) * side, 0.2, -0.02 * side))


func _look_down() -> void:
	var side := field.size.x
	camera.position = Vector3(0.0, 0.85 * side, 0.42 * side)
	camera.look_at(Vector3(0.0, 0.0, 0.03 * side))


func _record(side: float, software: bool) -> void:
	var shots := Shots.new(get_viewport(), _options.out)
	var report := Report.new(field)
	await shots.warm_up()
	await shots.take("0_meadow")
	_throw(side)
	for i in SHOT_TIMES.size():
		while _time < SHOT_TIMES[i]:
			await get_tree().physics_frame
			report.tick(_time)
		_look_along(SHOT_TIMES[i])
		await shots.take("%d_at_%.1f_s" % [i + 1, SHOT_TIMES[i]])
		report.frame(shots.draw_ms)
	_look_down()
	await shots.take("7_birds_eye")
	_show(GrassField.DEBUG_VIEW_AWAKE_TILES)
	await shots.take("8_birds_eye_awake_tiles")
	_show(GrassField.DEBUG_VIEW_OFF)
	var table := report.table(_bodies.size(), software)
	print(table)
	var file := FileAccess.open(_options.out.path_join("table.txt"), FileAccess.WRITE)
	if file == null:
		push_error("Demo: cannot write into %s (%s)." % [_options.out, error_string(FileAccess.get_open_error())])
	else:
		file.store_string(table + "\n")
