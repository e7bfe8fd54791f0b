# SPDX-License-Identifier: MIT
## Soft bodies press grass by the bounds of their parts.
extends "res://tests/field_case.gd"


func mesh_of(primitive: PrimitiveMesh) -> ArrayMesh:
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, primitive.get_mesh_arrays())
	return mesh


func ball_mesh(radius: float) -> ArrayMesh:
	var sphere := SphereMesh.new()
	sphere.radius = radius
	sphere.height = 2.0 * radius
	sphere.radial_segments = 16
	sphere.rings = 8
	return mesh_of(sphere)


func cloth_mesh(side: float) -> ArrayMesh:
	var plane := PlaneMesh.new()
	plane.size = Vector2(side, side)
	plane.subdivide_width = 8
	plane.subdivide_depth = 8
	return mesh_of(plane)


func add_soft_body(mesh: Mesh, place: Vector3, properties := {}) -> SoftBody3D:
	var body := SoftBody3D.new()
	body.name = "Jelly"
	body.mesh = mesh
	body.position = place
	for property: String in properties:
		body.set(property, properties[property])
	add_child(body)
	return body


func add_floor() -> void:
	add_body(StaticBody3D.new(), WorldBoundaryShape3D.new(), Vector3.ZERO)


func test_a_soft_ball_falls_into_the_grass() -> void:
	var field := add_field({size = Vector2(8, 8)})
	var entered := []
	var exited := []
	field.body_entered_grass.connect(entered.append)
	field.body_exited_grass.connect(exited.append)
	add_floor()
	var body := add_soft_body(ball_mesh(0.5), Vector3(0.25, 2.5, 0.25), {pressure_coefficient = 1.0})
	await ticks(8)
	assert_eq(field.get_awake_tile_count(), 0, "it is still above the grass")
	assert_eq(field.get_counters().soft_bodies, 1, "and known")
	await ticks(120)
	assert_eq(field.get_counters().colliders, 8, "its parts")
	assert_less(field.get_bend_at(Vector3(0.25, 0, 0.25)).y, -0.3, "grass lies below it")
	assert_near(field.get_bend_at(Vector3(2, 0, 2)).y, 0.0, 0.01, "and stands beside it")
	assert_eq(entered, [body])
	assert_true(all_finite(field, awake_tiles(field)))
	body.free()
	await ticks(2)
	assert_eq(field.get_counters().soft_bodies, 0)
	await ticks_to_sleep(field)


## Moves a soft body by `way`: Jolt takes its transform as one of where its points are.
func shift(body: SoftBody3D, way: Vector3) -> void:
	PhysicsServer3D.soft_body_set_state(body.get_physics_rid(), PhysicsServer3D.BODY_STATE_TRANSFORM, Transform3D(Basis(), way))


## At 30 m/s, half a metre a tick.
func test_a_fast_soft_body_leaves_no_gap() -> void:
	var field := add_field({size = Vector2(16, 4), sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 60.0})
	var body := add_soft_body(ball_mesh(0.1), Vector3(-6, 0.3, 0.25))
	await ticks(6)
	for i in 24:
		shift(body, Vector3(0.5, 0, 0))
		await ticks(1)
	await ticks(2)
	var reached := PhysicsServer3D.soft_body_get_bounds(body.get_physics_rid()).get_center().x
	assert_greater(reached, 5.0)
	for i in 10:
		assert_true(field.is_tile_awake(field.get_tile_at(Vector3(-5.5 + i, 0, 0.25))), "at %s" % [-5.5 + i])
	assert_false(field.is_tile_awake(field.get_tile_at(Vector3(-7.8, 0, 0.25))), "behind it")


