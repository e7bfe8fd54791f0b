# SPDX-License-Identifier: MIT
## Which bodies bend grass: every kind that moves, through all changes while it is in the field.
extends "res://tests/field_case.gd"

const CENTER := Vector2i(4, 4)  # a tile at the middle of the field
const MIDDLE := Vector3(0.25, 0.25, 0.25)  # above it


## Adds a floor under the whole field, which is seen by its area but is no object.
func add_floor() -> StaticBody3D:
	var slab := box(Vector3(40, 1, 40))
	return add_body(StaticBody3D.new(), slab, Vector3(0, -0.5, 0))


func weightless() -> RigidBody3D:
	var body := RigidBody3D.new()
	body.gravity_scale = 0.0
	body.linear_damp = 0.0
	body.linear_damp_mode = RigidBody3D.DAMP_MODE_REPLACE
	body.can_sleep = false
	return body


## Returns whether a body at MIDDLE is felt: waits, and tells whether its tile is under an object.
func felt(field: GrassField) -> bool:
	await seen()
	return field.get_counters().colliders > 0 and field.is_tile_awake(CENTER)


func test_every_kind_of_moving_body_bends_grass() -> void:
	add_floor()
	for body: PhysicsBody3D in [RigidBody3D.new(), weightless(), CharacterBody3D.new(), AnimatableBody3D.new(), StaticBody3D.new()]:
		var field := add_field()
		await ticks(2)
		var rest := tile_knots(field, CENTER)
		var far := tile_knots(field, Vector2i.ZERO)
		add_body(body, ball(0.2), MIDDLE + Vector3(0.3, 0, 0))
		for i in 20:
			if body is not RigidBody3D:
				body.position.x -= 0.015
			await ticks(1)
		await seen()
		assert_greater(farthest(tile_knots(field, CENTER), rest), 0.05, body.get_class())
		assert_eq(tile_knots(field, Vector2i.ZERO), far, "far from the body nothing moves")
		body.free()
		field.free()
		await ticks(2)


func test_rigid_bodies_bend_grass_even_frozen() -> void:
	var field := add_field()
	for mode: int in [RigidBody3D.FREEZE_MODE_STATIC, RigidBody3D.FREEZE_MODE_KINEMATIC]:
		var body := RigidBody3D.new()
		body.freeze = true
		body.freeze_mode = mode
		add_body(body, ball(0.2), MIDDLE)
		assert_true(await felt(field), "freeze mode %d" % mode)
		body.free()


func test_floors_and_walls_wake_nothing() -> void:
	var field := add_field()
	add_floor()
	var wall := box(Vector3(1, 2, 1))
	add_body(StaticBody3D.new(), wall, Vector3(1, 1, 1))
	var world := WorldBoundaryShape3D.new()
	add_body(StaticBody3D.new(), world, Vector3.ZERO)
	await ticks(10)
	assert_greater(field.get_body_count(), 1, "they are seen")
	assert_eq(field.get_awake_tile_count(), 0)
	assert_eq(field.get_counters().steps, 0)


func test_areas_bend_nothing() -> void:
	var field := add_field()
	var area := Area3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = ball(0.3)
	area.add_child(shape)
	area.position = MIDDLE
	add_child(area)
	await ticks(5)
	assert_eq(field.get_awake_tile_count(), 0)


func test_layers_and_masks_are_followed() -> void:
	var field := add_field({collision_mask = 2})
	var body := add_held_body(ball(0.2), MIDDLE)
	assert_false(await felt(field), "layer 1, mask 2")
	body.collision_layer = 3
	assert_true(await felt(field), "layers 1 and 2, mask 2")
	body.collision_layer = 1
	assert_false(await felt(field), "layer 1 again")
	assert_eq(field.get_body_count(), 0)
	field.collision_mask = 1
	assert_true(await felt(field), "layer 1, mask 1")
	field.collision_mask = 4
	assert_false(await felt(field), "layer 1, mask 3")


func test_bodies_freed_while_inside() -> void:
	var field := add_field()
	for queued: bool in [true, false, true, false]:
		var body := add_held_body(ball(0.2), MIDDLE)
		assert_true(await felt(field))
		if queued:
			body.queue_free()
		else:
			body.free()
		await ticks(1)
		assert_true(all_finite(field, [CENTER]))
		assert_false(await felt(field))
		assert_eq(field.get_body_count(), 0)


