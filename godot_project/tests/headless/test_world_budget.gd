# SPDX-License-Identifier: MIT
## The memory budget of a GrassWorld: it never holds nothing, and holds as much as before once something expensive is gone.
extends "res://tests/world_case.gd"


## Ticks until a plot with many bodies has come to rest again, and the world holds what it can.
func settled(world: GrassWorld, plots: int) -> void:
	await wait_until(
		func() -> bool: return world.get_statistics().plots >= plots and world.get_statistics().waiting == 0, "plots come back"
	)


func test_a_crowd_in_one_plot_does_not_take_the_grass_away() -> void:
	var scene := pattern({density = 64.0, pool_tiles = 4096, sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 0.1})
	expect_error("`memory_budget` (")
	var world := add_world({plot_scene = scene, camera_radius = 60.0})
	await go(world, Vector3(64, 0, 64))
	var alone: Dictionary = world.get_statistics()
	world.memory_budget = ceilf(2.0 * alone.memory / 1e6)
	await frames(10)
	var bodies: Array[Node3D] = []
	for i in 40:
		bodies.append(add_held_body(ball(0.4), Vector3(10 + 11 * (i % 10), 0.3, 12 + 24 * (i / 10))))
	var least := 100
	var most := 0
	var pool := 0
	for i in 45:
		for body in bodies:
			body.position.x += 0.2
		await ticks(1)
		var now := world.get_statistics()
		least = mini(least, now.plots)
		most = maxi(most, now.memory)
		for field in world.get_fields():
			pool = maxi(pool, field.get_counters().pool_slots)
			assert_less(field.get_memory_usage(), now.memory + 1, "the world counts what its fields take now")
	assert_greater(least, 0, "grass stands under the camera and the bodies")
	assert_less(most, 1e6 * world.memory_budget, "the crowd gets as large a pool as the budget pays for")
	assert_greater(pool, 32)
	var field: GrassField = world.get_field(Vector2i(0, 0))
	assert_true(field != null)
	for body in bodies:
		body.free()
	await settled(world, alone.plots)
	assert_eq(world.get_statistics().plots, alone.plots, "as before")
	await wait_until(func() -> bool: return field.get_counters().pool_slots == 0, "the pool is gone again", true)
	await ticks(20)
	assert_less(world.get_statistics().memory, 1e6 * world.memory_budget)
	eye.position.x += 4000.0
	await loaded(world)
	assert_true(world.get_field_at(eye.position) != null, "and elsewhere")


## Plots that have just come, and are not measured yet, count with the pools that they got.
func test_all_plots_around_bodies_get_a_pool_that_leaves_room_for_the_others() -> void:
	var world := add_world({plot_size = 64.0, camera_radius = 20.0, plot_scene = pattern({pool_tiles = 4096}), memory_budget = 256.0})
	for at: Vector3 in [Vector3(20, 0.3, 20), Vector3(-20, 0.3, 20)]:
		add_held_body(ball(0.3), at)
	for i in 120:
		for child in get_children():
			if child is AnimatableBody3D:
				child.position.x += 0.02 if i % 2 == 0 else -0.02
		await frames(1)
		OS.delay_msec(2)
	await loaded(world)
	var pools := world.get_fields().map(func(field: GrassField) -> int: return field.pool_tiles)
	assert_eq(world.get_fields().size(), 4)
	assert_less(pools.max(), 4096, str(pools))


func test_other_species_in_one_plot() -> void:
	var many: Array[GrassSpecies] = []
	for i in 8:
		many.append(GrassSpecies.new())
		many[i].patch = GrassPatch.new()
		many[i].patch.seed = i
	var world := add_world({plot_scene = pattern({species = many}), camera_radius = 100.0})
	await go(world, Vector3(64, 0, 64))
	var before: Dictionary = world.get_statistics()
	world.get_field(Vector2i(0, 0)).species = [GrassSpecies.new()] as Array[GrassSpecies]
	for i in 60:
		await frames(1)
		assert_eq(world.get_statistics().plots, before.plots, "frame %d" % i)
		assert_less(world.get_statistics().memory, 2 * before.memory)
	var field := world.get_field(Vector2i(-1, 0))
	world.remove_child(field)
	for i in 60:
		await frames(1)
		assert_greater(world.get_statistics().plots, before.plots - 2, "one at most is gone")
		assert_less(world.get_statistics().memory, 2 * before.memory)
	if is_instance_valid(field) and not field.is_inside_tree():
		field.free()


