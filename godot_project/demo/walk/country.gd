# SPDX-License-Identifier: MIT
## The grass: a field in the middle, where everything happens, whose ground has cells of a metre; and four around it, up to the edge of the
## hills, with fewer and wider blades, since nobody sees them one by one.
extends Node3D

const Hills := preload("res://demo/walk/hills.gd")
const PRESETS := "res://addons/grass_field/presets/%s.tres"
const WEATHER := "res://addons/grass_field/hooks/weather.gdshaderinc"
const NEAR_DENSITY := 256.0  # blades a square metre
const FAR_DENSITY := 64.0
const FAR_WIDTH := 2.8  # times as wide
const SOIL := Color(0.24, 0.27, 0.12)
const FAR_POOL := 256  # tiles, of each far field: enough for a jeep
const TRACK := 24.0  # metres, radius of the track
## Species of the middle, and their shares. The far fields have no plants with a mesh, which show nearby only.
const SPECIES := {meadow = 0.62, hay_meadow = 0.28, daisy = 0.06, ox_eye_daisy = 0.006, fern = 0.003}
const WITH_MESH: Array[String] = ["ox_eye_daisy", "fern"]
const MESHES_TO := 15.0  # metres; up to 30 m they would cost as much as all the grass, up to here a quarter of that

var field: GrassField  ## the one in the middle
var fields: Array[GrassField] = []  ## all of them
var species: Array[GrassSpecies] = []  ## of all fields, in place of SPECIES
var soil_color := SOIL
var root_shade := 0.65

var _wide: Array[GrassSpecies] = []  # of all far fields: the blades of a patch are made once, and take memory once


func make(near: float, hills: Hills, density := NEAR_DENSITY) -> void:
	field = _add("Field", Rect2(-0.5 * near, -0.5 * near, near, near), density, true)
	field.measure_time = true
	field.bake_ground_from(hills.shape, hills.global_transform)
	surround(near, hills.side, hills, minf(density, FAR_DENSITY))
	_paint_track(hills)


## Adds four fields around a square with the side `inner`, up to one with the side `outer`.
func surround(inner: float, outer: float, hills: Hills, density: float) -> void:
	var half := 0.5 * outer
	var rim := half - 0.5 * inner
	if rim < 1.0:
		return
	for rect: Rect2 in [
		Rect2(-half, -half, outer, rim),
		Rect2(-half, 0.5 * inner, outer, rim),
		Rect2(-half, -0.5 * inner, rim, inner),
		Rect2(0.5 * inner, -0.5 * inner, rim, inner)
	]:
		_add("Far%d" % fields.size(), rect, density, density == NEAR_DENSITY).bake_ground_from(hills.shape, hills.global_transform)


## Returns the field at a place; null outside of all of them.
func field_at(place: Vector3) -> GrassField:
	for each in fields:
		if each.get_tile_at(place) != Vector2i(-1, -1):
			return each
	return null


## Makes all grass as it was in the beginning.
func grow_back() -> void:
	for each in fields:
		each.regrow(10.0, 1.0)


func _add(p_name: String, rect: Rect2, density: float, is_near: bool) -> GrassField:
	var made := GrassField.new()
	made.name = p_name
	made.size = rect.size
	made.position = Vector3(rect.get_center().x, 0.0, rect.get_center().y)
	made.density = density
	made.border_fade = 0.0  # the next field begins there
	made.soil_color = soil_color
	made.root_shade = root_shade
	made.bare_soil = 1.0
	made.wheel_wear = 3.0
	made.map = GrassMap.new()
	made.map.base_density = 1.0
	made.surface_hook = load(WEATHER)
	if is_near:
		made.species = species if species else _mixed(true)
	else:
		if not _wide:
			_wide = _widened(species if species else _mixed(false))
		made.species = _wide
		made.pool_tiles = FAR_POOL
		made.shadow_distance = 0.0
	add_child(made)
	fields.append(made)
	return made


func _mixed(is_near: bool) -> Array[GrassSpecies]:
	var mixed: Array[GrassSpecies] = []
	for preset: String in SPECIES:
		if is_near or preset not in WITH_MESH:
			mixed.append((load(PRESETS % preset) as GrassSpecies).duplicate())
			mixed[-1].share = SPECIES[preset]
			if preset in WITH_MESH:
				mixed[-1].plant_distance = MESHES_TO
	return mixed


func _widened(narrow: Array[GrassSpecies]) -> Array[GrassSpecies]:
	var wide: Array[GrassSpecies] = []
	for each in narrow:
		wide.append(each.duplicate())
		wide[-1].patch = each.patch.duplicate() if each.patch else GrassPatch.new()
		wide[-1].patch.width_min *= FAR_WIDTH
		wide[-1].patch.width_max *= FAR_WIDTH
	return wide


## A dirt track around the place where the walk begins: bare in its wheel ruts, low beside them.
func _paint_track(hills: Hills) -> void:
	var verge := GrassBrush.new()
	verge.tool = GrassBrush.TOOL_HEIGHT
	verge.target = 0.45
	verge.strength = 1.0
	verge.radius = 2.6
	verge.hardness = 0.3
	_draw_round(verge, TRACK, hills)
	var rut := GrassBrush.new()
	rut.tool = GrassBrush.TOOL_ERASE
	rut.strength = 0.9
	rut.radius = 0.5
	for off: float in [-0.85, 0.85]:
		_draw_round(rut, TRACK + off, hills)


func _draw_round(brush: GrassBrush, radius: float, hills: Hills) -> void:
	var from := Vector3(radius, 0.0, 0.0)
	for i in range(1, 65):
		var angle := TAU * i / 64.0
		var wobble := radius * (1.0 + 0.12 * sin(3.0 * angle))
		var to := Vector3(wobble * cos(angle), 0.0, wobble * sin(angle))
		field.paint(brush, hills.on_ground(from), hills.on_ground(to))
		from = to
