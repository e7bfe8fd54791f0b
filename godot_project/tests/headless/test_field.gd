# SPDX-License-Identifier: MIT
## A field at rest: what grows from the node alone, what it is made from, and what it costs.
extends "res://tests/field_case.gd"


func test_tiles_are_known_before_the_first_tick() -> void:
	var field := add_field({size = Vector2(8, 8)})
	var tile := field.get_tile_at(Vector3(1.3, 0, -2.1))
	var centre := field.get_tile_center(tile)
	await ticks(2)
	assert_eq(field.get_tile_at(Vector3(1.3, 0, -2.1)), tile)
	assert_eq(field.get_tile_center(tile), centre)
	assert_near(centre, Vector3(1.3, 0, -2.1), 0.5)


func test_grows_from_nothing_but_the_node() -> void:
	var field := GrassField.new()
	add_child(field)
	await ticks(2)
	assert_eq(field.size, Vector2(32, 32), "size by default")
	assert_eq(field.get_grid_size(), Vector2i(64, 64))
	assert_near(field.get_tile_size(), 0.5, 1e-6)
	assert_eq(field.get_blade_count(), 64 * 64 * 64)
	assert_eq(field.get_awake_tile_count(), 0)
	assert_greater(field.get_memory_usage(), 16384 * 16 * 8, "at least the patch")
	assert_eq(field.get_statistics().backend, "CPU")


func test_blades_have_sixteen_knots_beyond_a_short_clamp_equally_apart() -> void:
	var field := add_field()
	await ticks(2)
	for tile: Vector2i in [Vector2i(0, 0), Vector2i(3, 5), Vector2i(7, 7)]:
		for blade in BLADES:
			var knots := field.get_knots(tile, blade)
			if not assert_eq(knots.size(), KNOTS):
				return
			var length := knots[0].distance_to(knots[1]) / CLAMP_SHARE
			assert_greater(length, 0.1, "length of a blade")
			assert_less(length, 1.0, "length of a blade")
			var segment := length * (1.0 - CLAMP_SHARE) / 14
			for k in range(2, KNOTS):
				assert_near(knots[k - 1].distance_to(knots[k]), segment, 0.01 * segment, "segment %d of %s %d" % [k, tile, blade])


func test_blades_stand_on_the_ground_in_their_tile() -> void:
	var field := add_field()
	await ticks(2)
	var places := {}
	for tile: Vector2i in [Vector2i(0, 0), Vector2i(7, 0), Vector2i(4, 3)]:
		var center := field.get_tile_center(tile)
		for blade in BLADES:
			var knots := field.get_knots(tile, blade)
			var root := knots[0] - center
			assert_near(root.y, 0.0, 1e-6, "height of a root")
			assert_less(maxf(absf(root.x), absf(root.z)), 0.2501, "root outside of its tile")
			assert_greater(knots[1].y, knots[0].y, "the second knot is above the root")
			assert_greater(knots[15].y, 0.0, "a tip in the ground")
			assert_eq(field.get_tile_at(knots[0].move_toward(center, 1e-5)), tile)
			places[knots[0]] = true
	assert_greater(places.size(), 3 * BLADES - 3, "roots at different places")


func test_same_seed_same_grass() -> void:
	var first := add_field({seed = 7})
	var second := add_field({seed = 7})
	var other := add_field({seed = 8})
	await ticks(2)
	var differing := 0
	for tile: Vector2i in [Vector2i(0, 0), Vector2i(1, 0), Vector2i(0, 1), Vector2i(5, 6)]:
		assert_eq(tile_knots(first, tile), tile_knots(second, tile))
		differing += int(tile_knots(first, tile) != tile_knots(other, tile))
	assert_greater(differing, 2, "tiles that another seed changes")
	assert_ne(tile_knots(first, Vector2i(0, 0)), tile_knots(first, Vector2i(1, 0)), "neighbours differ")


func test_memory_hardly_grows_with_the_area() -> void:
	var small := add_field({size = Vector2(16, 16)})
	var large := add_field({size = Vector2(512, 512)})
	await ticks(2)
	assert_eq(large.get_blade_count(), 1024 * 1024 * 64)
	var a_tile := float(large.get_memory_usage() - small.get_memory_usage()) / (1024 * 1024 - 32 * 32)
	assert_less(a_tile, 8.0, "bytes a tile")


