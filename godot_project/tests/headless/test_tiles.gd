# SPDX-License-Identifier: MIT
## Tiles wake under bodies and sleep after them, from a pool that may be too small, without a visible change.
extends "res://tests/field_case.gd"

const TILE := Vector2i(4, 4)
const PLACE := Vector3(0.25, 0.25, 0.25)  # above its middle
const SAME := 1e-3  # metres that nobody sees


func test_sleeps_two_seconds_and_a_settling_after_the_last_touch() -> void:
	var field := add_field({sleep_mode = GrassField.SLEEP_TIMER})
	assert_near(field.sleep_delay, 2.0, 0.0)
	var body := add_held_body(ball(0.2), PLACE)
	await ticks(200)
	assert_true(field.is_tile_awake(TILE), "as long as the body is there")
	body.free()
	assert_near(await ticks_to_sleep(field), 60 * (2.0 + field.settle_time), 5, "ticks in all")
	assert_eq(field.get_counters().evicted, 0)


func test_sleep_delay_and_settle_time_are_kept_to() -> void:
	var field := add_field({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 0.5, settle_time = 0.25})
	var body := add_held_body(ball(0.2), PLACE)
	await seen()
	body.free()
	assert_near(await ticks_to_sleep(field), 60 * 0.75, 5)
	body = add_held_body(ball(0.2), PLACE)
	await seen()
	field.sleep_delay = 1.0  # while it is awake
	field.settle_time = 0.0
	body.free()
	assert_near(await ticks_to_sleep(field), 60, 5)


func test_a_touch_keeps_awake_and_ends_the_settling() -> void:
	var field := add_field({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 0.2, settle_time = 1.0})
	var body := add_held_body(ball(0.2), PLACE)
	await seen()
	var woken: int = field.get_counters().woken
	body.position.y = 10.0
	await ticks(40)
	body.position = PLACE
	await ticks(80)  # longer than the settling
	assert_eq(field.get_counters().woken, woken, "it never slept in between")


func test_statistics_add_up() -> void:
	var field := add_field()
	var bodies: Array[Node] = []
	for i in 3:
		bodies.append(add_held_body(ball(0.15), Vector3(i - 1.0, 0.2, 0.1)))
	for i in 260:
		if i in [20, 60, 100]:
			bodies.pop_back().free()
		await ticks(1)
		var now := field.get_statistics().merged(field.get_counters())
		if not assert_eq(field.get_awake_tile_count(), now.awake_tiles, "tick %d" % i):
			return
		assert_eq(awake_tiles(field).size(), now.awake_tiles, "tick %d" % i)
	var end := field.get_counters()
	assert_greater(end.woken, 5)
	assert_eq(end.simulated_blades, end.tile_steps * BLADES)
	assert_greater(end.simulated_blades, end.steps * BLADES - 1)
	assert_less(end.simulated_blades, end.steps * BLADES * end.woken + 1)


func test_a_small_pool_gives_to_those_under_bodies() -> void:
	var field := add_field({pool_tiles = 4})
	var body := add_held_body(ball(0.05), Vector3(-1.25, 0.1, -1.25))
	await seen()
	assert_eq(field.get_awake_tile_count(), 4, "a blade reaches over its tile's edge, so a ball is in several")
	assert_true(field.is_tile_awake(field.get_tile_at(body.position)))
	body.position = Vector3(1.25, 0.1, 1.25)
	await ticks(10)
	assert_true(field.is_tile_awake(field.get_tile_at(body.position)), "the tile under the body has a slot")
	assert_eq(field.get_awake_tile_count(), 4)
	assert_greater(field.get_counters().evicted, 0)
	add_held_body(ball(0.05), Vector3(-1.25, 0.1, -1.25))
	await ticks(10)
	var now := field.get_statistics().merged(field.get_counters())
	assert_eq(field.get_awake_tile_count(), 4)
	assert_greater(now.refused + now.capped, 0, "wishes that the pool could not grant are counted")
	assert_true(all_finite(field, awake_tiles(field)))


