# SPDX-License-Identifier: MIT
## A field of each preset, side by side, as dense as in nature. Started with `-- --out DIR` (`./grass demo presets`)
## it takes a picture of each, then ends; with `--only NAME` only of that one.
extends Node3D

const Shots := preload("res://demo/shots.gd")
const FOLDER := "res://addons/grass_field/presets/"
const SPACING := 30.0  # metres from one field to the next
## Blades a square metre, and the side of the field in metres.
const FIELDS := {
	meadow = [600.0, 16.0],
	hay_meadow = [500.0, 16.0],
	lawn = [4000.0, 5.0],
	golf_green = [4096.0, 4.0],
	reed = [80.0, 20.0],
	wheat = [400.0, 16.0],
	barley = [400.0, 16.0],
	tall_dry_grass = [300.0, 18.0],
	clover = [900.0, 6.0],
	tundra = [1200.0, 6.0],
	daisy = [600.0, 12.0],
	fern = [40.0, 12.0],
	ox_eye_daisy = [600.0, 12.0],
	small_shrub = [32.0, 12.0],
}

var _shown: Array = FIELDS.keys()

@onready var _camera: Camera3D = $Camera


func _ready() -> void:
	var arguments := OS.get_cmdline_user_args()
	var only := arguments.find("--only")
	if only >= 0 and only + 1 < arguments.size():
		_shown = [arguments[only + 1]]
	for name: String in _shown:
		add_child(make(name))
	_show(0)
	var out := arguments.find("--out")
	if out >= 0 and out + 1 < arguments.size():
		await _record(arguments[out + 1])
		get_tree().quit()


## The field of a preset.
static func make(name: String) -> GrassField:
	var field := GrassField.new()
	var species: GrassSpecies = load(FOLDER + name + ".tres")
	field.name = name.to_pascal_case()
	field.density = FIELDS[name][0]
	field.size = Vector2.ONE * float(FIELDS[name][1])
	field.position.x = SPACING * FIELDS.keys().find(name)
	field.wind_speed = 2.0
	field.clump_size = maxf(0.3, 2.5 * species.patch.length_max)
	# Flowers grow among grass.
	field.species = [load(FOLDER + "meadow.tres"), species] if species.share < 0.3 else [species]
	return field


func _record(folder: String) -> void:
	var shots := Shots.new(get_viewport(), folder)
	await shots.warm_up()
	for i in _shown.size():
		_show(i)
		await shots.take("preset_" + str(_shown[i]))


## Looks at a field from its border, from at least twice the height of the grass.
func _show(index: int) -> void:
	var name: String = _shown[index]
	var species: GrassSpecies = load(FOLDER + name + ".tres")
	var side: float = FIELDS[name][1]
	var height := species.patch.length_max
	for i in _shown.size():
		get_node(NodePath(str(_shown[i]).to_pascal_case())).visible = i == index
	var place: float = get_node(NodePath(name.to_pascal_case())).position.x
	var eye := Vector3(place, height + maxf(maxf(0.06 * side, 0.4 * height), 0.3), 0.5 * side + 0.5 * height)
	_camera.look_at_from_position(eye, Vector3(place, 0.4 * height, 0.5 * side - 2.5 * height - 0.1 * side))


func _unhandled_key_input(event: InputEvent) -> void:
	var index: int = event.keycode - KEY_1
	if event.is_pressed() and index >= 0 and index < _shown.size():
		_show(index)
