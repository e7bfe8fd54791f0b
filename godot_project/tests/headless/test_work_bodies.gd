# SPDX-License-Identifier: MIT
## The amount of work for bodies in the grass, by the counters: few calls of the engine for each, and almost none for bodies at rest.
extends "res://tests/field_case.gd"


## Three calls of the engine a body and tick: is its node there, is it in the tree, where is it. A look at its shapes, every eighth tick,
## takes eight more, and every other of these looks four for what seldom changes.
func test_few_calls_of_the_engine() -> void:
	var field := add_field()
	for i in 8:
		add_held_body(ball(0.1), Vector3(0.4 * i - 1.5, 0.2, 0.1))
	await ticks(40)
	var before := field.get_counters()
	await ticks(160)
	var after := field.get_counters()
	assert_eq(after.body_reads - before.body_reads, 8 * 160, "poses: every tick")
	assert_eq(after.shape_reads - before.shape_reads, 8 * 160 / 8, "shapes: every eighth")
	assert_eq(after.engine_calls - before.engine_calls, 8 * (160 * 3 + 160 / 8 * 8 + 160 / 16 * 4))


## Adds a ball on a floor under the grass: asleep after a while.
func add_sleeper(field: GrassField) -> RigidBody3D:
	field.sleep_mode = GrassField.SLEEP_TIMER
	var floor_shape := box(Vector3(8, 1, 8))
	add_body(StaticBody3D.new(), floor_shape, Vector3(0, -0.5, 0))
	var crate := box(Vector3(0.4, 0.4, 0.4))
	var body := add_body(RigidBody3D.new(), crate, Vector3(0.1, 0.21, 0.1)) as RigidBody3D
	await wait_until(func() -> bool: return body.sleeping, "the crate sleeps", true)
	await ticks(20)
	return body


func calls_of_ticks(field: GrassField, count: int) -> int:
	var before: int = field.get_counters().engine_calls
	await ticks(count)
	return field.get_counters().engine_calls - before


func test_bodies_asleep_cost_next_to_nothing() -> void:
	var field := add_field()
	var body := await add_sleeper(field)
	var floor_calls := 64 * 3 + 64 / 8 * 3
	assert_less(await calls_of_ticks(field, 64) - floor_calls, 64 / 8 * 2 + 12, "is it there, and where, every eighth tick, and one look")
	assert_eq(field.get_counters().colliders, 1, "it lies in the grass all the same")
	var awake := awake_tiles(field)
	body.apply_central_impulse(Vector3(0, 0, 3) * body.mass)
	await ticks(3)
	assert_less(4 * 2 - 1, await calls_of_ticks(field, 4) - 4 * 3, "awake, it is read in every tick")
	await ticks(20)
	assert_ne(awake_tiles(field), awake, "and bends grass where it slides")


## ... for so many ticks.
func add_crowd_asleep(count: int) -> void:
	var bodies: Array[RigidBody3D] = []
	for i in 1000:
		var body := add_body(RigidBody3D.new(), ball(0.1), Vector3(i % 40 - 19.7, 0.2, 0.8 * floorf(i / 40.0) - 10.0)) as RigidBody3D
		body.gravity_scale = 0.0
		bodies.append(body)
	await wait_until(func() -> bool: return bodies.all(func(p_body: RigidBody3D) -> bool: return p_body.sleeping), "they sleep", true)
	await ticks(count)


## A crowd that lies in the grass: where it is is asked of 64 bodies a tick, and no tile is looked at.
func test_a_crowd_asleep_costs_a_few_calls_and_no_tiles() -> void:
	var field := add_field({size = Vector2(40, 40), density = 4.0})  # tiles of 4 m: fewer to simulate until they are still
	await add_crowd_asleep(200)
	var before := field.get_counters()
	await ticks(64)
	var after := field.get_counters()
	assert_eq(before.colliders, 1000)
	assert_eq(after.colliders, 1000)
	assert_less(after.body_reads - before.body_reads, 64 * 64 + 1, "poses")
	assert_less(after.engine_calls - before.engine_calls, 64 * 64 * 4, "calls")
	for key: String in ["tiles_looked_at", "steps", "woken", "uploaded_bytes"]:
		assert_eq(after[key], before[key], key)