func test_not_simulated_stands_still() -> void:
	var field := add_field({simulated = false})
	await ticks(2)
	var rest := tile_knots(field, TILE)
	add_held_body(ball(0.2), PLACE)
	await ticks(10)
	assert_eq(field.get_awake_tile_count(), 0)
	assert_eq(tile_knots(field, TILE), rest)
	assert_eq(field.get_counters().steps, 0)
	field.simulated = true
	await ticks(10)
	assert_greater(farthest(tile_knots(field, TILE), rest), 0.05, "switched on")
	field.simulated = false
	await ticks(2)
	assert_eq(tile_knots(field, TILE), rest, "switched off again")


func test_nothing_near_costs_nothing() -> void:
	var field := add_field()
	add_held_body(ball(0.2), Vector3(10, 0.25, 0))
	add_held_body(ball(0.2), Vector3(0, 5, 0))
	await ticks(60)
	var now := field.get_counters()
	assert_eq(now.steps, 0)
	assert_eq(now.simulated_blades, 0)
	assert_eq(now.woken, 0)


func test_steps_stop_when_all_sleep() -> void:
	var field := add_field({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 0.2, settle_time = 0.2})
	var body := add_held_body(ball(0.2), PLACE)
	await ticks(10)
	body.free()
	await ticks_to_sleep(field)
	await ticks(3)
	var steps: int = field.get_counters().steps
	await ticks(30)
	assert_eq(field.get_counters().steps, steps)


func test_waking_without_contact_moves_nothing() -> void:
	var field := add_field()
	await ticks(2)
	var all: Array[Vector2i] = []
	for x in 8:
		for z in 8:
			all.append(Vector2i(x, z))
	var rest := knots_of(field, all)
	var body := add_ball_above(field, TILE)
	var woken := false
	for i in 200:
		await ticks(1)
		if i == 60:
			body.free()
		woken = woken or field.get_awake_tile_count() > 0
		var off := farthest_of(field, rest)
		if not assert_less(off, SAME, "tick %d" % i):
			return
	assert_true(woken, "a tile was awake")


func test_settled_blades_are_at_rest_before_they_are_let_go() -> void:
	# Half a second, so that there is a long way to settle.
	var field := add_field({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 0.1, settle_time = 0.5})
	await ticks(2)
	var rest := tile_knots(field, TILE)
	var body := add_held_body(ball(0.2), PLACE)
	await ticks(30)
	assert_greater(farthest(tile_knots(field, TILE), rest), 0.05)
	body.free()
	var last := PackedVector3Array()
	var step := INF  # metres in the last tick
	while field.is_tile_awake(TILE):
		var now := tile_knots(field, TILE)
		step = farthest(now, last)
		last = now
		await ticks(1)
	print("    settling: the last step moves blades by %.1f mm" % (1e3 * step))
	assert_less(step, 0.01, "there is no jerk at the end")
	assert_less(farthest(last, rest), SAME, "the last simulated pose")


func test_rises_again_after_a_ball_rolled_through() -> void:
	var field := add_field()
	await ticks(2)
	var path: Array[Vector2i] = [Vector2i(2, 4), Vector2i(3, 4), Vector2i(4, 4), Vector2i(5, 4)]
	var rest := knots_of(field, path)
	var body := add_held_body(ball(0.2), Vector3(-3, 0.2, 0.2))
	var bent := 0.0
	for i in 120:
		body.position.x += 0.05
		body.rotation.z -= 0.25
		await ticks(1)
		if i % 20 == 0:
			bent = maxf(bent, farthest_of(field, rest))
	assert_greater(bent, 0.1)
	body.free()
	var way := INF  # metres from rest, the last time that a tile was simulated
	for i in 1200:
		if field.get_awake_tile_count() == 0:
			break
		way = farthest_of(field, rest)
		await ticks(1)
	assert_eq(field.get_awake_tile_count(), 0)
	assert_less(way, SAME)


func test_rises_by_itself_before_it_is_settled() -> void:
	var field := add_field({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 10.0})
	await ticks(2)
	var rest := tile_knots(field, TILE)
	var body := add_held_body(ball(0.2), PLACE)
	await ticks(30)
	var bent := farthest(tile_knots(field, TILE), rest)
	body.free()
	await ticks(240)
	assert_true(field.is_tile_awake(TILE))
	assert_less(farthest(tile_knots(field, TILE), rest), 0.02 * bent, "share of the bend left after four seconds")
