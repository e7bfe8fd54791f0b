# SPDX-License-Identifier: MIT
## The properties in the inspector: what they set, and what happens to invalid numbers.
extends "res://tests/field_case.gd"

const UNITS: Dictionary[String, String] = {
	size = "m",
	density = "/m²",
	clump_size = "m",
	border_fade = "m",
	sleep_motion = "mm",
	sleep_delay = "s",
	settle_time = "s",
	wind_speed = "m/s",
	wind_direction = "°",
	lod_far = "m",
	lod_error = "px",
	shadow_distance = "m",
	shadow_margin = "m",
}
const BAD: Array[float] = [NAN, INF, -INF, 0.0, -1.0, 1e30]
const GROUPS: Array[String] = ["Field", "Map", "Clumps", "Simulation", "Wind", "Look", "Surface", "Level of Detail", "Debug"]


## Returns the properties of the class itself that are stored in a scene.
func properties_of(type: StringName) -> Array[Dictionary]:
	return ClassDB.class_get_property_list(type, true).filter(
		func(property: Dictionary) -> bool: return property.usage & PROPERTY_USAGE_STORAGE
	)


## Returns the numbers with a range: name -> [least, greatest].
func ranges_of(type: StringName) -> Dictionary[String, PackedFloat64Array]:
	var ranges: Dictionary[String, PackedFloat64Array] = {}
	for property in properties_of(type):
		if property.hint == PROPERTY_HINT_RANGE:
			ranges[property.name] = property.hint_string.split_floats(",").slice(0, 2)
	return ranges


func test_properties_have_hints_units_and_groups() -> void:
	var found := {}
	for property in properties_of("GrassField"):
		found[property.name] = property
		if property.type == TYPE_FLOAT:
			assert_eq(property.hint, PROPERTY_HINT_RANGE, property.name)
	for property in UNITS:
		if assert_true(found.has(property), "no property " + property):
			assert_true(
				found[property].hint_string.ends_with("suffix:" + UNITS[property]), "%s: %s" % [property, found[property].hint_string]
			)
	for property: String in ["seed", "simulated", "collision_mask", "backend", "debug_view", "measure_time", "soil_color"]:
		assert_true(found.has(property), "no property " + property)
	assert_eq(found.collision_mask.hint, PROPERTY_HINT_LAYERS_3D_PHYSICS)
	var groups := (
		ClassDB
		. class_get_property_list("GrassField", true)
		. filter(func(property: Dictionary) -> bool: return property.usage & PROPERTY_USAGE_GROUP)
		. map(func(property: Dictionary) -> String: return property.name)
	)
	assert_eq(groups, GROUPS)


func test_every_number_is_kept() -> void:
	var field := add_field()
	var ranges := ranges_of("GrassField")
	assert_greater(ranges.size(), 25)
	for property in ranges:
		var limits := ranges[property]
		assert_true(field.get(property) >= limits[0] and field.get(property) <= limits[1], property + " by default within its range")
		for share: float in [0.0, 0.01, 1.0]:
			var value: Variant = type_convert(lerpf(limits[0], limits[1], share), typeof(field.get(property)))
			field.set(property, value)
			assert_near(field.get(property), value, 1e-6 * absf(value), property)
	field.free()  # at the end of every range it would be the largest field there can be


func test_the_rest_is_kept() -> void:
	var field := add_field()
	var values := {
		size = Vector2(3, 5.5),
		simulated = false,
		collision_mask = 0x80000001,
		backend = GrassField.BACKEND_CPU,
		debug_view = GrassField.DEBUG_VIEW_LOD,
		measure_time = true,
	}
	for property: String in values:
		field.set(property, values[property])
		assert_eq(field.get(property), values[property], property)
	await ticks(3)
	assert_eq(field.get_grid_size(), Vector2i(6, 11))


func test_bad_numbers_are_brought_within_limits_and_named() -> void:
	var field := add_field({size = Vector2(1, 1)})
	var ball_inside := add_held_body(ball(0.2), Vector3(0, 0.2, 0))
	await seen()
	var ranges := ranges_of("GrassField")
	for property in ranges:
		var good: Variant = field.get(property)
		expect_error("GrassField 'Meadow': `%s` cannot be" % property)
		for bad in BAD:
			field.set(property, bad)
			var kept: float = field.get(property)
			assert_true(kept >= ranges[property][0] and kept <= ranges[property][1], "%s = %s became %s" % [property, bad, kept])
			if property != "density":  # its extremes are tried below: that many blades take their time
				await ticks(1)
		field.set(property, good)
		await grown(field)  # on a busy machine some frames later, and its tiles wake in the tick after
		await ticks(2)
		if not assert_true(all_finite(field, awake_tiles(field)), property):
			return
	await seen()
	assert_greater(field.get_awake_tile_count(), 0, "the ball still bends grass")
	ball_inside.free()


