# SPDX-License-Identifier: MIT
## Physics interpolation affects frames only: ticks and queries give the same with it, and where no frame is drawn it costs nothing.
extends "res://tests/field_case.gd"

const TILE := Vector2i(4, 4)


func after() -> void:
	get_tree().physics_interpolation = false


## Returns what a ball that moves does to a tile: knots of all of its blades, after some ticks.
func roll(is_interpolated: bool) -> Dictionary:
	get_tree().physics_interpolation = is_interpolated
	var field := add_field()
	var body := add_held_body(ball(0.2), Vector3(-0.5, 0.2, 0.25))
	await seen()
	for i in 20:
		body.position.x += 0.03
		await ticks(1)
	var knots := PackedVector3Array()
	for blade in BLADES:
		knots.append_array(field.get_knots(TILE, blade))
	var statistics := field.get_statistics().merged(field.get_counters())
	field.free()
	body.free()
	await ticks(2)
	return {knots = knots, steps = statistics.steps, mixes = statistics.mixes, memory = statistics.memory}


func test_ticks_and_answers_are_the_same() -> void:
	var without := await roll(false)
	var with := await roll(true)
	assert_greater(without.steps, 15)
	assert_greater(with.steps, 15)
	assert_eq(with.knots, without.knots)
	assert_eq(with.mixes, 0, "no frame is drawn")
	assert_less(absi(with.memory - without.memory), 8192, "no row of the pool more")
