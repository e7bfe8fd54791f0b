# SPDX-License-Identifier: MIT
## How much is done, by the counters: nothing where nothing changes, and no more on a large field than on a small one.
extends "res://tests/field_case.gd"

const SIZES: Array[float] = [70.5, 500.0]  # metres: 20 thousand and 1 million tiles


func test_the_same_work_on_any_field() -> void:
	var fields: Array[GrassField] = []
	for size_ in SIZES:
		fields.append(add_field({size = Vector2(size_, size_)}))
	await ticks(2)
	var bodies: Array[PhysicsBody3D] = []
	for i in 24:
		# On both fields at the same place within a tile.
		bodies.append(add_held_body(ball(0.1 + 0.01 * i), Vector3(0.25 + 1.5 * (i % 6) - 4.0, 0.2, 0.25 + 1.5 * floorf(i / 6.0) - 3.0)))
	for i in 20:
		for body in bodies:
			body.position.x += 0.02
		await ticks(1)
	var small := fields[0].get_counters()
	var large := fields[1].get_counters()
	assert_greater(fields[1].get_blade_count(), 50 * fields[0].get_blade_count() - 1)
	for key: String in ["body_reads", "shape_reads"]:
		assert_eq(large[key], small[key], key)
	for key: String in ["tiles_looked_at", "tile_steps", "list_entries", "woken"]:  # the grids lie a little differently under the bodies
		assert_less(absf(large[key] - small[key]), 0.2 * small[key], key)
	assert_less(absf(fields[1].get_memory_usage() - fields[0].get_memory_usage()), 1e6, "bytes")


## Two calls of the engine a body and tick: is it there, where is it. A look at its shapes, every eighth tick, takes six more, and every
## other of these looks four for what seldom changes.
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
	assert_eq(after.engine_calls - before.engine_calls, 8 * (160 * 2 + 160 / 8 * 6 + 160 / 16 * 4))


## A ball on a floor under the grass: asleep after a while.
func add_sleeper(field: GrassField) -> RigidBody3D:
	field.sleep_mode = GrassField.SLEEP_TIMER
	var floor_shape := BoxShape3D.new()
	floor_shape.size = Vector3(8, 1, 8)
	add_body(StaticBody3D.new(), floor_shape, Vector3(0, -0.5, 0))
	var crate := BoxShape3D.new()
	crate.size = Vector3(0.4, 0.4, 0.4)
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
	var floor_calls := 64 * 2 + 64 / 8 * 2
	assert_less(await calls_of_ticks(field, 64) - floor_calls, 64 / 8 * 2 + 12, "is it there, and where, every eighth tick, and one look")
	assert_eq(field.get_counters().colliders, 1, "it lies in the grass all the same")
	var awake := awake_tiles(field)
	body.apply_central_impulse(Vector3(0, 0, 3) * body.mass)
	await ticks(3)
	assert_less(4 * 2 - 1, await calls_of_ticks(field, 4) - 4 * 2, "awake, it is read in every tick")
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
	var field := add_field({size = Vector2(40, 40)})
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
	var lid := BoxShape3D.new()
	lid.size = Vector3(6, 0.1, 6)
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


func test_nothing_near_looks_at_nothing() -> void:
	var field := add_field({size = Vector2(500, 500)})
	await ticks(60)
	var now := field.get_counters()
	for key: String in ["steps", "simulated_blades", "tiles_looked_at", "body_reads", "shape_reads", "uploaded_bytes", "culls", "woken"]:
		assert_eq(now[key], 0, key)


func test_many_changes_at_once_make_the_field_once() -> void:
	var field := add_field()
	await ticks(2)
	assert_eq(field.get_counters().makings, 1)
	field.seed = 3
	field.pool_tiles = 100
	field.clump_lean = 0.5
	field.size = Vector2(6, 6)
	await ticks(2)
	assert_eq(field.get_counters().makings, 2)
	field.seed = 3
	field.wind_speed = 4.0
	field.sleep_delay = 1.0
	await ticks(2)
	assert_eq(field.get_counters().builds, 1, "nothing that it is made of has changed")


## As any other change of what it is made of: its blades stand, and what touches them bends them again.
func test_another_method_makes_the_field_anew() -> void:
	var field := add_field()
	var body := add_held_body(ball(0.3), Vector3(0.25, 0.25, 0.25))
	await ticks(10)
	var before := field.get_counters()
	assert_greater(before.steps, 0)
	body.free()
	field.method = GrassField.METHOD_PBD
	await ticks(2)
	var after := field.get_counters()
	assert_eq(after.makings, before.makings + 1)
	assert_eq(after.builds, before.builds, "what was made serves")
	assert_eq(field.get_awake_tile_count(), 0, "at rest")
	field.method = GrassField.METHOD_PBD
	await ticks(2)
	assert_eq(field.get_counters().makings, after.makings, "the same method again")
	add_held_body(ball(0.3), Vector3(0.25, 0.25, 0.25))
	await ticks(10)
	assert_greater(field.bend_at(Vector3(0.4, 0, 0.25)).length(), 0.1)


