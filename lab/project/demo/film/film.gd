# SPDX-License-Identifier: MIT
## The film of the README: shots in the walk's country, one after the other. It plays in real time, again and again; started with
## `-- --out DIR` it writes each frame as a picture, then ends. `./grass demo --video` does that, and makes a video of them.
##   --rate N       frames a second (default 30); the engine needs --fixed-fps N then
##   --every N      only every Nth frame, for a look at the shots
##   --only NAMES   only these shots, separated by commas
##   --size SIZE    of the country, as of the walk: large (default), small, tiny
extends Node3D

const Options := preload("res://demo/options.gd")
const Shot := preload("res://demo/film/shot.gd")
const Shots := preload("res://demo/shots.gd")
const Stage := preload("res://demo/stage.gd")
const SHOTS := {
	bodies = preload("res://demo/film/bodies.gd"),
	walker = preload("res://demo/film/walker.gd"),
	gust = preload("res://demo/film/gust.gd"),
	jeep = preload("res://demo/film/jeep.gd"),
	blast = preload("res://demo/film/blast.gd"),
	mower = preload("res://demo/film/mower.gd"),
}
const QUALITY := 0.7  # of the frames, which are encoded once more

## One of those of the walk; empty: the one in the arguments, by default large.
@export var size := ""

var shot: Shot  ## the one that is shown

var _writing: Array[int] = []  # tasks
var _options := Options.read({"out": "", "rate": 30, "every": 1, "only": "", "size": "large"})

@onready var stage: Stage = $Stage
@onready var _camera: Camera3D = $Camera


func _ready() -> void:
	get_viewport().msaa_3d = Viewport.MSAA_4X
	stage.make(size if size else _options.size)
	if _options.out:
		await _record(_options.out)
		get_tree().quit()
	else:
		show_shot(SHOTS.keys()[0])


func _physics_process(delta: float) -> void:
	if shot == null:
		return
	shot.advance(delta)
	stage.set_wind(shot.wind, shot.gusts)
	if not _options.out and shot.time > shot.seconds:
		var names := SHOTS.keys()
		show_shot(names[(names.find(shot.name.to_lower()) + 1) % names.size()])


func show_shot(p_name: String) -> void:
	if shot:
		shot.free()
	stage.country.grow_back()
	shot = SHOTS[p_name].new()
	shot.name = p_name.capitalize()
	shot.set_up(stage.hills, stage.country, _camera)
	add_child(shot)


func _record(folder: String) -> void:
	var names: PackedStringArray = _options.only.split(",") if _options.only else PackedStringArray(SHOTS.keys())
	await Shots.new(get_viewport(), folder).warm_up()
	for each in names:
		show_shot(each)
		get_viewport().disable_3d = true
		while shot.time < 0.0:
			await RenderingServer.frame_post_draw
		var begin := Time.get_ticks_msec()
		var frames := roundi(shot.seconds * _options.rate)
		for i in frames:
			await _frame(i % int(_options.every) == 0, folder.path_join("%d_%s_%03d.webp" % [SHOTS.keys().find(each) + 1, each, i]))
		print("%s: %d frames, %d ms a frame" % [each, frames, (Time.get_ticks_msec() - begin) / frames])
	for task in _writing:
		WorkerThreadPool.wait_for_task_completion(task)


## Lets a frame's time pass; draws it and writes it if it `is_wanted`.
func _frame(is_wanted: bool, path: String) -> void:
	var before := shot.time
	get_viewport().disable_3d = not is_wanted
	await RenderingServer.frame_post_draw
	if not is_equal_approx(shot.time - before, 1.0 / float(_options.rate)):
		push_warning("Film: a frame of %.4f s. Start the engine with --fixed-fps %d." % [shot.time - before, _options.rate])
	if not is_wanted:
		return
	var image := get_viewport().get_texture().get_image()
	_writing.append(WorkerThreadPool.add_task(func() -> void: image.save_webp(path, true, QUALITY)))
