# SPDX-License-Identifier: MIT
## Hulls that change in every tick, and those of a split trimesh, reach the GPU as they reach the CPU. A moving height map bends nothing.
extends "res://tests/field_case.gd"


func test_a_soft_ball_and_a_trimesh_bend_grass() -> void:
	var field := add_field({size = Vector2(8, 4)})
	await frames(2)
	await compiled(field)
	var sphere := SphereMesh.new()
	sphere.radial_segments = 16
	sphere.rings = 8
	var soft := SoftBody3D.new()
	soft.mesh = ArrayMesh.new()
	(soft.mesh as ArrayMesh).add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, sphere.get_mesh_arrays())
	soft.position = Vector3(-2, 1.6, 0.25)
	soft.pressure_coefficient = 1.0
	add_body(StaticBody3D.new(), WorldBoundaryShape3D.new(), Vector3.ZERO)
	var faces := ConcavePolygonShape3D.new()
	faces.set_faces(BoxMesh.new().get_faces())
	var tiles: Array[Vector2i] = [field.get_tile_at(soft.position), field.get_tile_at(Vector3(2, 0, 0.25))]
	var rest := [tile_knots(field, tiles[0]), tile_knots(field, tiles[1])]
	add_child(soft)
	var mesh := add_held_body(faces, Vector3(2, 2, 0.25))
	for i in 90:
		mesh.position.y = maxf(mesh.position.y - 0.05, 0.6)
		await ticks(1)
	assert_eq(field.get_statistics().backend, "GPU")
	assert_eq(field.get_counters().soft_bodies, 1)
	assert_eq(field.get_counters().mesh_pieces, 1, "a box is convex")
	for i in 2:
		assert_greater(farthest(tile_knots(field, tiles[i]), rest[i]), 0.2, "metres, tile %s" % tiles[i])
	assert_true(all_finite(field, tiles))


func test_a_height_map_that_moves_warns_and_bends_nothing() -> void:
	var field := add_field()
	await frames(2)
	await compiled(field)
	var body := add_held_body(HeightMapShape3D.new(), Vector3(0, 0.3, 0))
	body.name = "Barge"
	await ticks(10)
	expect_error("Barge': it moves, but its HeightMapShape3D bends no grass")
	for i in 10:
		body.position.x += 0.05
		await ticks(1)
	assert_eq(field.get_statistics().backend, "GPU")
	assert_eq(field.get_awake_tile_count(), 0)