func test_patch_changes_rebuild_the_field() -> void:
	var patch := GrassPatch.new()
	var field := add_field({species = kind({patch = patch})})
	await ticks(2)
	var before := tile_knots(field, Vector2i.ZERO)
	var makings: int = field.get_counters().makings
	patch.length_min = 0.1
	patch.length_max = 0.1
	await made(field, makings + 1)
	var after := tile_knots(field, Vector2i.ZERO)
	assert_ne(after, before)
	for blade in BLADES:
		var length := after[blade * KNOTS].distance_to(after[blade * KNOTS + 1]) / CLAMP_SHARE
		assert_less(length, 0.1 * 1.3 + 1e-3, "length after the change, clump included")
	patch.seed = 99
	await made(field, makings + 2)
	assert_ne(tile_knots(field, Vector2i.ZERO), after, "another patch seed")
	field.species[0].patch = null
	await made(field, makings + 3)
	assert_eq(tile_knots(field, Vector2i.ZERO), before, "the default patch again")


func test_patch_is_shared_and_told_apart() -> void:
	var patch := GrassPatch.new()
	var with_patch := add_field({species = kind({patch = patch})})
	var without := add_field()
	await ticks(2)
	assert_eq(tile_knots(with_patch, Vector2i.ZERO), tile_knots(without, Vector2i.ZERO), "an untouched patch is the default one")
	with_patch.free()
	patch.seed = 5  # no field listens any more
	await ticks(2)
	assert_greater(without.get_blade_count(), 0)


func test_empty_patch_warns_and_grows_nothing() -> void:
	expect_error("No grass grows")
	var patch := GrassPatch.new()
	for type: String in ["upright", "arched", "drooping", "wavy"]:
		patch.set("weight_" + type, 0.0)
	var field := add_field({species = kind({patch = patch})})
	var body := add_held_body(ball(0.2), Vector3(0, 0.2, 0))
	await ticks(5)
	assert_eq(field.get_blade_count(), 0)
	assert_eq(field.get_awake_tile_count(), 0)
	patch.weight_wavy = 1.0
	await seen()
	assert_greater(field.get_blade_count(), 0)
	assert_greater(field.get_awake_tile_count(), 0, "it lives again, with the body in it")
	body.free()


func test_asking_for_what_is_not_there() -> void:
	var field := GrassField.new()
	expect_error("no blades yet")
	assert_eq(field.get_knots(Vector2i.ZERO, 0).size(), 0)
	expect_error("add the node to the scene tree")
	assert_eq(field.get_tile_at(Vector3.ZERO), Vector2i(-1, -1))
	assert_eq(field.get_blade_count(), 0)
	assert_eq(field.get_statistics().backend, "none")
	add_child(field)
	await ticks(2)
	expect_error("no such tile")
	assert_eq(field.get_knots(Vector2i(64, 0), 0).size(), 0)
	expect_error("64 blades")
	assert_eq(field.get_knots(Vector2i.ZERO, 64).size(), 0)
	assert_eq(field.get_knots(Vector2i.ZERO, -1).size(), 0)
	assert_false(field.is_tile_awake(Vector2i(-1, 1000)))
	assert_eq(field.get_tile_at(Vector3(NAN, 0, INF)), Vector2i(-1, -1))
	assert_eq(field.get_tile_at(Vector3(16.01, 0, 0)), Vector2i(-1, -1))
	assert_eq(field.get_tile_at(Vector3(15.99, 0, -15.99)), Vector2i(63, 0))


func test_knots_of_a_tile_are_those_of_its_blades() -> void:
	var field := add_field()
	add_held_body(ball(0.2), Vector3(0.25, 0.25, 0.25))
	await ticks(10)
	var awake := field.get_tile_at(Vector3(0.25, 0, 0.25))
	assert_true(field.is_tile_awake(awake))
	for tile: Vector2i in [Vector2i.ZERO, awake]:
		var knots := PackedVector3Array()
		for blade in BLADES:
			knots.append_array(field.get_knots(tile, blade))
		assert_eq(field.get_tile_knots(tile), knots)
	expect_error("there is no such tile")
	assert_eq(field.get_tile_knots(Vector2i(-1, 0)).size(), 0)
