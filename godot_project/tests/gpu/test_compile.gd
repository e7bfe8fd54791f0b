# SPDX-License-Identifier: MIT
## Worker threads compile the simulation's passes. Until the first pass is ready, grass does not bend; until the pass for colliders with
## edges is ready, the first one simulates all tiles. A field whose method changes keeps its old pass until the new one is ready.
extends "res://tests/parity_case.gd"

const MOST_TICKS := 100000  # while a driver compiles: a card runs a thousand ticks in a second


func test_the_first_field_stands_until_its_pass_is_there() -> void:
	var first_field: Dictionary = get_tree().get_meta("first_field")
	print("    %s" % first_field)
	if first_field.has("ticks"):  # else the driver was as fast as the first ticks
		assert_eq(first_field.tile_steps, 0, "nothing is simulated")
		assert_eq(first_field.awake, 0, "nor awake, though a body moves in the grass")
		if first_field.ticks > 5:  # the server tells of the body a tick late
			assert_eq(first_field.entered, 1, "but who listens hears of it")
	assert_greater(first_field.steps_after, 0)


func test_sharp_colliders_do_not_wait_for_their_pass() -> void:
	gpu = add_field()
	add_held_body(box(Vector3(0.5, 0.2, 0.5)), PLACE + Vector3(0, 0.2, 0))
	await ticks(5)
	var early := gpu.get_statistics().merged(gpu.get_counters())
	print("    after 5 ticks: %d passes are being compiled" % early.compiling)
	assert_greater(early.simulated_blades, 0, "simulated at once, whoever does it")
	if early.compiling > 0:
		assert_eq(early.edge_tile_steps, 0)
	await compiled(gpu)
	await ticks(5)
	assert_greater(gpu.get_counters().edge_tile_steps, early.edge_tile_steps)
	var knots := tile_knots(gpu, gpu.get_tile_at(PLACE))
	assert_eq(knots.size(), BLADES * KNOTS)
	for knot in knots:
		assert_true(knot.is_finite())


func test_a_field_goes_on_until_another_method_s_passes_are_there() -> void:
	gpu = add_field()
	var body := add_held_body(box(Vector3(0.5, 0.2, 0.5)), PLACE + Vector3(0, 0.2, 0))
	await ticks(5)
	await compiled(gpu)
	await ticks(5)
	var before := gpu.get_counters()
	gpu.method = GrassField.METHOD_PBD
	assert_true(gpu.get_statistics().waiting)
	var passed := 0
	while gpu.get_counters().makings == before.makings and passed < MOST_TICKS:
		body.position.x += 1e-4
		await ticks(1)
		passed += 1
	var after := gpu.get_counters()
	print("    %d ticks by the method before" % passed)
	assert_eq(after.makings, before.makings + 1)
	assert_eq(after.builds, before.builds, "what was made serves")
	assert_greater(after.steps - before.steps, passed - 3, "the field goes on")
	assert_greater(after.edge_tile_steps - before.edge_tile_steps, passed - 3, "tiles near what is sharp by their own pass all the while")
	await compiled(gpu)
	await ticks(5)
	assert_greater(gpu.get_counters().steps, after.steps, "by the new one")
	for knot in tile_knots(gpu, gpu.get_tile_at(PLACE)):
		assert_true(knot.is_finite())


func test_another_method_is_asked_for_at_rest() -> void:
	var species: Array[GrassSpecies] = [GrassSpecies.new(), GrassSpecies.new()]  # passes that no test before compiled
	gpu = add_field({species = species})
	await ticks(5)
	await compiled(gpu)
	gpu.method = GrassField.METHOD_PBD
	await ticks(2)
	assert_greater(gpu.get_statistics().compiling, 0)
	gpu.drawn_tiles_max = 64  # another backend, in the middle of it
	await ticks(2)
	add_held_body(ball(0.2), PLACE)
	await ticks(3)
	assert_greater(gpu.get_counters().simulated_blades, 0, "by the method before")
	await compiled(gpu)
	await grown(gpu)
	var before: int = gpu.get_counters().simulated_blades
	await ticks(3)
	assert_greater(gpu.get_counters().simulated_blades, before, "by the new one")
