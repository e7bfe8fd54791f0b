# SPDX-License-Identifier: MIT
## A field that is moved, turned, rescaled, removed and added again, copied over another and freed, with bodies in it.
extends "res://tests/field_case.gd"


func test_out_and_in_a_thousand_times() -> void:
	var field := add_field()
	var body := add_held_body(ball(0.2), Vector3(0, 0.2, 0))
	for i in 20:  # what the engine keeps for good is there after that
		remove_child(field)
		add_child(field)
		await ticks(1)
	var objects := Performance.get_monitor(Performance.OBJECT_COUNT)
	var resources := Performance.get_monitor(Performance.OBJECT_RESOURCE_COUNT)
	var memory := Performance.get_monitor(Performance.MEMORY_STATIC)
	for i in 1000:
		remove_child(field)
		assert_eq(field.get_body_count() + field.get_awake_tile_count() + field.get_blade_count(), 0, "out of the tree there is nothing")
		add_child(field)
		if i % 10 == 0:  # now and then it also comes to life in between
			await seen()
	assert_less(Performance.get_monitor(Performance.OBJECT_COUNT) - objects, 4.0, "objects")
	assert_less(Performance.get_monitor(Performance.OBJECT_RESOURCE_COUNT) - resources, 4.0, "resources")
	assert_less(Performance.get_monitor(Performance.MEMORY_STATIC) - memory, 1e6, "bytes")
	await seen()
	assert_greater(field.get_awake_tile_count(), 0, "the body is found again")
	body.free()
	assert_greater(await bend_with_ball(field, Vector3(1, 0.25, 1)), 0.02, "and grass still bends")


func test_made_and_freed_a_hundred_times() -> void:
	add_held_body(ball(0.2), Vector3(0, 0.2, 0))
	var objects := 0.0
	var memory := 0.0
	for i in 120:
		if i == 20:
			objects = Performance.get_monitor(Performance.OBJECT_COUNT)
			memory = Performance.get_monitor(Performance.MEMORY_STATIC)
		var field := add_field()
		if i % 5 == 0:
			await seen()
			assert_greater(field.get_awake_tile_count(), 0)
		if i % 2 == 0:
			field.free()  # while it is awake
		else:
			field.queue_free()
			await ticks(1)
	assert_less(Performance.get_monitor(Performance.OBJECT_COUNT) - objects, 4.0, "objects")
	assert_less(Performance.get_monitor(Performance.MEMORY_STATIC) - memory, 1e6, "bytes")


func test_moved_and_turned_with_a_body_in_it() -> void:
	var field := add_field()
	add_held_body(ball(0.2), Vector3(0, 0.2, 0))
	for i in 60:
		field.rotation = Vector3(0.02 * i, 0.1 * i, 0.01 * i)
		field.position = Vector3(0.01 * i, 0.003 * i, 0)
		await ticks(1)
		if i % 10 == 9:
			assert_greater(field.get_awake_tile_count(), 0, "tick %d" % i)
			assert_true(all_finite(field, awake_tiles(field)), "tick %d" % i)
	field.transform = Transform3D(Basis(), Vector3(1000, 0, 0))
	await ticks(240)
	assert_eq(field.get_awake_tile_count(), 0, "far from the body all is at rest")
	assert_near(field.get_tile_center(Vector2i(4, 4)), Vector3(1000.25, 0, 0.25), 1e-4)


func test_moved_over_ground_that_stays() -> void:
	var field := add_field()
	var slab := box(Vector3(20, 1, 20))
	var ground := add_body(StaticBody3D.new(), slab, Vector3(0, -0.5, 0))
	for i in 30:
		field.position = Vector3(0.02 * i, 0, 0)
		field.rotation.y = 0.05 * i
		await ticks(1)
	assert_eq(field.get_body_count(), 1)
	assert_eq(field.get_awake_tile_count(), 0, "the ground did not move")
	ground.position.y = -0.45
	await seen()
	assert_greater(field.get_awake_tile_count(), 0, "now it did")


