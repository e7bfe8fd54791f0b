# SPDX-License-Identifier: MIT
## Physics interpolation: between two ticks, a frame shows blades between two steps, as the engine draws the bodies that bend them.
extends "res://tests/between_case.gd"


func test_blades_move_in_every_frame_as_the_bodies_do() -> void:
	var field := await roll(true)
	var counts := count_moving(await watch(7))
	print("    interpolated: %d of %d frames within a tick show other blades; %d mixes" % [counts.x, counts.y, field.get_counters().mixes])
	assert_greater(counts.y, 5, "frames lie between ticks")
	assert_greater(counts.x, 0.9 * counts.y)
	assert_greater(field.get_counters().mixes, 5)


func test_without_it_nothing_is_mixed() -> void:
	var field := await roll(false)
	var counts := count_moving(await watch(7))
	assert_greater(counts.y, 5, "frames lie between ticks")
	assert_eq(counts.x, 0, "frames within a tick are the same")
	assert_eq(field.get_counters().mixes, 0)


## At rest nothing is mixed again, and what is shown is the last step.
func test_still_blades_are_not_mixed_again() -> void:
	var field := await roll(true)
	Engine.physics_ticks_per_second = 60
	await ticks(200)
	await drawn()
	var before: Dictionary = field.get_counters()
	await ticks(20)
	await drawn()
	assert_eq(field.get_counters().steps, before.steps, "the field is still")
	assert_eq(field.get_counters().mixes, before.mixes)
	var interpolated := await next_picture()
	get_tree().physics_interpolation = false
	assert_eq(difference(interpolated, await picture()).x, 0.0, "it shows the last step")
