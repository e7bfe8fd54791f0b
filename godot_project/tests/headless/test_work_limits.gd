# SPDX-License-Identifier: MIT
## What one call of a script does at most: beyond it the call does nothing, and says so.
extends "res://tests/world_case.gd"


func test_blades() -> void:
	var field := add_field({size = Vector2(100, 100)})
	await ticks(1)
	expect_error("find_blades() would look at 2560000 blades; it looks at 1048576 at most (BLADES_MAX)")
	assert_eq(field.find_blades(Vector3.ZERO, 300.0).size(), 0)
	assert_near(field.find_blades(Vector3.ZERO, 4.0).size(), 256.0 * PI * 16.0, 600.0)
	expect_error("find_blades() needs a finite position, and a radius")
	assert_eq(field.find_blades(Vector3(NAN, 0, 0), 1.0).size(), 0)
	var many := PackedInt64Array()
	many.resize(GrassField.BLADES_MAX + 1)
	expect_error("1048577 blades were asked for; one call returns 1048576 at most (BLADES_MAX)")
	assert_eq(field.get_blade_knots(many).size(), 0)
	assert_eq(field.wait_for_knots(many).size(), 0)


func test_areas() -> void:
	var field := add_field({size = Vector2(2048, 1024), density = 1.0})
	await ticks(1)
	for method: String in ["cut", "get_mown_share", "regrow", "bake_ground", "bake_ground_from"]:
		expect_error("%s() would act on" % method)
	assert_eq(field.cut(box(Vector3(3000, 1, 3000)), Transform3D()).area, 0.0)
	assert_true(field.map == null, "a call that is refused makes no map")
	assert_near(field.cut(box(Vector3(10, 1, 10)), Transform3D(Basis(), Vector3(0, 0.55, 0))).area, 100.0, 2.0)
	assert_eq(field.get_mown_share(), 0.0)
	field.regrow(1.0, 1.0)
	assert_eq(field.get_mown_share(box(Vector3(8, 1, 8)), Transform3D()), 1.0, "nothing has grown")
	assert_eq(field.bake_ground(), 0)
	assert_eq(field.bake_ground(Rect2(-1, -1, 2, 2)), 0, "no ground there, and no error")
	var ground := HeightMapShape3D.new()
	ground.map_width = 11
	ground.map_depth = 11
	assert_eq(field.bake_ground_from(ground, Transform3D(Basis().scaled(Vector3(300, 1, 300)), Vector3.ZERO)), 0)
	assert_near(field.bake_ground_from(ground, Transform3D(Basis(), Vector3(0, 2, 0))), 100, 10, "of 10 x 10 m in a field of 2 km²")
	expect_error("fill() would fill 2097152 square metres at once")
	assert_eq(field.fill(GrassFillRule.new()), 0.0)
	# A square of 1,024 m is just allowed.
	assert_near(field.get_mown_share(box(Vector3(1024, 9, 1024)), Transform3D(Basis(), Vector3(512, 0, 0))), 0.0, 0.001)


func test_a_world_cuts_all_or_nothing() -> void:
	var world := add_world({plot_size = 1024.0, plot_scene = pattern({density = 0.25})})
	await go(world, Vector3.ZERO)
	assert_greater(world.get_fields().size(), 1)
	expect_error("cut() would act on")
	assert_eq(world.cut(box(Vector3(1e4, 1, 1e4)), Transform3D()).area, 0.0)
	for field in world.get_fields():
		assert_eq(field.map.get_memory_usage() if field.map else 0, GrassMap.new().get_memory_usage() if field.map else 0, field.name)
	assert_near(world.cut(box(Vector3(40, 1, 40)), Transform3D(Basis(), Vector3(0, 0.55, 0))).area, 1600.0, 10.0, "over four plots")
	expect_error("at most 4096 m can be painted at once")
	assert_eq(world.paint(brush(GrassBrush.TOOL_ERASE, 1.0), Vector3.ZERO, Vector3(5000, 0, 0)), 0.0)


func test_trample() -> void:
	var field := add_field({map = full_map()})
	await ticks(1)
	expect_error("an amount from 0 to 1")
	for amount: float in [-1.0, NAN, -INF]:
		assert_eq(field.trample(Vector3.ZERO, 0.5, amount), 0.0, str(amount))
	assert_eq(field.map.sample(GrassMap.CHANNEL_WEAR, Vector2(0.1, 0.1)), 0.0)
	expect_error("`amount` cannot be 7")
	assert_greater(field.trample(Vector3.ZERO, 0.5, 7.0), 0.0)


func test_what_needs_the_tree_names_the_method_once() -> void:
	var field := GrassField.new()
	expect_error("add the node to the scene tree before calling cut().")
	assert_eq(field.cut(ball(1.0), Transform3D()).area, 0.0)
	field.free()
