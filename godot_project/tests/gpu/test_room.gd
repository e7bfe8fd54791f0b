# SPDX-License-Identifier: MIT
## Slots on the device: few are made when tiles wake, many beside the frames.
extends "res://tests/view_case.gd"

const QUICK := {sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 0.1, settle_time = 0.1}
const AT_ONCE := 256  # slots
const MIDDLE := Vector2i(16, 16)  # a tile below the lid

var at_rest: PackedVector3Array  # the knots of that tile


## A field with a lid on more of its tiles than get slots at once.
func cover(properties := {}) -> Array[Node3D]:
	var field := add_seen_field({size = Vector2(16, 16), pool_tiles = 1024}.merged(QUICK).merged(properties))
	await compiled(field)
	await ticks(1)
	at_rest = tile_knots(field, MIDDLE)
	var lid := AnimatableBody3D.new()
	add_shape(lid, box(Vector3(11, 0.2, 11)))
	lid.position.y = 0.2
	viewport.add_child(lid)
	return [field, lid]


func slots_of(field: GrassField) -> int:
	return field.get_counters().pool_slots


func test_many_slots_come_beside_the_frames_and_go_again() -> void:
	var nodes := await cover()
	var field: GrassField = nodes[0]
	await wait_until(func() -> bool: return field.get_awake_tile_count() > 0, "awake tiles", true)
	assert_eq(slots_of(field), AT_ONCE, "in the first tick")
	assert_eq(field.get_awake_tile_count(), AT_ONCE)
	await wait_until(func() -> bool: return slots_of(field) > AT_ONCE, "slots", true)
	assert_eq(slots_of(field), 1024, "at one go")
	assert_greater(field.get_awake_tile_count(), 400)
	assert_eq(field.get_counters().evicted, 0)
	assert_eq(field.get_counters().woken, field.get_awake_tile_count())
	await ticks(5)
	for tile in awake_tiles(field).slice(0, 600, 100):
		assert_true(all_finite(field, [tile]), "%s" % tile)
	assert_greater(farthest(tile_knots(field, MIDDLE), at_rest), 0.02, "it is pressed")
	nodes[1].free()
	await wait_until(func() -> bool: return slots_of(field) == 0, "no slots", true)


func test_a_replay_finds_its_slots_in_the_first_tick() -> void:
	var field: GrassField = (await cover({simulation_detail = GrassField.SIMULATION_WHOLE}))[0]
	await wait_until(func() -> bool: return field.get_awake_tile_count() > 0, "awake tiles", true)
	assert_greater(field.get_awake_tile_count(), 400)
	assert_eq(slots_of(field), 1024)


## Slots that are still being made when their field goes, or becomes another one, go with it.
func test_slots_that_nobody_takes_are_freed() -> void:
	await frames(5)
	var before := 0.0
	for turn in 4:
		var nodes := await cover()
		await wait_until(func() -> bool: return slots_of(nodes[0]) > 0, "slots", true)
		if turn % 2:
			nodes[0].method = GrassField.METHOD_PBD
			await ticks(2)
		for node in nodes:
			node.free()
		await frames(8)
		if turn == 1:
			before = Performance.get_monitor(Performance.RENDER_VIDEO_MEM_USED)
	assert_less(Performance.get_monitor(Performance.RENDER_VIDEO_MEM_USED) - before, 1e5, "bytes")
