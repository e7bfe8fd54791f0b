# SPDX-License-Identifier: MIT
## The grass: a field in the middle, where everything happens, whose ground has cells of a metre; and four around it, up to the edge of the
## hills, with fewer and wider blades, since nobody sees them one by one.
extends Node3D

const Hills := preload("res://demo/walk/hills.gd")
const Trail := preload("res://demo/trail.gd")
const PRESETS := "res://addons/grass_field/presets/%s.tres"
const WEATHER := "res://addons/grass_field/hooks/weather.gdshaderinc"
const NEAR_DENSITY := 256.0  # blades a square metre
const FAR_DENSITY := 64.0
const FAR_WIDTH := 2.8  # times as wide
const SOIL := Color(0.27, 0.24, 0.15)
const FAR_POOL := 256  # tiles, of each far field: enough for a jeep
const TRACK := 24.0  # metres, radius of the track
const RUTS := 1.0  # metres, width of each of its wheel ruts
const FRAYS := 4.0  # spots that are bare or low, for a metre of a frayed border
const SHORE := 16.0  # metres, side of the squares of which each is in a lake or not
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
	_paint_track()


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


## Wears a path into all fields that it leads through.
func wear(trail: Trail) -> void:
	for each in fields:
		trail.wear(each.map, _area_of(each))


## Frays the border of the grass around a square with the side `inner`, which would be a straight line: spots are bare, and it slopes down.
func fray(inner: float) -> void:
	var random := RandomNumberGenerator.new()
	var bare := GrassBrush.new()
	bare.tool = GrassBrush.TOOL_ERASE
	bare.strength = 1.0
	bare.hardness = 0.4
	var low := GrassBrush.new()
	low.tool = GrassBrush.TOOL_HEIGHT
	low.target = 0.3
	low.strength = 0.3
	low.hardness = 0.0
	for i in roundi(FRAYS * 4.0 * inner):
		var out := 0.5 * inner + absf(random.randfn(0.0, 0.6))
		var place := Vector2(out, random.randf_range(-0.5, 0.5) * inner).rotated(0.5 * PI * (i % 4))
		var brush: GrassBrush = low if i % 8 < 4 else bare
		brush.radius = random.randf_range(2.0, 4.0) if brush == low else random.randf_range(0.2, 0.7)
		for each in fields:
			var area := _area_of(each)
			if area.grow(brush.radius).has_point(place):
				each.map.stroke(brush, place - area.get_center(), place - area.get_center())


## Lets no grass grow where the ground is lower than a lake's surface.
func flood(level: float, hills: Hills) -> void:
	var brush := GrassBrush.new()
	brush.tool = GrassBrush.TOOL_ERASE
	brush.strength = 1.0
	brush.hardness = 1.0
	brush.radius = 0.75 * SHORE  # the strokes of squares beside each other overlap
	brush.height_max = level
	for each in fields:
		var area := _area_of(each)
		for z in range(0, ceili(area.size.y), int(SHORE)):
			for x in range(0, ceili(area.size.x), int(SHORE)):
				var square := Rect2(area.position + Vector2(x, z), Vector2.ONE * SHORE)
				if hills.lowest_in(square) < level:
					var middle := square.get_center() - area.get_center()
					each.map.stroke(brush, middle, middle)


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


func _area_of(of: GrassField) -> Rect2:
	return Rect2(Vector2(of.position.x, of.position.z) - 0.5 * of.size, of.size)


## A dirt track around the place where the walk begins: bare in its wheel ruts, low beside them.
func _paint_track() -> void:
	var verge := GrassBrush.new()
	verge.tool = GrassBrush.TOOL_HEIGHT
	verge.target = 0.45
	verge.strength = 1.0
	verge.radius = 2.6
	verge.hardness = 0.3
	var middle := _round(TRACK)
	for i in range(1, middle.size()):
		field.map.stroke(verge, middle[i - 1], middle[i])
	for off: float in [-0.85, 0.85]:
		var rut := Trail.new()
		rut.width = RUTS
		rut.points = _round(TRACK + off)
		rut.wear(field.map, _area_of(field))


## Points of the track, as far apart as those of a path.
func _round(radius: float) -> PackedVector2Array:
	var points := PackedVector2Array()
	var count := int(TAU * radius / Trail.STEP)
	for i in count + 1:
		var angle := TAU * i / count
		points.append(Vector2.from_angle(angle) * radius * (1.0 + 0.12 * sin(3.0 * angle)))
	return points
