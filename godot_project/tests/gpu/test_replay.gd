# SPDX-License-Identifier: MIT
## The same ticks twice on one GPU give the same bits.
extends "res://tests/field_case.gd"


## Returns knots of all awake tiles after a ball was led through the grass.
func replay() -> Dictionary[Vector2i, PackedVector3Array]:
	var field := add_field({size = Vector2(6, 6), sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 60.0})
	await frames(2)
	await compiled(field)
	var body := add_held_body(ball(0.25), Vector3(-2, 0.25, 0))
	await ticks(2)
	for i in 60:
		body.position = Vector3(-2 + i / 16.0, 0.25, 0.0)
		await ticks(1)
	assert_eq(field.get_statistics().backend, "GPU")
	var knots := knots_of(field, awake_tiles(field))
	body.free()
	field.free()
	return knots


func test_the_same_ticks_make_the_same_bits() -> void:
	var first := await replay()
	var second := await replay()
	assert_greater(first.size(), 4, "tiles")
	assert_eq(second.keys(), first.keys())
	for tile in first:
		assert_eq(second[tile], first[tile], "tile %s" % tile)
