# SPDX-License-Identifier: MIT
## Queries of scripts about blades: which exist, and where their knots are. tests/gpu/test_questions.gd queries a field that answers late.
extends "res://tests/field_case.gd"


func roots_of(knots: PackedVector3Array) -> PackedVector3Array:
	var roots := PackedVector3Array()
	for i in range(0, knots.size(), KNOTS):
		roots.append(knots[i])
	return roots


func test_many_blades_in_one_call() -> void:
	var field := add_field()
	add_held_body(ball(0.2), Vector3(0.25, 0.25, 0.25))
	await ticks(10)
	var awake := field.get_tile_at(Vector3(0.25, 0, 0.25))
	assert_true(field.is_tile_awake(awake))
	var blades := field.get_tile_blades(Vector2i(1, 0))
	blades.append_array(field.get_tile_blades(awake))
	var both := field.get_tile_knots(Vector2i(1, 0)) + field.get_tile_knots(awake)
	assert_eq(field.get_blade_knots(blades), both)
	assert_eq(field.wait_for_knots(blades), both, "the CPU's answers are exact")
	blades.reverse()
	assert_eq(field.get_blade_knots(blades).slice(0, KNOTS), field.get_knots(awake, 63))
	assert_eq(field.get_blade_knots([]).size(), 0)
	var counters := field.get_counters()
	for key: String in ["knot_waits", "knots_read", "knots_age"]:
		assert_eq(counters[key], 0, key)


func test_blades_around_a_place() -> void:
	var field := add_field()
	field.position = Vector3(3, 1, -2)
	field.rotation.y = 0.5
	await ticks(1)
	var place := field.to_global(Vector3(0.3, 2.0, 0.9))
	var expected := PackedInt64Array()
	var tiles := field.get_grid_size()
	for z in tiles.y:
		for x in tiles.x:
			var roots := roots_of(field.get_tile_knots(Vector2i(x, z)))
			for blade in BLADES:
				if Vector2(roots[blade].x - place.x, roots[blade].z - place.z).length() < 0.4:
					expected.append(field.get_tile_blades(Vector2i(x, z))[blade])
	assert_greater(expected.size(), 20)
	assert_eq(field.find_blades(place, 0.4), expected)
	assert_eq(field.find_blades(Vector3(100, 0, 0), 0.4).size(), 0, "outside of the field")
	expect_error("find_blades() needs a finite position, and a radius")
	for radius: float in [-1.0, NAN]:
		assert_eq(field.find_blades(place, radius).size(), 0)
	assert_eq(field.find_blades(place, INF).size(), int(field.get_blade_count()))


func test_only_blades_that_stand() -> void:
	var map := full_map()
	map.stroke(brush(GrassBrush.TOOL_ERASE, 0.8), Vector2.ZERO, Vector2.ZERO)
	var field := add_field({map = map})
	await grown(field)
	assert_eq(field.find_blades(Vector3.ZERO, 0.2).size(), 0, "where all are erased")
	var few: GrassMap = full_map()
	few.base_density = 0.5
	field.map = few
	await grown(field)
	var share := field.find_blades(Vector3.ZERO, 10.0).size() / float(field.get_blade_count())
	assert_near(share, 0.5, 0.12, "of the blades")


func test_a_border_that_fades_is_in_the_picture_only() -> void:
	var fields: Array[GrassField] = [add_field({border_fade = 0.0}), add_field({border_fade = 10.0})]
	await ticks(1)
	var tile := fields[0].get_tile_at(Vector3(1.9, 0, 0.25))
	var upright := fields[0].get_tile_knots(tile)
	add_held_body(ball(0.2), Vector3(1.9, 0.25, 0.25))
	await ticks(20)
	var answers := []
	for field in fields:
		var place := Vector3(1.95, 0, 0.4)
		answers.append([field.get_height_at(place), field.get_density_at(place), field.is_grass_at(place), field.find_blades(place, 0.3)])
		answers[-1].append(field.get_tile_knots(tile))
		assert_ne(answers[-1][-1], upright, "the body bends the blades")
	assert_eq(answers[0], answers[1])
	var makings: int = fields[0].get_counters().makings
	fields[0].border_fade = 5.0
	await ticks(2)
	assert_eq(fields[0].get_counters().makings, makings, "it is a number of the shaders")


func test_what_is_not_there() -> void:
	var field := add_field()
	await ticks(1)
	expect_error("there is no blade -1")
	assert_eq(field.get_blade_knots([-1]).size(), 0)
	expect_error("there is no blade 4096")
	assert_eq(field.wait_for_knots([0, 4096]).size(), 0)
	expect_error("there is no such tile")
	assert_eq(field.get_tile_blades(Vector2i(0, -1)).size(), 0)
	remove_child(field)
	expect_error("there are no blades yet")
	assert_eq(field.get_blade_knots([0]).size(), 0)
	field.free()