func test_a_crowd_asleep_that_waits_for_slots_costs_as_few_calls() -> void:
	var field := add_field({size = Vector2(40, 40), pool_tiles = 16})
	await add_crowd_asleep(40)
	var before := field.get_statistics().merged(field.get_counters())
	await ticks(64)
	var after := field.get_statistics().merged(field.get_counters())
	assert_greater(after.refused - before.refused, 64 * 900)
	assert_less(after.body_reads - before.body_reads, 64 * 64 + 1, "poses")


## A crowd that moves over more tiles than the pool holds: a body that nothing can follow is read in every eighth tick.
func test_a_crowd_without_slots_is_read_seldom() -> void:
	const POOL := 16
	var field := add_field({size = Vector2(60, 60), pool_tiles = POOL})
	var bodies: Array[RigidBody3D] = []
	for i in 200:
		var body := add_body(RigidBody3D.new(), ball(0.1), Vector3(4 * (i % 14) - 27, 0.2, 4 * floorf(i / 14.0) - 27)) as RigidBody3D
		body.gravity_scale = 0.0
		body.linear_velocity = Vector3(0.5, 0, 0)
		bodies.append(body)
	await ticks(30)
	var before := field.get_statistics().merged(field.get_counters())
	await ticks(64)
	var after := field.get_statistics().merged(field.get_counters())
	assert_less(after.body_reads - before.body_reads, 64 * (200 / 8 + POOL) + 1)
	assert_greater(after.refused - before.refused, 64 * 150)
	var is_followed := func(p_body: RigidBody3D) -> bool: return field.is_tile_awake(field.get_tile_at(p_body.global_position))
	for body: RigidBody3D in bodies.filter(is_followed):
		bodies.erase(body)
		body.free()
	await ticks(12)
	assert_greater(bodies.filter(is_followed).size(), 0, "others have their slots")


## A lid holds the whole pool. Below the ball nothing bends until the lid goes, and then only where the ball is or was when it was read
## last.
func test_a_body_that_waited_for_slots_bends_grass_where_it_is() -> void:
	var field := add_field({size = Vector2(40, 8), pool_tiles = 100, sleep_mode = GrassField.SLEEP_TIMER})
	var lid := box(Vector3(6, 0.1, 6))
	var cover := add_held_body(lid, Vector3(-16, 0.3, 0))
	await ticks(3)
	var mover := add_held_body(ball(0.1), Vector3(-8, 0.2, 0))
	var found := Vector2.ZERO
	for i in 70:
		mover.position.x += 0.25  # 15 m/s, 2 m in eight ticks
		await ticks(1)
		if i == 20:
			assert_eq(awake_along(field, -8.0), Vector2.ZERO, "no slot is left")
			cover.free()
		found = awake_along(field, -8.0)
		if found != Vector2.ZERO:
			break
	assert_less(found.y - found.x, 2.5, "metres of grass that woke first")
	assert_less(absf(0.5 * (found.x + found.y) - mover.position.x), 8 * 0.25 + 0.5)
	await ticks(1)
	assert_less(absf(awake_along(field, found.y + 0.25).y - mover.position.x), 1.5, "a tick later it is followed")


## From which x to which tiles are awake beyond `from`, metres; zero: none is.
func awake_along(field: GrassField, from: float) -> Vector2:
	var found := Vector2.ZERO
	for tile in awake_tiles(field):
		var centre := field.get_tile_center(tile)
		if centre.x > from:
			found = Vector2(centre.x, centre.x) if found == Vector2.ZERO else Vector2(minf(found.x, centre.x), maxf(found.y, centre.x))
	return found


func test_a_body_that_is_put_elsewhere_in_its_sleep() -> void:
	var field := add_field()
	var body := await add_sleeper(field)
	var there := field.get_tile_at(Vector3(-1.5, 0, -1.5))
	assert_false(field.is_tile_awake(there))
	body.position = Vector3(-1.5, 0.2, -1.5)
	await ticks(10)
	assert_true(field.is_tile_awake(there), "within eight ticks")
	body.free()
	await ticks(3)
	assert_eq(field.get_counters().colliders, 0)