func test_freed_and_made_in_the_same_tick() -> void:
	var field := add_field()
	var body := add_held_body(ball(0.2), MIDDLE)
	for i in 20:
		await ticks(1)
		body.free()
		body = add_held_body(ball(0.2), MIDDLE)
	assert_true(await felt(field))
	assert_eq(field.get_body_count(), 1)
	body.free()
	assert_false(await felt(field))


func test_taken_out_and_put_back() -> void:
	var field := add_field()
	var body := add_held_body(ball(0.2), MIDDLE)
	for i in 5:
		assert_true(await felt(field), "round %d" % i)
		remove_child(body)
		assert_false(await felt(field), "round %d" % i)
		add_child(body)
	for i in 50:
		remove_child(body)
		add_child(body)
	assert_true(await felt(field))
	assert_eq(field.get_body_count(), 1)


func test_switched_off_by_its_mode() -> void:
	var field := add_field()
	var body := add_held_body(ball(0.2), MIDDLE)
	assert_true(await felt(field))
	body.process_mode = PROCESS_MODE_DISABLED  # CollisionObject3D.DISABLE_MODE_REMOVE
	assert_false(await felt(field))
	body.process_mode = PROCESS_MODE_INHERIT
	assert_true(await felt(field))


## Held still in three ways, where it stands: it is still there.
func test_made_static_it_still_holds_the_grass_down() -> void:
	var field := add_field({size = Vector2(8, 8)})
	for body: PhysicsBody3D in [CharacterBody3D.new(), AnimatableBody3D.new(), RigidBody3D.new()]:
		if body is RigidBody3D:
			body.gravity_scale = 0.0
		for way in 2:
			body.disable_mode = CollisionObject3D.DISABLE_MODE_MAKE_STATIC
			if not body.is_inside_tree():
				add_body(body, ball(0.3), Vector3(0.25, 0.25, 0.25))
			for i in 20:
				body.position = Vector3(0.25 + 0.02 * (i + 1), 0.25, 0.25)
				await ticks(1)
			await ticks(60)
			var beside := body.position + Vector3(0.15, 0, 0)
			assert_greater(field.get_bend_at(beside).length(), 0.1, body.get_class())
			if way == 0:
				body.process_mode = PROCESS_MODE_DISABLED
			else:
				PhysicsServer3D.body_set_mode(body.get_rid(), PhysicsServer3D.BODY_MODE_STATIC)
			await ticks(300)
			assert_greater(field.get_bend_at(beside).length(), 0.1, "%s, way %d" % [body.get_class(), way])
			body.process_mode = PROCESS_MODE_INHERIT
		body.free()
		await ticks(1)


## As areas report soft bodies from Godot 4.7 on: whose node is a SoftBody3D is no body of the tracker.
func test_soft_bodies_that_areas_report_are_not_tracked() -> void:
	var field := add_field()
	var soft := SoftBody3D.new()
	var body := add_held_body(ball(0.2), MIDDLE)
	assert_true(await felt(field))
	body.free()
	assert_false(await felt(field))
	body = add_held_body(ball(0.2), MIDDLE)
	PhysicsServer3D.body_attach_object_instance_id(body.get_rid(), soft.get_instance_id())
	assert_false(await felt(field))
	assert_eq(field.get_body_count(), 0)
	soft.free()


func test_a_body_of_the_server_alone_that_is_made_static() -> void:
	var field := add_field()
	var shape := ball(0.3)
	var body := PhysicsServer3D.body_create()
	PhysicsServer3D.body_set_mode(body, PhysicsServer3D.BODY_MODE_KINEMATIC)
	PhysicsServer3D.body_add_shape(body, shape.get_rid())
	PhysicsServer3D.body_set_space(body, field.get_world_3d().space)
	for i in 20:
		PhysicsServer3D.body_set_state(
			body, PhysicsServer3D.BODY_STATE_TRANSFORM, Transform3D(Basis(), Vector3(0.02 * i - 0.15, 0.25, 0.25))
		)
		await ticks(1)
	PhysicsServer3D.body_set_mode(body, PhysicsServer3D.BODY_MODE_STATIC)
	await ticks(300)
	assert_greater(field.get_bend_at(Vector3(0.4, 0, 0.25)).length(), 0.1)
	PhysicsServer3D.free_rid(body)


