# SPDX-License-Identifier: MIT
## A field with a map: grass grows, is short, is cut and follows hills as the map says. Only changes are sent on.
extends "res://tests/field_case.gd"

const SLOPE := 0.5  # metres up for each metre along x


func hill() -> GrassMap:
	var map := full_map()
	var heights := Image.create_empty(64, 64, false, Image.FORMAT_RF)
	for x in 64:
		for z in 64:
			heights.set_pixel(x, z, Color(SLOPE * (x - 31.5), 0, 0))
	assert_true(map.set_ground(heights, Rect2(-32, -32, 64, 64)))
	return map


func longest(field: GrassField, tile: Vector2i) -> float:
	var knots := tile_knots(field, tile)
	var most := 0.0
	for blade in BLADES:
		most = maxf(most, length_of(knots, blade))
	return most


func test_nothing_grows_where_nobody_painted() -> void:
	var field := add_field({map = GrassMap.new()})
	await seen()
	assert_eq(field.get_counters().bare_tiles, 64)
	var body := add_held_body(ball(0.2), Vector3(0.25, 0.2, 0.25))
	await seen()
	assert_eq(field.get_awake_tile_count(), 0, "nothing there to bend")
	field.map.stroke(brush(GrassBrush.TOOL_PAINT, 1.0), Vector2(1, 1), Vector2(1, 1))
	await seen()
	assert_greater(field.get_awake_tile_count(), 0, "grass that was painted under a body")
	assert_less(field.get_counters().bare_tiles, 64)
	body.position.x = -1.5
	await ticks(1)
	assert_false(field.is_tile_awake(field.get_tile_at(Vector3(-1.5, 0, 0.25))), "still bare")


func test_a_cut_lasts_through_bending_and_sleep() -> void:
	var field := add_field({map = full_map(), sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 0.1, settle_time = 0.1})
	await seen()
	var tile := Vector2i(4, 4)
	assert_greater(longest(field, tile), 0.3)
	field.map.stroke(brush(GrassBrush.TOOL_CUT, 2.0, {cut_height = 0.1}), Vector2.ZERO, Vector2.ZERO)
	await seen()
	assert_near(longest(field, tile), 0.1, 0.005, "at rest")
	var rest := tile_knots(field, tile)
	assert_eq(await bend_with_ball(field, Vector3(0.25, 0.3, 0.25)), 0.0, "the ball floats over the stubble")
	assert_greater(await bend_with_ball(field, Vector3(0.25, 0.15, 0.25)), 0.01)
	assert_true(field.is_tile_awake(tile))
	assert_near(longest(field, tile), 0.1, 0.005, "awake")
	await ticks(30)
	assert_eq(field.get_awake_tile_count(), 0)
	assert_eq(tile_knots(field, tile), rest, "asleep again")


func test_grass_is_cut_while_a_body_bends_it() -> void:
	var field := add_field({map = full_map()})
	var body := add_held_body(ball(0.2), Vector3(0.25, 0.25, 0.25))
	await ticks(10)
	var tile := Vector2i(4, 4)
	assert_true(field.is_tile_awake(tile))
	field.map.stroke(brush(GrassBrush.TOOL_CUT, 2.0, {cut_height = 0.0}), Vector2.ZERO, Vector2.ZERO)
	await ticks(10)
	assert_less(longest(field, tile), 0.03, "stubble")
	assert_true(all_finite(field, awake_tiles(field)))
	field.map.stroke(brush(GrassBrush.TOOL_REGROW, 2.0, {cut_height = 2.55}), Vector2.ZERO, Vector2.ZERO)
	await ticks(30)
	assert_greater(longest(field, tile), 0.3, "grown again")
	assert_true(all_finite(field, awake_tiles(field)))
	body.free()


func test_roots_stand_on_the_hill() -> void:
	var field := add_field({map = hill(), size = Vector2(16, 16)})
	await seen()
	for x: int in [0, 5, 16, 31]:
		for blade: int in [0, 30, 63]:
			var root := field.get_knots(Vector2i(x, 7), blade)[0]
			assert_near(root.y, SLOPE * root.x, 0.01, "tile %d, blade %d" % [x, blade])