func test_a_change_is_noticed_soon() -> void:
	var field := add_field()
	var body := add_held_body(ball(0.1), Vector3(0.1, 0.2, 0.1))
	var shape: CollisionShape3D = body.get_child(0)
	await ticks(41)
	assert_eq(field.get_counters().colliders, 1)
	shape.disabled = true
	await ticks(4)
	assert_eq(field.get_counters().colliders, 0, "the server says that the overlap has ended")
	shape.disabled = false
	await ticks(6)
	assert_eq(field.get_counters().colliders, 1)
	await ticks(80)
	var awake := field.get_awake_tile_count()
	shape.shape = ball(0.9)
	await ticks(9)
	assert_greater(field.get_awake_tile_count(), awake, "another shape: within eight ticks")


func test_shapes_of_the_ground_are_not_looked_at() -> void:
	var field := add_field()
	var ground := add_body(StaticBody3D.new(), BoxShape3D.new(), Vector3(0, 0.2, 0))
	await ticks(20)
	assert_eq(field.get_counters().shape_reads, 0)
	for i in 10:
		ground.position.x += 0.05
		await ticks(1)
	assert_greater(field.get_counters().shape_reads, 0, "it moves: an object like others")
	assert_greater(field.get_awake_tile_count(), 0)


## Bodies that rest on the grass for long cost nothing but the look at where they are, until one moves.
func test_bodies_that_stand_still_cost_no_simulation() -> void:
	var field := add_field({species = kind({natural_frequency = 2.0, damping_ratio = 0.6})})
	var bodies: Array[PhysicsBody3D] = []
	for x: float in [-1.0, 1.0]:
		bodies.append(add_held_body(ball(0.2), Vector3(x, 0.15, 0.1)))
	await ticks(20)
	var early := field.get_counters()
	assert_eq(early.still_tiles, 0)
	await ticks(100)
	var before := field.get_statistics().merged(field.get_counters())
	assert_eq(before.still_tiles, before.awake_tiles)
	await ticks(40)
	var after := field.get_statistics().merged(field.get_counters())
	for key: String in ["steps", "tile_steps", "simulated_blades", "uploaded_bytes"]:
		assert_eq(after[key], before[key], key)
	assert_eq(after.awake_tiles, before.awake_tiles)
	assert_greater(field.get_bend_at(bodies[0].position).length(), 0.05, "and the grass stays down")
	bodies[0].position.x += 0.05
	await ticks(2)
	var moved := field.get_counters()
	assert_less(moved.still_tiles, before.still_tiles)
	assert_greater(moved.still_tiles, 0, "the other one's")
	field.species[0].damping_ratio = 0.7
	await ticks(1)
	assert_eq(field.get_counters().still_tiles, 0, "other blades")
	for body in bodies:
		body.free()
	await ticks(240)
	assert_eq(field.get_awake_tile_count(), 0, "they have risen")


## A node is found and asked whether it is in the tree and where; its shape for its RID and its data, in every eighth tick far from the
## grass.
func test_registered_nodes_are_counted() -> void:
	var field := add_field()
	for i in 3:
		var node := Node3D.new()
		node.position = Vector3(0.3 * i, 0.2, 0) if i < 2 else Vector3(900, 0.2, 0)
		add_child(node)
		field.register_collider(node, ball(0.1))
	await ticks(10)
	var before := field.get_counters()
	await ticks(80)
	var after := field.get_counters()
	assert_eq(after.body_reads - before.body_reads, 3 * 80)
	assert_eq(after.shape_reads - before.shape_reads, 2 * 80 + 80 / 8)
	assert_eq(after.engine_calls - before.engine_calls, 3 * 80 * 3 + 2 * (2 * 80 + 80 / 8))
	assert_eq(after.colliders, 2)


## Its pieces, which come eight ticks after it was seen, are no change of it.
func test_a_trimesh_is_looked_at_as_seldom_as_a_box() -> void:
	var field := add_field()
	var shape := ConcavePolygonShape3D.new()
	var mesh := BoxMesh.new()
	mesh.size = Vector3(0.4, 0.4, 0.4)
	shape.set_faces(mesh.get_faces())
	var body := add_held_body(shape, Vector3(0, 0.2, 0))
	await wait_until(func() -> bool: return field.get_counters().mesh_pieces == 1, "it is split", true)
	var before := field.get_counters()
	for i in 80:
		body.position.x = 0.1 * sin(0.1 * i)
		await ticks(1)
	var after := field.get_counters()
	assert_eq(after.body_reads - before.body_reads, 80)
	assert_near(after.shape_reads - before.shape_reads, 80 / 8, 1)