## The editor of the lawn's map, physics and other fields may take as long as they like: plots come.
func test_plots_come_while_another_field_changes_in_each_frame() -> void:
	var lawn := add_field({size = Vector2(400, 400), density = 4.0, position = Vector3(0, 0, 3000), map = full_map()})
	var world := add_world()
	await grown(lawn)
	var disc := brush(GrassBrush.TOOL_HEIGHT, 60.0, {strength = 0.1})
	eye.position = Vector3(64, 2, 64)
	var count := 0
	while world.get_statistics().plots < 9 and count < 1500:
		disc.target = 0.2 + 0.5 * (count % 2)
		for x: float in [-120.0, 0.0, 120.0]:
			lawn.map.stroke(disc, Vector2(x, -120), Vector2(x, 120))
		OS.delay_msec(2)  # the physics of others
		await frames(1)
		count += 1
	assert_less(count, 1500, "plots come, if slowly")


func test_the_world_counts_its_work() -> void:
	var world := add_world({camera_radius = 400.0})
	await go(world, Vector3(64, 0, 64))
	var quiet: int = world.get_statistics().distance_tests
	assert_greater(quiet, 0)
	for i in 200:
		add_held_body(ball(0.2), Vector3(-120 + 1.2 * i, 0.3, 30 + (i % 7)))
	for i in 30:
		for child in get_children():
			if child is AnimatableBody3D:
				child.position.z += 0.05
		await ticks(1)
	await frames(2)
	assert_greater(world.get_statistics().distance_tests, quiet, "they are counted")
	assert_less(world.get_statistics().distance_tests, quiet + 4 * 200, "and cost what they are, not what there are plots")


func test_what_cut_returns_is_always_the_same() -> void:
	var world := add_world()
	var deck := BoxShape3D.new()
	var nothing := world.cut(deck, Transform3D())
	await go(world, Vector3(64, 0, 64))
	var something := world.cut(deck, Transform3D(Basis(), Vector3(64, 0.3, 64)))
	var of_field := world.get_field(Vector2i(0, 0)).cut(deck, Transform3D(Basis(), Vector3(64, 0.3, 64)))
	assert_greater(something.blades, 0)
	for key: String in of_field:
		assert_eq(typeof(nothing[key]), typeof(of_field[key]), key)
		assert_eq(typeof(something[key]), typeof(of_field[key]), key)
		assert_eq(nothing[key], 0, key)
	assert_eq(nothing.size(), of_field.size())


func test_a_world_outside_of_the_tree() -> void:
	var world := GrassWorld.new()
	world.name = "Away"
	world.folder = FOLDER
	expect_error("GrassWorld 'Away': get_plot_at() needs the world in the tree")
	expect_error("GrassWorld 'Away': paint() needs the world in the tree")
	assert_eq(world.get_plot_at(Vector3(500, 0, 500)), Vector2i())
	assert_true(world.get_field_at(Vector3.ZERO) == null)
	assert_eq(world.paint(brush(GrassBrush.TOOL_CUT, 1.0), Vector3.ZERO, Vector3.ONE), 0.0)
	world.shift_origin(Vector3(100, 0, -50))
	assert_eq(world.position, Vector3(100, 0, -50))
	assert_eq(world.save(), 0)
	assert_eq(world.discard_unsaved() + world.carry_unsaved(), 0)
	assert_eq(world.get_fields().size(), 0)
	world.free()


func test_properties_belong_to_the_main_thread() -> void:
	var world := add_world()
	var before: Array[float] = [world.camera_radius, world.body_radius, world.memory_budget]
	for method: String in ["set_camera_radius", "set_body_radius", "set_memory_budget"]:
		expect_error("%s() belongs to the main thread" % method)
	var thread := Thread.new()
	thread.start(
		func() -> void:
			world.camera_radius = 3.0
			world.body_radius = 3.0
			world.memory_budget = 3.0
	)
	thread.wait_to_finish()
	assert_eq([world.camera_radius, world.body_radius, world.memory_budget] as Array[float], before)


func test_a_warning_of_all_plots_is_given_once() -> void:
	var rule := GrassFillRule.new()
	rule.slope_max = 20.0
	var world := add_world({plot_scene = pattern({fill_rule = rule})})
	expect_error("GrassWorld '%s': `plot_scene`: " % world.get_path())
	await go(world, Vector3(64, 0, 64))
	assert_greater(world.get_statistics().plots, 4)
