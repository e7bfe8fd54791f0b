# SPDX-License-Identifier: MIT
## Meshes and height maps as shapes: static ones bend nothing, a moving trimesh is split into convex pieces.
extends "res://tests/field_case.gd"


func test_ground_shapes_bend_nothing() -> void:
	var field := add_field()
	add_body(StaticBody3D.new(), HeightMapShape3D.new(), Vector3.ZERO)
	add_body(StaticBody3D.new(), trimesh(BoxMesh.new()), Vector3.ZERO)
	await ticks(20)
	assert_eq(field.get_awake_tile_count(), 0)
	assert_eq(field.get_counters().mesh_pieces, 0, "ground is not split")


func trimesh(mesh: Mesh) -> ConcavePolygonShape3D:
	var shape := ConcavePolygonShape3D.new()
	shape.set_faces(mesh.get_faces())
	return shape


## Returns an upright ring, 4 m wide, whose hole is 3 m wide.
func ring() -> ConcavePolygonShape3D:
	var torus := TorusMesh.new()
	torus.inner_radius = 1.5
	torus.outer_radius = 2.0
	torus.rings = 24
	torus.ring_segments = 8
	return trimesh(torus)


## Its box would press all of it.
func test_a_trimesh_that_moves_bends_by_convex_pieces() -> void:
	var field := add_field({size = Vector2(7, 7), density = 64.0})
	var body := add_held_body(ring(), Vector3(0, 2.0, 0))
	var other := add_held_body(body.get_child(0).shape, Vector3(0, 0.25, 30))
	await ticks(30)
	var pieces: int = field.get_counters().mesh_pieces
	assert_greater(pieces, 3)
	assert_less(pieces, 9)
	assert_eq(field.get_awake_tile_count(), 0, "above the grass")
	for i in 40:
		body.position.y -= 0.05
		await ticks(1)
	await ticks(30)
	assert_eq(await collider_count(field), pieces)
	for place: Vector3 in [Vector3(1.75, 0, 0), Vector3(-1.75, 0, 0), Vector3(0, 0, 1.75), Vector3(0, 0, -1.75)]:
		assert_less(field.get_bend_at(place).y, -0.1, "below the ring at %s" % place)
	assert_near(field.get_bend_at(Vector3.ZERO).y, 0.0, 0.01, "in its hole")
	assert_true(all_finite(field, awake_tiles(field)))
	other.position.z = 3.0
	await ticks(30)
	assert_eq(field.get_counters().mesh_pieces, 2 * pieces, "another body with the same mesh")


func test_a_registered_trimesh_is_split_too() -> void:
	var field := add_field({size = Vector2(7, 7), density = 64.0})
	var node := Node3D.new()
	node.position.y = 0.25
	add_child(node)
	field.register_collider(node, ring())
	await ticks(3)
	assert_eq(field.get_counters().colliders, 1, "its box, at first")
	await ticks(20)
	assert_greater(field.get_counters().colliders, 3)
	assert_eq(field.get_counters().colliders, field.get_counters().mesh_pieces)
	await ticks(200)
	assert_near(field.get_bend_at(Vector3.ZERO).y, 0.0, 0.02, "in its hole grass stands again")
	assert_less(field.get_bend_at(Vector3(1.75, 0, 0)).y, -0.1, "below the ring")


func test_a_trimesh_of_too_many_faces_bends_by_its_box() -> void:
	var field := add_field()
	var sphere := SphereMesh.new()
	sphere.radial_segments = 200
	sphere.rings = 100
	var body := add_held_body(trimesh(sphere), Vector3(0, 0.6, 0))
	body.name = "Statue"
	expect_error("Statue': its ConcavePolygonShape3D moves and has more than 20000 faces")
	for i in 30:
		body.position.x += 0.01
		await ticks(1)
	assert_eq(await collider_count(field), 1)
	assert_eq(field.get_counters().mesh_pieces, 0)


func test_a_height_map_that_moves_is_told_of() -> void:
	var field := add_field()
	var ground := StaticBody3D.new()
	add_body(ground, HeightMapShape3D.new(), Vector3.ZERO)
	var body := add_held_body(HeightMapShape3D.new(), Vector3(0, 0.3, 0))
	body.name = "Barge"
	await ticks(10)  # while it stands nobody complains
	expect_error("Barge': it moves, but its HeightMapShape3D bends no grass")
	for i in 10:
		body.position.x += 0.05
		await ticks(1)
	assert_eq(field.get_awake_tile_count(), 0)