## Lying on the ground it is too thin to hold grass down, as a board of 2 cm is.
func test_cloth_presses_and_is_put_elsewhere() -> void:
	var field := add_field({size = Vector2(12, 4)})
	add_floor()
	var cloth := add_soft_body(cloth_mesh(1.0), Vector3(-4, 0.8, 0))
	var deepest := 0.0
	for i in 60:
		await ticks(1)
		deepest = minf(deepest, field.get_bend_at(Vector3(-4, 0, 0)).y)
	assert_less(deepest, -0.3, "it presses grass as it falls")
	shift(cloth, Vector3(8, 0.1, 0))
	await ticks(5)
	var x := PhysicsServer3D.soft_body_get_bounds(cloth.get_physics_rid()).get_center().x
	assert_greater(x, 2.0, "it is there")
	assert_false(field.is_tile_awake(field.get_tile_at(Vector3(0, 0, 0))), "the grass between stands")
	assert_true(field.is_tile_awake(field.get_tile_at(Vector3(minf(x, 5.5), 0, 0))))


## None of these may ask the server for what it does not have: that is an error, which fails the test.
func test_bodies_that_bend_nothing() -> void:
	var field := add_field()
	var far := add_soft_body(ball_mesh(0.3), Vector3(0, 50, 0))
	var other_layer := add_soft_body(ball_mesh(0.3), Vector3(0, 0.3, 0), {collision_layer = 2})
	expect_error("Failed to set transform")  # of the engine, for a body without a mesh
	var empty := SoftBody3D.new()
	add_child(empty)
	await ticks(10)
	assert_eq(field.get_counters().soft_bodies, 0)
	field.collision_mask = 2
	await ticks(3)
	assert_eq(field.get_counters().soft_bodies, 1)
	other_layer.process_mode = Node.PROCESS_MODE_DISABLED
	await ticks(5)
	assert_eq(field.get_counters().soft_bodies, 0, "it is out of the server")
	other_layer.process_mode = Node.PROCESS_MODE_INHERIT
	await ticks(5)
	assert_eq(field.get_counters().soft_bodies, 1)
	remove_child(other_layer)
	await ticks(5)
	assert_eq(field.get_counters().soft_bodies, 0)
	other_layer.free()
	far.free()


func test_a_body_gets_another_mesh() -> void:
	var field := add_field()
	add_floor()
	var body := add_soft_body(ball_mesh(0.5), Vector3(0.25, 0.6, 0.25))
	await ticks(10)
	body.mesh = mesh_of(PrismMesh.new())  # far fewer points
	await ticks(10)
	assert_eq(field.get_counters().soft_bodies, 1)
	assert_less(field.get_counters().colliders, 8, "fewer parts")
	body.mesh = ball_mesh(0.4)
	await ticks(10)
	assert_eq(field.get_counters().colliders, 8)
	body.mesh = null
	await ticks(10)
	assert_eq(field.get_counters().soft_bodies, 0)


## As pools of objects do: the server has no points of a body that was enabled without a mesh, whatever mesh it gets then. Asking for one is
## an error, which fails the test.
func test_a_body_from_a_pool() -> void:
	var field := add_field()
	add_floor()
	var body := add_soft_body(ball_mesh(0.5), Vector3(0.25, 0.6, 0.25))
	await ticks(10)
	assert_eq(field.get_counters().soft_bodies, 1)
	body.process_mode = Node.PROCESS_MODE_DISABLED
	await ticks(3)
	body.mesh = null
	await ticks(3)
	body.process_mode = Node.PROCESS_MODE_INHERIT
	await ticks(3)
	body.mesh = ball_mesh(0.4)
	await ticks(20)
	assert_eq(field.get_counters().soft_bodies, 0, "the server has it no more")
	body.process_mode = Node.PROCESS_MODE_DISABLED
	await ticks(3)
	body.process_mode = Node.PROCESS_MODE_INHERIT
	await ticks(10)
	assert_eq(field.get_counters().soft_bodies, 1, "enabled with its mesh")
	for i in 6:  # all in one tick
		body.process_mode = Node.PROCESS_MODE_DISABLED
		body.mesh = null
		body.process_mode = Node.PROCESS_MODE_INHERIT
		body.mesh = ball_mesh(0.3 + 0.02 * i)
		await ticks(2)
	assert_eq(field.get_counters().soft_bodies, 0)


func test_a_mesh_without_faces() -> void:
	var field := add_field()
	var body := add_soft_body(ball_mesh(0.5), Vector3(0.25, 0.6, 0.25))
	await ticks(5)
	body.mesh = ArrayMesh.new()
	await ticks(10)
	assert_eq(field.get_counters().soft_bodies, 0)