func test_blades_follow_the_slope_as_told() -> void:
	var leans: Array[float] = []
	for follow: float in [0.0, 1.0]:
		var field := add_field({map = hill(), follow_slope = follow})
		await seen()
		var knots := tile_knots(field, Vector2i(3, 3))
		var lean := Vector3.ZERO
		for blade in BLADES:
			lean += knots[blade * KNOTS + 3] - knots[blade * KNOTS]
		leans.append(rad_to_deg(atan2(-lean.x, lean.y)))
		field.free()
	print("    blades of one tile lean by %.1f and %.1f degrees" % leans)
	assert_near(leans[1] - leans[0], rad_to_deg(atan(SLOPE)), 4.0)


func test_a_ball_rolls_down_the_hill_through_grass() -> void:
	var field := add_field({map = hill(), size = Vector2(24, 6), pool_tiles = 512})
	var slope := StaticBody3D.new()
	add_body(slope, box(Vector3(60, 1, 20)), Vector3.ZERO)
	slope.rotation.z = atan(SLOPE)
	slope.position = slope.basis.y * -0.5
	var roller := RigidBody3D.new()
	add_body(roller, ball(0.3), Vector3(6, SLOPE * 6 + 0.4, 0))
	var woken := {}
	for i in 120:
		await ticks(1)
		for tile in awake_tiles(field):
			woken[tile.x] = true
	assert_less(roller.position.x, 3.0, "it rolls")
	var first := field.get_tile_at(Vector3(6, 0, 0)).x
	var last := field.get_tile_at(roller.position).x
	for x in range(last, first + 1):
		assert_true(woken.has(x), "column %d woke" % x)
	assert_false(woken.has(0), "nothing far from it")
	assert_true(all_finite(field, awake_tiles(field)))


func test_two_fields_share_a_map_and_it_can_be_changed_for_another() -> void:
	var map := full_map()
	var one := add_field({map = map})
	var two := add_field({map = map, position = Vector3(10, 0, 0)})
	await seen()
	map.stroke(brush(GrassBrush.TOOL_ERASE, 1.5), Vector2.ZERO, Vector2.ZERO)
	await seen()
	var bare: int = one.get_counters().bare_tiles
	assert_greater(bare, 3)
	assert_eq(two.get_counters().bare_tiles, bare)
	two.map = null
	await grown(two)
	assert_eq(two.get_counters().bare_tiles, 0)
	map.stroke(brush(GrassBrush.TOOL_ERASE, 1.9), Vector2.ZERO, Vector2.ZERO)
	await seen()
	assert_greater(one.get_counters().bare_tiles, bare)
	assert_eq(two.get_counters().bare_tiles, 0, "no longer its map")
	one.free()
	map.clear()  # nobody listens
	two.map = full_map()
	two.map.base_density = 0.0
	await seen()
	assert_eq(two.get_counters().bare_tiles, 64)


func test_only_chunks_that_changed_travel() -> void:
	var field := add_field({map = full_map(), size = Vector2(200, 200)})
	var rule := brush(GrassBrush.TOOL_HEIGHT, 30.0, {target = 0.5})
	for place in [Vector2(-60, -60), Vector2(60, -60), Vector2(-60, 60), Vector2(60, 60)]:
		field.map.stroke(rule, place, place)
	await seen()
	var all: int = field.get_counters().map_bytes
	await ticks(20)
	assert_eq(field.get_counters().map_bytes, all, "nothing changed")
	field.map.stroke(brush(GrassBrush.TOOL_ERASE, 2.5), Vector2(-30, -30), Vector2(-30, -30))
	await seen()
	var chunk: int = field.get_counters().map_bytes - all
	print("    a stroke of 5 m uploads %d KiB, the map had %d KiB" % [chunk / 1024, all / 1024])
	assert_eq(chunk, 4 * (130 * 130 + 3 * 66 * 66))


func test_a_map_that_is_broken_leaves_no_grass_and_no_crash() -> void:
	var map := GrassMap.new()
	expect_error("data")
	map.data = PackedByteArray([1, 2, 3])
	var field := add_field({map = map})
	await seen()
	assert_eq(field.get_counters().bare_tiles, 64)
