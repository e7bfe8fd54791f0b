# SPDX-License-Identifier: MIT
## Every property of a field, of its patch, species, map and rule, changed at random in the same frames, with bodies in the grass.
## Pending changes must not be read by running work: `./grass test sanitize` runs this under the address sanitizer.
extends "res://tests/field_case.gd"

const SIDE := 16.0  # metres
const BALLS := 20
const EXTREMES := 0.3  # share of the numbers that are the least or the greatest allowed
## Larger values are allowed, but only cost time and memory here.
const CAPS := {"density": 900.0, "drawn_tiles_max": 4096.0, "size": 24.0}
const LEFT_ALONE := [
	"name",
	"script",
	"owner",
	"process_mode",
	"process_priority",
	"process_physics_priority",
	"unique_name_in_owner",
	"scene_file_path",
	"editor_description",
	"process_thread_group",
	"process_thread_group_order",
	"process_thread_messages",
	"physics_interpolation_mode",
	"auto_translate_mode",
	"material_override",
	"material_overlay",
	"visibility_parent"
]

var rng := RandomNumberGenerator.new()


func add_balls() -> Array[AnimatableBody3D]:
	var balls: Array[AnimatableBody3D] = []
	for i in BALLS:
		balls.append(add_held_body(ball(0.6), Vector3(3.0 * (i % 5) - 6.0, 0.3, 3.5 * floorf(i / 5.0) - 5.0)))
	return balls


func own_patch() -> GrassPatch:
	var patch := GrassPatch.new()
	patch.length_max = 0.4
	return patch


## Returns a random value for a property of get_property_list(); null if there is none to choose.
func value_for(property: Dictionary, now: Variant) -> Variant:
	match property.type:
		TYPE_BOOL:
			return rng.randf() < 0.5
		TYPE_INT, TYPE_FLOAT:
			var number := number_for(property)
			return int(number) if property.type == TYPE_INT else number
		TYPE_COLOR:
			return Color(rng.randf(), rng.randf(), rng.randf())
		TYPE_VECTOR2:
			return Vector2(rng.randf_range(1.0, CAPS.size), rng.randf_range(1.0, CAPS.size))
		TYPE_VECTOR3:
			return now + Vector3(rng.randf_range(-0.5, 0.5), rng.randf_range(-0.1, 0.1), rng.randf_range(-0.5, 0.5))
		TYPE_OBJECT:
			return null if rng.randf() < 0.3 else resource_for(property.hint_string)
		TYPE_ARRAY:
			var species: Array[GrassSpecies] = []
			for i in rng.randi_range(0, 3):
				species.append(resource_for("GrassSpecies"))
			return species
	return null


func number_for(property: Dictionary) -> float:
	if property.hint == PROPERTY_HINT_ENUM:
		return rng.randi_range(0, property.hint_string.count(","))
	if property.hint != PROPERTY_HINT_RANGE:
		return rng.randi_range(0, 5)
	var parts: PackedStringArray = property.hint_string.split(",")
	var low := parts[0].to_float()
	var high := minf(parts[1].to_float(), CAPS.get(property.name, INF))
	if rng.randf() < EXTREMES:
		return low if rng.randf() < 0.5 else high
	return lerpf(low, high, pow(rng.randf(), 3.0))


func resource_for(type: String) -> Resource:
	match type:
		"GrassPatch":
			return own_patch()
		"GrassMap":
			return full_map()
		"GrassSpecies":
			var species := GrassSpecies.new()
			species.patch = own_patch() if rng.randf() < 0.5 else null
			return species
		"GrassFillRule":
			return GrassFillRule.new()
	return null


func stored(object: Object) -> Array[Dictionary]:
	return object.get_property_list().filter(
		func(p: Dictionary) -> bool: return p.usage & PROPERTY_USAGE_STORAGE and p.name not in LEFT_ALONE
	)


## Returns everything that may change, as [object, property].
func changes_of(field: GrassField) -> Array:
	var objects: Array[Object] = [field, field.map, field.fill_rule]
	for species: GrassSpecies in field.species:
		objects.append(species)
		objects.append(species.patch if species else null)
	var changes := []
	for object in objects:
		if object and is_instance_valid(object):
			for property in stored(object):
				if not property.name.begins_with("resource_"):
					changes.append([object, property])
	return changes


func shuffle(list: Array) -> void:  # by rng, so that a seed names a run
	for i in range(list.size() - 1, 0, -1):
		var other := rng.randi_range(0, i)
		var held: Variant = list[i]
		list[i] = list[other]
		list[other] = held


func change(field: GrassField, count: int) -> void:
	var changes := changes_of(field)
	shuffle(changes)
	for entry: Array in changes.slice(0, count):
		var value: Variant = value_for(entry[1], entry[0].get(entry[1].name))
		if value != null or entry[1].type == TYPE_OBJECT:
			entry[0].set(entry[1].name, value)
	if field.map and rng.randf() < 0.3:
		raise_ground(field.map)


func raise_ground(map: GrassMap) -> void:
	var heights := Image.create(2, 2, false, Image.FORMAT_RF)
	heights.fill(Color(rng.randf_range(-0.1, 0.1), 0, 0))
	map.set_ground(heights, Rect2(-2, -2, 4, 4))


## Checks that there is no NaN, and no more awake tiles than the pool has.
func check(field: GrassField, what: String) -> void:
	var now := field.get_statistics().merged(field.get_counters())
	assert_true(now.awake_tiles <= now.pool_tiles, "%s: %d awake tiles in a pool of %d" % [what, now.awake_tiles, now.pool_tiles])
	if now.backend == "none" or field.get_blade_count() == 0:
		return
	var tile := field.get_tile_at(field.to_global(Vector3(0.1, 0.0, 0.1)))
	if tile.x >= 0:
		var blades := field.get_tile_blades(tile)
		for knot in field.wait_for_knots([blades[0], blades[63]]) + field.get_knots(tile, 0):
			assert_true(knot.is_finite(), "%s: knot %s" % [what, knot])


func fuzz(seed_: int, rounds: int) -> void:
	rng.seed = seed_
	var field := add_field({size = Vector2(SIDE, SIDE), pool_tiles = 16, species = kind({patch = own_patch()})})
	var balls := add_balls()
	for i in rounds:
		change(field, [1, 3, 10, 1000][rng.randi_range(0, 3)])
		for body in balls:
			body.position += Vector3(rng.randf_range(-0.3, 0.3), 0.0, rng.randf_range(-0.3, 0.3))
		await ticks(rng.randi_range(0, 4))
		check(field, "seed %d, round %d" % [seed_, i])
	await frames(2)
