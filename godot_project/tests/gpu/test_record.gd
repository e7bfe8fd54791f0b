# SPDX-License-Identifier: MIT
## A record of a field on a GPU has no hashes, and its blades are moved again all the same.
extends "res://tests/field_case.gd"

var path := "user://grass_gpu_%d.grassrecord" % OS.get_process_id()


func after() -> void:
	DirAccess.remove_absolute(path)


func test_a_record_moves_the_blades_again() -> void:
	var field := add_field({size = Vector2(6, 6)})
	await compiled(field)
	assert_eq(field.record(path), OK)
	var body := add_held_body(ball(0.25), Vector3(-2, 0.25, 0))
	for i in 60:
		body.position.x = -2 + i / 16.0
		await ticks(1)
	var recorded := field.get_record_state().ticks as int
	var knots := knots_of(field, awake_tiles(field))
	assert_greater(knots.size(), 4, "tiles")
	field.free()
	body.free()
	field = add_field()
	assert_eq(field.play_record(path), OK)
	while field.get_record_state().mode == "playing" and field.get_record_state().ticks < recorded:
		await ticks(1)
	var state := field.get_record_state()
	assert_eq(state.backend, "GPU")
	assert_eq(state.compared, 0)
	assert_eq(field.get_statistics().backend, "GPU")
	var again := knots_of(field, awake_tiles(field))
	assert_eq(again.keys(), knots.keys())
	for tile in knots:
		assert_eq(again[tile], knots[tile], "tile %s" % tile)