func test_bad_sizes_and_densities_still_grow() -> void:
	expect_error("`size` cannot be")
	expect_error("`density` cannot be")
	add_held_body(ball(0.2), Vector3(0, 0.2, 0))
	for bad in BAD:
		var field := add_field({size = Vector2(bad, bad), density = bad})
		await seen()
		assert_greater(field.get_blade_count(), 0, "size and density %s" % bad)
		assert_greater(field.get_awake_tile_count(), 0, "size and density %s" % bad)
		assert_true(all_finite(field, [field.get_tile_at(Vector3.ZERO)]))
		field.free()


func test_bad_patches_still_grow() -> void:
	var patch := GrassPatch.new()
	var field := add_field({species = kind({patch = patch}), size = Vector2(1, 1)})
	var ranges := ranges_of("GrassPatch")
	assert_eq(ranges.size(), 9)
	for property in ranges:
		var good: Variant = patch.get(property)
		expect_error("GrassPatch: `%s` cannot be" % property)
		for bad in BAD:
			patch.set(property, bad)
			var kept: float = patch.get(property)
			assert_true(kept >= ranges[property][0] and kept <= ranges[property][1], "%s = %s became %s" % [property, bad, kept])
		await ticks(2)
		assert_greater(field.get_blade_count(), 0, property)
		assert_true(all_finite(field, [Vector2i.ZERO]), property)
		patch.set(property, good)


func test_enums_refuse_what_they_do_not_have() -> void:
	var field := add_field()
	for property: String in ["backend", "debug_view"]:
		expect_error("GrassField 'Meadow': `%s` must be" % property)
		for bad: int in [-1, 99]:
			field.set(property, bad)
			assert_eq(field.get(property), 0, property)


func test_copies_keep_the_properties() -> void:
	var patch := GrassPatch.new()
	patch.length_max = 0.4
	var field := add_field(
		{
			size = Vector2(2, 3),
			density = 400.0,
			seed = 5,
			species = kind({patch = patch, natural_frequency = 2.0, tip_color = Color.CORAL}),
			collision_mask = 6,
			simulated = false,
			wind_speed = 1.5,
			backend = GrassField.BACKEND_CPU
		}
	)
	var scene := PackedScene.new()
	assert_eq(scene.pack(field), OK)
	var copies: Array[GrassField] = [field.duplicate(), scene.instantiate()]
	for copy in copies:
		for property in properties_of("GrassField"):
			assert_eq(copy.get(property.name), field.get(property.name), property.name)
		add_child(copy)
	await ticks(2)
	var rest := tile_knots(field, Vector2i.ZERO)
	for copy in copies:
		assert_eq(tile_knots(copy, Vector2i.ZERO), rest)


func test_what_cannot_work_is_said() -> void:
	expect_error("`pool_tiles` is 0")
	expect_error("`collision_mask` is empty")
	expect_error("`ground_mask` is empty")
	expect_error("scale is ignored")
	expect_error("`simulation_budget` has no effect while")
	var budget := {simulation_budget = 1.0, simulation_detail = GrassField.SIMULATION_WHOLE}
	var field := add_field({pool_tiles = 0, collision_mask = 0, ground_mask = 0, scale = Vector3(2, 2, 2)}.merged(budget))
	var body := add_held_body(ball(0.2), Vector3(0, 0.2, 0))
	await ticks(5)
	assert_eq(field.get_awake_tile_count(), 0)
	field.collision_mask = 1
	await ticks(5)
	assert_eq(field.get_awake_tile_count(), 0, "without a pool nothing wakes")
	assert_greater(field.get_counters().capped, 0, "and a counter says so")
	body.free()


## What is a whole number is an int for scripts, and in a scene written before it was one.
func test_whole_numbers_are_ints() -> void:
	var field: GrassField = load("res://tests/fixtures/whole_numbers.tscn").instantiate()
	var whole := {
		field: {iterations = 3, drawn_tiles_max = 4096},
		field.species[0]: {card_pictures = 4, stems = 2},
	}
	for object: Object in whole:
		for property: String in whole[object]:
			var info := properties_of(object.get_class()).filter(func(known: Dictionary) -> bool: return known.name == property)
			assert_eq(info[0].type, TYPE_INT, property)
			assert_eq(info[0].hint, PROPERTY_HINT_RANGE, property)
			assert_eq(typeof(object.get(property)), TYPE_INT, property)
			assert_eq(object.get(property), whole[object][property], property + ": a float in the scene")
			object.set(property, whole[object][property] + 0.9)
			assert_eq(object.get(property), whole[object][property], property + ": a script's float")
	var sum: int = field.iterations + field.species[0].stems
	assert_eq(sum, 5, "typed code reads ints")
	field.free()
