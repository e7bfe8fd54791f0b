# SPDX-License-Identifier: MIT
## Queries of scripts about blades on the GPU: answered at once from what was read back, at most two ticks old, or exactly by a call that
## waits. Ages are counted in steps of the simulation.
extends "res://tests/parity_case.gd"

const OLDEST := 2  # steps

var _tile: Vector2i
var _knots_after: Dictionary[int, PackedVector3Array] = {}  # of the CPU's field, which is never late: by step


## Adds a pair of fields whose blades have just been let go, and swing.
func add_swinging_pair(asks := true) -> bool:
	if not await add_pair({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 30.0}):
		return false
	_tile = gpu.get_tile_at(PLACE)
	var body := add_held_body(ball(0.3), PLACE + Vector3(0.35, 0.15, 0.0))
	for i in 5:
		if asks:
			gpu.get_tile_knots(_tile)
		await ticks(1)
	body.free()
	return true


func remember() -> void:
	assert_eq(gpu.get_counters().steps, cpu.get_counters().steps)
	_knots_after[int(cpu.get_counters().steps)] = tile_knots(cpu, _tile)


## Returns the step of the CPU's field after which its blades were nearest to `knots`.
func step_of(knots: PackedVector3Array) -> int:
	var nearest := -1
	for step in _knots_after:
		if nearest < 0 or farthest(_knots_after[step], knots) < farthest(_knots_after[nearest], knots):
			nearest = step
	return nearest


## What the GPU's field tells is the truth of as many steps ago as it says. Returns that number.
func check_age(knots: PackedVector3Array) -> int:
	var now := gpu.get_counters()
	assert_eq(step_of(knots), int(now.steps - now.knots_age), "the step that the answer is of")
	assert_less(now.knots_age, OLDEST + 1)
	return now.knots_age


func test_answers_are_two_ticks_old_at_most_and_nobody_waits() -> void:
	if not await add_swinging_pair():
		return
	var ages := {}
	for i in 20:
		remember()
		if i >= OLDEST:
			ages[check_age(gpu.get_tile_knots(_tile))] = true  # before the tick
		await get_tree().process_frame
		remember()
		if i >= OLDEST:
			ages[check_age(gpu.get_tile_knots(_tile))] = true  # after it
		await ticks(1)
	var statistics := gpu.get_counters()
	print("    ages of answers, ticks: %s" % [ages.keys()])
	assert_eq(statistics.knot_waits, 0)
	assert_greater(statistics.knots_read, 20 * BLADES - 1)
	assert_eq(cpu.get_counters().knots_age, 0)
	assert_eq(cpu.get_counters().knots_read, 0)


func test_one_blade_is_told_as_its_tile_is() -> void:
	if not await add_swinging_pair():
		return
	await ticks(3)
	var knots := gpu.get_tile_knots(_tile)
	assert_greater(farthest(knots, gpu.get_tile_knots(Vector2i.ZERO)), 1.0, "metres from the first tile")
	var blades := gpu.get_tile_blades(_tile)
	for blade: int in [0, 17, 63]:
		assert_eq(gpu.get_knots(_tile, blade), blade_of(knots, blade))
	assert_eq(gpu.get_blade_knots([blades[40], blades[3]]), blade_of(knots, 40) + blade_of(knots, 3))
	assert_eq(gpu.get_counters().knot_waits, 0)


func test_the_first_answer_is_the_rest_pose() -> void:
	gpu = add_field()
	await ticks(2)
	await compiled(gpu)
	_tile = gpu.get_tile_at(PLACE)
	var rest := tile_knots(gpu, _tile)
	add_held_body(ball(0.2), PLACE)
	await ticks(10)
	assert_eq(gpu.get_counters().knots_read, 0, "nobody asked, so nothing is read back")
	assert_eq(gpu.get_tile_knots(_tile), rest)
	await ticks(3)
	assert_greater(farthest(gpu.get_tile_knots(_tile), rest), 0.05, "metres: bent")
	assert_eq(gpu.get_counters().knot_waits, 0)


func test_who_asks_all_the_time_sees_a_tile_wake() -> void:
	if not await add_pair():
		return
	_tile = gpu.get_tile_at(PLACE)
	for i in 5:
		gpu.get_tile_knots(_tile)
		await ticks(1)
	assert_eq(gpu.get_counters().knots_read, 0, "it is at rest")
	var body := add_held_body(ball(0.2), PLACE + Vector3(-0.6, 0.0, 0.0))
	_knots_after[0] = tile_knots(cpu, _tile)
	for i in 20:
		body.position.x += 0.03
		await ticks(1)
		remember()
		var now := gpu.get_counters()
		var off := farthest(_knots_after[maxi(0, now.steps - OLDEST)], _knots_after[int(now.steps)])
		assert_less(farthest(gpu.get_tile_knots(_tile), _knots_after[int(now.steps)]), 2.0 * off + 0.02, "no farther off than two steps")
	assert_greater(gpu.get_counters().knots_read, 0)


func test_what_nobody_asks_for_any_more_is_not_read() -> void:
	if not await add_swinging_pair():
		return
	await ticks(70)  # more than KnotWatch::READS_KEPT
	var read: int = gpu.get_counters().knots_read
	assert_greater(read, 0)
	await ticks(5)
	assert_eq(gpu.get_counters().knots_read, read)


func test_waiting_is_exact() -> void:
	if not await add_swinging_pair(false):
		return
	var blades := gpu.get_tile_blades(_tile).slice(7, 9)
	blades.append(gpu.get_tile_blades(Vector2i.ZERO)[5])
	blades.append_array(gpu.get_tile_blades(_tile + Vector2i(1, 0)).slice(60, 62))
	for i in 5:
		var off := farthest(gpu.wait_for_knots(blades), cpu.wait_for_knots(blades))
		assert_less(off, 1e-3, "metres, of blades of three tiles")
		assert_eq(gpu.get_counters().knot_waits, i + 1, "one wait for all of them")
		await ticks(1)
	gpu.wait_for_knots(gpu.get_tile_blades(Vector2i.ZERO))
	assert_eq(gpu.get_counters().knot_waits, 5, "none for a tile at rest")
	assert_eq(gpu.get_counters().knots_read, 0)


func test_another_field_forgets_what_was_asked() -> void:
	if not await add_swinging_pair():
		return
	gpu.size = Vector2(6, 6)  # the same tile has other blades now
	await made(gpu, 2)
	var rest := tile_knots(gpu, _tile)
	for i in 4:
		assert_eq(gpu.get_tile_knots(_tile), rest)
		await ticks(1)