func test_asleep_it_still_holds_the_grass_down() -> void:
	var field := add_field()
	add_floor()
	var body: RigidBody3D = add_body(RigidBody3D.new(), ball(0.2), Vector3(0.25, 0.2, 0.25))
	var limit := 600
	while not body.sleeping and limit > 0:
		await ticks(1)
		limit -= 1
	assert_true(body.sleeping, "it rests")
	await ticks(60)
	assert_eq(field.get_counters().colliders, 1)
	body.apply_central_impulse(Vector3(2, 0, 0))
	await ticks(20)
	assert_eq(field.get_counters().colliders, 1, "woken")


func test_a_teleport_hits_nothing_on_the_way() -> void:
	for body: PhysicsBody3D in [weightless(), CharacterBody3D.new(), AnimatableBody3D.new(), StaticBody3D.new()]:
		if body is AnimatableBody3D:
			body.sync_to_physics = false
		var field := add_field({size = Vector2(16, 2)})
		add_body(body, ball(0.2), Vector3(-6.9, 0.25, 0))
		await seen()
		body.position.x += 0.01  # a StaticBody3D counts once it has moved
		await seen()
		assert_true(field.is_tile_awake(field.get_tile_at(body.position)), body.get_class())
		body.position = Vector3(6.1, 0.25, 0)
		await ticks(6)
		assert_true(field.is_tile_awake(field.get_tile_at(body.position)), body.get_class())
		for x in range(6, 24):
			for z in 4:
				assert_false(field.is_tile_awake(Vector2i(x, z)), "%s woke %s" % [body.get_class(), Vector2i(x, z)])
		body.free()
		field.free()
		await ticks(2)


func test_a_fast_ball_hits_all_on_its_way() -> void:
	var field := add_field({size = Vector2(16, 2)})
	await ticks(2)
	var tiles: Array[Vector2i] = []
	for x in 32:
		tiles.append(Vector2i(x, 2))
	var rest := knots_of(field, tiles)
	var body := weightless()
	body.linear_velocity = Vector3(100, 0, 0)
	add_body(body, ball(0.2), Vector3(-20, 0.25, 0.25))
	var bent := {}
	for i in 30:
		await ticks(1)
		for tile in tiles:
			if field.is_tile_awake(tile) and not bent.has(tile) and farthest(tile_knots(field, tile), rest[tile]) > 0.03:
				bent[tile] = i
	assert_greater(body.position.x, 8.0, "it has flown through")
	assert_eq(bent.size(), tiles.size(), "tiles with bent blades: %s" % [bent.keys()])


func test_two_hundred_bodies_at_once() -> void:
	var field := add_field({size = Vector2(8, 8)})
	var bodies: Array[PhysicsBody3D] = []
	for i in 200:
		var body := RigidBody3D.new()
		var place := Vector3(0.5 * (i % 14) - 3.25, 0.3 + 0.01 * (i % 7), 0.5 * floorf(i / 14.0) - 3.5)
		bodies.append(add_body(body, [ball(0.15), box(Vector3(0.2, 0.3, 0.2))][i % 2], place))
	add_floor()
	await ticks(20)
	assert_eq(field.get_body_count(), 201, "all of them, and the floor")
	assert_eq(field.get_counters().colliders, 200)
	assert_true(all_finite(field, awake_tiles(field)))
	for body in bodies:
		body.free()
	await ticks(3)
	assert_eq(field.get_body_count(), 1)
	assert_eq(field.get_counters().colliders, 0)


func test_of_a_crowd_some_are_freed() -> void:
	var field := add_field({size = Vector2(20, 20)})
	var bodies: Array[PhysicsBody3D] = []
	for i in 400:
		var body := weightless()
		body.linear_velocity = Vector3(0.3, 0, 0)
		bodies.append(add_body(body, ball(0.1), Vector3(i % 20 - 9.8, 0.2, floorf(i / 20.0) - 9.8)))
	await ticks(20)
	assert_eq(field.get_counters().colliders, 400)
	for round_number in 3:
		for i in range(bodies.size() - 1, -1, -3):
			bodies[i].free()
			bodies.remove_at(i)
		await ticks(1)
		assert_eq(field.get_counters().colliders, bodies.size(), "each of the others, and no other")
		assert_eq(field.get_body_count(), bodies.size())
		await ticks(4)
		for body in bodies:
			assert_true(field.is_tile_awake(field.get_tile_at(body.global_position)), "where it is")
