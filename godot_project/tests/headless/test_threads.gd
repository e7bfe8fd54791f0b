# SPDX-License-Identifier: MIT
## A field and what it uses, called from another thread while the main thread runs ticks and frames.
extends "res://tests/field_case.gd"


## Runs `work` on a thread while frames go on.
func on_a_thread(work: Callable) -> Variant:
	var thread := Thread.new()
	thread.start(work)
	while thread.is_alive():
		await frames(1)
	return thread.wait_to_finish()


func test_calls_from_another_thread_are_refused() -> void:
	expect_error("GrassField 'Meadow': cut() belongs to the main thread")
	expect_error("GrassField 'Meadow': set_map() belongs to the main thread")
	expect_error("GrassField 'Meadow': set_param() belongs to the main thread")
	expect_error("GrassField 'Meadow': get_statistics() belongs to the main thread")
	var field := add_field({map = full_map()})
	var map := field.map
	await ticks(2)
	await on_a_thread(
		func() -> void:
			field.cut(ball(0.5), Transform3D())
			field.map = null
			field.friction = 0.7
			field.get_statistics()
	)
	assert_eq(field.map, map)
	assert_near(field.friction, 1.0, 1e-6)
	assert_eq(field.density_at(Vector3.ZERO), 1.0)
	assert_near(field.get_mown_share(ball(0.5), Transform3D()), 0.0, 1e-6)


func test_resources_that_a_field_uses_are_refused_too() -> void:
	for text: String in [
		"GrassMap: a change", "GrassMap: clear()", "GrassPatch: set_seed()", "GrassSpecies: set_param()", "GrassFillRule: set_seed()"
	]:
		expect_error(text + " belongs to the main thread")
	var species := GrassSpecies.new()
	species.patch = GrassPatch.new()
	var used: Array[GrassSpecies] = [species]
	var field := add_field({map = full_map(), species = used, fill_rule = GrassFillRule.new()})
	await ticks(2)
	await on_a_thread(
		func() -> void:
			field.map.stroke(brush(GrassBrush.TOOL_ERASE, 1.0), Vector2.ZERO, Vector2.ZERO)
			field.map.clear()
			species.patch.seed = 3
			species.natural_frequency = 3.0
			field.fill_rule.seed = 4
	)
	assert_eq(field.density_at(Vector3.ZERO), 1.0)
	assert_eq([species.patch.seed, field.fill_rule.seed], [GrassPatch.new().seed, GrassFillRule.new().seed])


func test_a_field_is_prepared_on_a_thread() -> void:
	var field: GrassField = await on_a_thread(
		func() -> GrassField:
			var made := GrassField.new()
			made.size = Vector2(4, 4)
			made.wind_speed = 0.0
			made.patch = GrassPatch.new()
			made.patch.length_max = 0.6
			made.map = full_map()
			made.map.stroke(brush(GrassBrush.TOOL_ERASE, 0.5), Vector2.ONE, Vector2.ONE)
			return made
	)
	add_child(field)
	await seen()
	assert_eq(field.density_at(Vector3(1, 0, 1)), 0.0)
	assert_greater(await bend_with_ball(field, Vector3(-1, 0.25, -1)), 0.02)


func test_a_storm_of_calls_does_no_harm() -> void:
	expect_error("belongs to the main thread")
	var field := add_field({map = full_map(), fill_rule = GrassFillRule.new()})
	add_held_body(ball(0.3), Vector3(0, 0.2, 0))
	await ticks(2)
	await on_a_thread(
		func() -> void:
			for i in 300:
				field.cut(ball(0.5), Transform3D())
				field.trample(Vector3.ZERO, 0.5, 0.5)
				field.regrow(0.1)
				field.map = null if i % 2 else GrassMap.new()
				field.get_knots(Vector2i.ZERO, 0)
				field.bend_at(Vector3.ZERO)
	)
	await seen()
	assert_greater(field.get_awake_tile_count(), 0)
	assert_true(all_finite(field, [field.get_tile_at(Vector3.ZERO)]))


func test_a_thread_group_of_its_own_is_refused() -> void:
	expect_error("it stands still in a thread group")
	var field := add_field({process_thread_group = Node.PROCESS_THREAD_GROUP_SUB_THREAD})
	add_held_body(ball(0.2), Vector3(0, 0.2, 0))
	await ticks(5)
	assert_eq(field.get_awake_tile_count(), 0)