func test_a_field_that_grows_keeps_its_pool() -> void:
	var field := add_field()
	var body := add_held_body(ball(0.2), Vector3(0.25, 0.25, 0.25))
	for i in 20:
		field.size += Vector2(30, 30)
		if i % 5 == 4:
			field.density += 40.0
		await seen()
		assert_greater(field.get_awake_tile_count(), 0, "size %s" % field.size)
		assert_true(all_finite(field, awake_near(field, body.position)), "size %s" % field.size)
	assert_eq(field.get_counters().builds, 1)
	assert_greater(field.get_blade_count(), 100_000_000)
	# As if it had been made so.
	var fresh := add_field({size = field.size, density = field.density})
	body.free()
	await ticks(1000)
	assert_eq(field.get_awake_tile_count(), 0)
	for place: Vector3 in [Vector3(0.3, 0, 0.4), Vector3(200, 0, -100)]:
		assert_eq(field.get_tile_at(place), fresh.get_tile_at(place))
		assert_eq(tile_knots(field, field.get_tile_at(place)), tile_knots(fresh, fresh.get_tile_at(place)))
	assert_near(field.get_memory_usage(), fresh.get_memory_usage(), 4e6, "bytes: nothing piles up")


func awake_near(field: GrassField, place: Vector3) -> Array[Vector2i]:
	var middle := field.get_tile_at(place)
	var found: Array[Vector2i] = []
	for x in range(-3, 4):
		for z in range(-3, 4):
			if field.is_tile_awake(middle + Vector2i(x, z)):
				found.append(middle + Vector2i(x, z))
	return found


func test_memory_of_a_crowd_comes_back() -> void:
	var field := add_field({size = Vector2(30, 30), sleep_delay = 0.1, sleep_mode = GrassField.SLEEP_TIMER, settle_time = 0.1})
	await ticks(2)
	var alone := field.get_memory_usage()
	var bodies: Array[AnimatableBody3D] = []
	for i in 100:
		bodies.append(add_held_body(ball(0.4), Vector3(2.6 * (i % 10) - 12.0, 0.2, 2.6 * floorf(i / 10.0) - 12.0)))
	await ticks(10)
	assert_greater(field.get_awake_tile_count(), 800)
	var crowded := field.get_memory_usage()
	assert_greater(crowded - alone, 800 * 30_000, "bytes: blades have state")
	for i in range(1, 100):
		bodies[i].free()
	await ticks(30)
	assert_less(field.get_awake_tile_count(), 40)
	assert_near(field.get_memory_usage(), crowded, 5e5, "bytes: who comes back soon finds it as it was")
	await ticks(220)
	assert_less(field.get_memory_usage() - alone, 0.2 * (crowded - alone), "bytes left")
	assert_greater(field.bend_at(bodies[0].position).length(), 0.1, "under the last one grass is bent as before")
	var low := field.get_memory_usage()
	await ticks(400)
	assert_eq(field.get_memory_usage(), low, "no coming and going")
	for i in 60:  # the crowd again
		bodies.append(add_held_body(ball(0.4), Vector3(2.6 * (i % 10) - 12.0, 0.2, 2.6 * floorf(i / 10.0) - 6.0)))
	await ticks(10)
	assert_greater(field.get_awake_tile_count(), 400)
	assert_true(all_finite(field, awake_near(field, bodies[-1].position)))


## Bodies that rest on the grass for long cost nothing but the look at where they are, until one moves.
func test_bodies_that_stand_still_cost_no_simulation() -> void:
	var field := add_field({natural_frequency = 2.0, damping_ratio = 0.6})
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
	assert_eq(after.still_tile_steps - before.still_tile_steps, 40 * before.awake_tiles)
	assert_eq(after.awake_tiles, before.awake_tiles)
	assert_greater(field.bend_at(bodies[0].position).length(), 0.05, "and the grass stays down")
	bodies[0].position.x += 0.05
	await ticks(2)
	var moved := field.get_counters()
	assert_less(moved.still_tiles, before.still_tiles)
	assert_greater(moved.still_tiles, 0, "the other one's")
	field.damping_ratio = 0.7
	await ticks(1)
	assert_eq(field.get_counters().still_tiles, 0, "other blades")
	for body in bodies:
		body.free()
	await ticks(240)
	assert_eq(field.get_awake_tile_count(), 0, "they have risen")


func test_a_scene_file_is_small() -> void:
	var root := Node3D.new()
	var field := GrassField.new()
	field.size = Vector2(500, 500)  # 64 million blades
	root.add_child(field)
	field.owner = root
	var scene := PackedScene.new()
	assert_eq(scene.pack(root), OK)
	var path := OS.get_user_data_dir().path_join("test_scene.tscn")
	assert_eq(ResourceSaver.save(scene, path), OK)
	assert_less(FileAccess.get_file_as_bytes(path).size(), 10_000, "bytes")
	DirAccess.remove_absolute(path)
	root.free()


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