func test_a_turned_field_bends_where_the_body_is() -> void:
	var field := add_field({rotation = Vector3(0.3, 1.0, -0.2), position = Vector3(5, 1, -3)})
	await ticks(2)
	var tile := Vector2i(2, 5)
	var place := field.get_tile_center(tile) + 0.25 * field.basis.y
	assert_eq(field.get_tile_at(place), tile)
	assert_greater(await bend_with_ball(field, place), 0.05)
	assert_eq(field.get_awake_tile_count(), field.get_statistics().awake_tiles)
	assert_true(field.is_tile_awake(tile))


func test_scale_and_bad_transforms() -> void:
	expect_error("is_finite()")  # the engine's own word on such a node
	var field := add_field()
	await ticks(2)
	var rest := tile_knots(field, Vector2i.ZERO)
	add_held_body(ball(0.2), Vector3(0, 0.2, 0))
	for axes: Vector3 in [
		Vector3(3, 3, 3), Vector3(1, 5, 0.1), Vector3(-1, 1, 1), Vector3(0, 0, 0), Vector3(1e20, 1e20, 1e20), Vector3(1e-20, 1, 1)
	]:
		field.transform = Transform3D(Basis.from_scale(axes), Vector3.ZERO)
		await seen()
		assert_greater(field.get_awake_tile_count(), 0, "scale %s" % axes)
		assert_true(all_finite(field, awake_tiles(field)), "scale %s" % axes)
	for bad: float in [NAN, INF, -INF, 1e30]:
		for transform_: Transform3D in [
			Transform3D(Basis(), Vector3(bad, 0, 0)), Transform3D(Basis.from_scale(Vector3(bad, 1, 1)), Vector3.ZERO)
		]:
			field.transform = transform_
			await seen()
			assert_true(all_finite(field, [Vector2i(4, 4)]), "transform %s" % transform_)
	field.transform = Transform3D()
	await ticks(2)
	assert_eq(tile_knots(field, Vector2i.ZERO), rest, "all is as before")
	await seen()
	assert_greater(field.get_awake_tile_count(), 0, "the ball bends grass again")


func test_two_fields_share_a_body() -> void:
	var first := add_field({seed = 1})
	var second := add_field({seed = 2, rotation = Vector3(0, 0.5, 0)})
	await ticks(2)
	add_held_body(ball(0.2), Vector3(0, 0.2, 0))
	await ticks(10)
	assert_eq(first.get_body_count(), 1)
	assert_eq(second.get_body_count(), 1)
	assert_greater(first.get_awake_tile_count(), 0)
	assert_greater(second.get_awake_tile_count(), 0)
	first.free()
	await ticks(3)
	assert_eq(second.get_body_count(), 1)
	assert_true(all_finite(second, awake_tiles(second)))


func test_rebuilt_while_awake() -> void:
	var field := add_field()
	add_held_body(ball(0.2), Vector3(0, 0.2, 0))
	for change: Array in [
		["density", 1000.0],
		["size", Vector2(2, 6)],
		["pool_tiles", 3],
		["clump_lean", 0.0],
		["seed", 4],
		["backend", GrassField.BACKEND_CPU]
	]:
		await seen()
		assert_greater(field.get_awake_tile_count(), 0, "before %s" % [change])
		field.set(change[0], change[1])
		await seen()
		assert_greater(field.get_awake_tile_count(), 0, "after %s" % [change])
		assert_true(all_finite(field, awake_tiles(field)), "after %s" % [change])


func test_paused_and_hidden() -> void:
	var field := add_field()
	await ticks(2)
	field.hide()
	assert_greater(await bend_with_ball(field), 0.05, "a hidden field is simulated: it may be shown at any time")
	var steps: int = field.get_counters().steps
	field.process_mode = PROCESS_MODE_DISABLED
	await ticks(10)
	assert_eq(field.get_counters().steps, steps, "a paused field stands still")
	field.process_mode = PROCESS_MODE_INHERIT
	await ticks(5)
	assert_greater(field.get_counters().steps, steps)
