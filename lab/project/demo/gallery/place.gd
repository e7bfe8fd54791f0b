# SPDX-License-Identifier: MIT
## The plants in a view of the gallery, the ground below them, and the landscape around.
extends Node3D

const Earth := preload("res://demo/earth.gd")
const Landscape := preload("res://demo/landscape.gd")
const PRESETS := "res://addons/grass_field/presets/%s.tres"
const WEATHER := "res://addons/grass_field/hooks/weather.gdshaderinc"
const STONE := Color(0.33, 0.32, 0.29)  # around plots in the shade
const SMALL := 20.0  # metres, the side of a field in software
## Side of the field in metres, blades a square metre, species.
const KINDS := {
	meadow = [240.0, 600.0, ["meadow", "hay_meadow", "clover", "daisy"]],
	hills = [240.0, 400.0, ["meadow", "hay_meadow", "daisy"]],
	painted = [120.0, 500.0, ["meadow", "tall_dry_grass", "daisy"]],
	plants = [40.0, 60.0, ["meadow", "fern", "ox_eye_daisy", "small_shrub"]],
	plots = [1.2, 600.0, ["meadow"]],
	kilometre = [1000.0, 150.0, ["meadow", "hay_meadow"]],
	border = [240.0, 600.0, ["meadow", "hay_meadow", "clover", "daisy"]],
}

## The middles of the fields if there are several, from left to right.
const PLOTS: Array[Vector3] = [Vector3(-2.4, 0, 1), Vector3(-1.2, 0, 1), Vector3(0, 0, 1), Vector3(1.2, 0, 1), Vector3(2.4, 0, 1)]

const BARE := {plots = 24.0, border = 264.0}  # metres, side of the bare ground on which a field ends
const WIND := 4.0  # m/s

## Shares of plants with a mesh, fewer than in a field of their own.
const THINNED := {fern = 0.2, small_shrub = 0.04}

var kind: String
var field := GrassField.new()

var _is_small: bool
var _landscape := Landscape.new()


func _init(p_kind: String, is_small: bool) -> void:
	kind = p_kind
	_is_small = is_small
	var row: Array = KINDS[kind]
	field.size = Vector2.ONE * (SMALL if is_small else float(row[0]))
	field.density = row[1]
	field.wind_speed = WIND
	if kind != "border":
		field.border_fade = 0.0  # the next field begins there
	var species: Array[GrassSpecies] = []
	for name: String in row[2]:
		species.append(load(PRESETS % name))
		if name in THINNED:
			species[-1] = species[-1].duplicate()
			species[-1].share = THINNED[name]
	field.species = species
	add_child(field)
	if kind == "plots":
		_make_plots()
	if kind != "hills":
		add_child(_plain())
	add_child(_landscape)
	if kind == "painted":
		field.map = GrassMap.new()
		field.map.base_density = 1.0
		field.bare_soil = 1.0  # its path is earth


func _ready() -> void:
	var hills: Landscape.Hills = _landscape.hills
	var bare: float = BARE.get(kind, 0.0)
	_landscape.make(maxf(bare, field.size.x), 0.0 if kind == "hills" else maxf(bare, KINDS[kind][0]), _is_small)
	_landscape.set_wind(WIND)
	if kind == "hills":
		field.bake_ground_from(hills.shape, hills.global_transform)
	elif kind == "painted":
		_paint()


## Sets snow and rain if the view has them.
func set_weather(with: Array) -> void:
	field.snow = 0.6 if "snow" in with else 0.0
	field.wetness = 1.0 if "rain" in with else 0.0
	field.surface_hook = load(WEATHER) if field.snow + field.wetness > 0.0 else null
	_landscape.set_weather(field.snow, field.wetness)


## The place of a small field: where the camera looks.
func show_at(place: Vector3) -> void:
	if _is_small and kind in ["meadow", "plants", "border", "kilometre"]:
		field.position = Vector3(place.x, 0, place.z)
		_landscape.position = field.position


## Returns a place whose height is measured from the ground there.
func on_ground(place: Vector3) -> Vector3:
	return _landscape.hills.on_ground(place, place.y)


## Returns whether a field, also of the landscape, still waits for its grass.
func is_waiting() -> bool:
	for each: GrassField in find_children("*", "GrassField", true, false):
		var facts := each.get_statistics().merged(each.get_counters())
		if facts.waiting or facts.compiling > 0 or facts.map_waiting > 0:
			return true
	return false


## Returns the sum over the fields that the view is about.
func blade_count() -> int:
	var count := 0
	for each: GrassField in find_children("*", "GrassField", false, false):
		count += each.get_blade_count()
	return count


func facts() -> PackedStringArray:
	return ["%s: %d blades, %d a square metre, of %s" % [kind, blade_count(), KINDS[kind][1], ", ".join(PackedStringArray(KINDS[kind][2]))]]


## Makes several fields side by side, since a field takes the light of probes as one value.
func _make_plots() -> void:
	field.size = Vector2(1.2, 5.0)
	field.gi_mode = GeometryInstance3D.GI_MODE_DYNAMIC
	field.position = PLOTS[0]
	for i in range(1, PLOTS.size()):
		var plot: GrassField = field.duplicate()
		plot.position = PLOTS[i]
		plot.seed = i
		add_child(plot)


func _plain() -> MeshInstance3D:
	var ground := MeshInstance3D.new()
	ground.mesh = PlaneMesh.new()
	ground.mesh.size = Vector2.ONE * float(BARE.get(kind, field.size.x))
	ground.mesh.material = Earth.material()
	if kind == "plots":
		ground.mesh.material = _stone()
		ground.gi_mode = GeometryInstance3D.GI_MODE_DYNAMIC  # the light of the probes in its middle
	return ground


func _stone() -> StandardMaterial3D:
	var stone := StandardMaterial3D.new()
	stone.albedo_color = STONE
	stone.roughness = 1.0
	return stone


## A path that winds from the camera to the far side, and stands of the second species beside it.
func _paint() -> void:
	var path := GrassBrush.new()
	path.tool = GrassBrush.TOOL_ERASE
	path.radius = 1.3
	path.strength = 1.0
	var tall := GrassBrush.new()
	tall.tool = GrassBrush.TOOL_SPECIES
	tall.species = 2
	tall.radius = 4.0
	var before := Vector3(-2, 0, 40)
	for i in range(1, 40):
		var now := Vector3(5.0 * sin(0.35 * i) - 2.0 * cos(0.35 * i), 0, 40.0 - 2.0 * i)
		field.paint(path, before, now)
		before = now
	for place: Vector3 in [Vector3(-9, 0, 4), Vector3(8, 0, -8), Vector3(-4, 0, -22)]:
		field.paint(tall, place, place + Vector3(3, 0, -2))
