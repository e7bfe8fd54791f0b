# SPDX-License-Identifier: MIT
## Before and after: for each feature two pictures of the same place in the same light, side by side. Started with `-- --out DIR`
## (`./grass demo pairs`) it writes them, then ends; otherwise the keys left and right change the pair, and space its half.
##   --only NAMES   only these pairs, separated by commas
##   --size SIZE    of the country, as of the walk: large (default), small, tiny
extends Node3D

const Options := preload("res://demo/options.gd")
const Shots := preload("res://demo/shots.gd")
const Stage := preload("res://demo/stage.gd")
const Pair := preload("res://demo/pairs/pair.gd")
const Features := preload("res://demo/pairs/features.gd")
const SIZE := Vector2i(960, 540)  # pixels, of both halves together
const LINE := 2  # pixels, between them
const QUALITY := 0.86

## One of those of the walk; empty: the one in the arguments, by default large.
@export var size := ""

var pair: Pair  ## the one that is shown
var is_after := false

var _options := Options.read({"out": "", "only": "", "size": "large"})

var _shots: Shots

@onready var stage: Stage = $Stage
@onready var _camera: Camera3D = $Camera


func _ready() -> void:
	get_viewport().msaa_3d = Viewport.MSAA_4X
	stage.make(size if size else _options.size)
	if _options.out:
		await _record(_options.out)
		get_tree().quit()
	else:
		await show_pair(Features.ALL.keys()[0], false)


## Shows a half of a pair: makes the country as it was, and then what the half shows.
func show_pair(p_name: String, p_is_after: bool) -> void:
	if pair:
		pair.undo()
		pair.free()
	is_after = p_is_after
	stage.country.grow_back()
	stage.set_wind(2.0, 0.4)
	await _build()
	pair = Features.ALL[p_name].new()
	pair.name = p_name
	pair.stage = stage
	add_child(pair)
	pair.place_camera(_camera)
	await pair.make(is_after)
	if pair.rebuilds:
		await _build()
	await pair.wait(pair.settles)


## Lets the fields finish what they build, for a picture.
func _build() -> void:
	if _shots:
		await _shots.warm_up()


func _record(folder: String) -> void:
	_shots = Shots.new(get_viewport(), folder)
	var names: PackedStringArray = _options.only.split(",") if _options.only else PackedStringArray(Features.ALL.keys())
	for each in names:
		var halves: Array[Image] = []
		for after: bool in [false, true]:
			await show_pair(each, after)
			halves.append(await _shots.picture())
		var error := _side_by_side(halves).save_jpg(folder.path_join(each + ".jpg"), QUALITY)
		if error != OK:
			push_error("Pairs: cannot write into %s (%s)." % [folder, error_string(error)])
		print("%s: %s" % [each, pair.about])


## Returns the middles of two pictures.
func _side_by_side(halves: Array[Image]) -> Image:
	var both := Image.create(SIZE.x, SIZE.y, false, Image.FORMAT_RGB8)
	both.fill(Color.WHITE)
	for i in 2:
		var half := halves[i]
		half.convert(Image.FORMAT_RGB8)
		half.resize(SIZE.y * half.get_width() / half.get_height(), SIZE.y, Image.INTERPOLATE_LANCZOS)
		var part := Vector2i((SIZE.x - LINE) >> 1, SIZE.y)
		both.blit_rect(half, Rect2i(Vector2i((half.get_width() - part.x) >> 1, 0), part), Vector2i(i * (part.x + LINE), 0))
	return both


func _unhandled_key_input(event: InputEvent) -> void:
	var step: int = int(event.keycode == KEY_RIGHT) - int(event.keycode == KEY_LEFT)
	var names := Features.ALL.keys()
	if event.is_pressed() and step != 0:
		show_pair(names[posmod(names.find(pair.name) + step, names.size())], false)
	elif event.is_pressed() and event.keycode == KEY_SPACE:
		show_pair(pair.name, not is_after)
