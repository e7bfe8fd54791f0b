# SPDX-License-Identifier: MIT
## A field of each preset in a landscape, as dense as in nature. Started with `-- --out DIR` (`./grass demo presets`)
## it takes a picture of each, then ends; with `--only NAMES` only of these. `--size small` makes small fields: for software rendering.
extends Node3D

const Country := preload("res://demo/walk/country.gd")
const Landscape := preload("res://demo/landscape.gd")
const Options := preload("res://demo/options.gd")
const Shots := preload("res://demo/shots.gd")
const FOLDER := "res://addons/grass_field/presets/"
const WIND := 2.0  # m/s
const PICTURE := Vector2i(640, 360)  # pixels
const EYES := 1.7  # metres
const MOSS := 0.2  # how much darker than roots the soil is, which moss and old blades cover
const SIDE := 24.0  # metres, of each field
const BORDER := 3.0  # metres, in which a stand gets thinner and lower, and in which the landscape's grass begins
const TURN := 0.55  # radians by which one looks aside: a border that lies across the picture looks straight, however ragged it is
## Blades a square metre, and the side of the field in metres where fields are small.
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
var _is_small := false
var _options := Options.read({"out": "", "only": "", "size": "large"})

@onready var _camera: Camera3D = $Camera


func _ready() -> void:
	if _options.only:
		_shown = Array(_options.only.split(","))
	_is_small = _options.size == "small"
	for name: String in _shown:
		var field := make(name)
		field.size = Vector2.ONE * float(FIELDS[name][1] if _is_small else SIDE)
		add_child(field)
	var landscape := Landscape.new()
	add_child(landscape)
	landscape.make(SIDE - 2.0 * BORDER, SIDE, _is_small)
	landscape.country.fray(SIDE - 2.0 * BORDER)
	landscape.set_wind(WIND)
	Landscape.open_sky($World, $Sun)
	_show(0)
	if _options.out:
		await _record(_options.out)
		get_tree().quit()


## Returns the field of a preset.
static func make(name: String) -> GrassField:
	var field := GrassField.new()
	var species: GrassSpecies = load(FOLDER + name + ".tres")
	field.name = name.to_pascal_case()
	field.density = FIELDS[name][0]
	field.border_fade = BORDER
	field.border_waver = 1.0
	field.soil_color = Country.SOIL
	field.wind_speed = WIND
	field.clump_size = maxf(0.3, 2.5 * species.patch.length_max)
	field.soil_color = species.root_color.darkened(MOSS)
	# Flowers grow among grass.
	field.species = [load(FOLDER + "meadow.tres"), species] if species.share < 0.3 else [species]
	return field


func _record(folder: String) -> void:
	var shots := Shots.new(get_viewport(), folder)
	await shots.warm_up()
	for i in _shown.size():
		_show(i)
		var picture := await shots.picture()
		picture.resize(PICTURE.x, PICTURE.y, Image.INTERPOLATE_LANCZOS)
		var error := picture.save_jpg(folder.path_join("preset_%s.jpg" % _shown[i]), 0.88)
		if error != OK:
			push_error("Presets: cannot write into %s (%s)." % [folder, error_string(error)])


## Looks over a field, a little above the grass; at grass that is taller than a man from beside it.
func _show(index: int) -> void:
	for i in _shown.size():
		_field(i).visible = i == index
	var species: GrassSpecies = _field(index).species[-1]
	var height := species.patch.length_max
	var edge := 0.5 * _field(index).size.y
	var eye := Vector3(0.0, 1.25 * height + 0.4, minf(edge - 0.5, 9.0))
	var ahead := Vector3(0.0, -0.8 * height - 0.4, -1.5 - 2.2 * height).rotated(Vector3.UP, TURN)
	if height > EYES:
		eye = Vector3(0.0, EYES, edge + 1.2 * height)
		ahead = Vector3(0.0, 0.35 * height - EYES, -1.8 * height)
	_camera.look_at_from_position(eye, eye + ahead)


func _field(index: int) -> GrassField:
	return get_node(NodePath(str(_shown[index]).to_pascal_case()))


func _unhandled_key_input(event: InputEvent) -> void:
	var index: int = event.keycode - KEY_1
	if event.is_pressed() and index >= 0 and index < _shown.size():
		_show(index)
