# SPDX-License-Identifier: MIT
## What a rule reads from the scene: excluding nodes, collision shapes, masks and vertex colours.
extends "res://tests/fill_case.gd"


func test_an_exclusion_node_that_moves_is_followed_where_it_was_and_is() -> void:
	var exclusion := _add_exclusion(box(Vector3(8, 2, 4)), Vector3(20, 0, 20))
	var field := await _add_filled(_rule())
	assert_eq(_density(field, 22, 20), 0.0)
	assert_eq(_density(field, 20, 23), 1.0)
	var cells: int = field.get_counters().fill_cells
	exclusion.position = Vector3(-40, 0.5, 100)
	exclusion.rotation.y = PI / 2
	await frames(2)
	assert_eq(_density(field, 22, 20), 1.0)
	assert_eq(_density(field, -40, 103), 0.0)
	assert_eq(_density(field, -37, 100), 1.0)
	assert_eq(field.get_counters().fill_cells, cells + 2 * CELLS_A_CHUNK)
	(exclusion.shape as BoxShape3D).size = Vector3(20, 2, 4)  # the shape itself
	await frames(2)
	assert_eq(_density(field, -40, 108), 0.0)
	exclusion.position.y = 4.0  # a bridge
	await frames(2)
	assert_eq(_density(field, -40, 100), 1.0)
	exclusion.position.y = 0.0
	exclusion.enabled = false
	await frames(2)
	assert_eq(_density(field, -40, 100), 1.0)
	exclusion.enabled = true
	exclusion.shape = null
	exclusion.outline = PackedVector2Array([Vector2(0, 0), Vector2(10, 0), Vector2(0, 10)])
	await frames(2)
	assert_eq(_density(field, -38, 98), 0.0, "turned by a quarter")
	assert_eq(_density(field, -42, 98), 1.0)
	exclusion.queue_free()
	await frames(3)
	assert_eq(_density(field, -38, 98), 1.0)


func test_collision_shapes_of_a_group_exclude_with_all_their_kinds() -> void:
	var house := add_body(StaticBody3D.new(), box(Vector3(6, 3, 6)), Vector3(30, 1.5, 0)) as StaticBody3D
	var wing := add_shape(house, SphereShape3D.new(), Transform3D(Basis(), Vector3(10, -1.5, 0)))
	(wing.shape as SphereShape3D).radius = 3.0
	var hull := ConvexPolygonShape3D.new()
	hull.points = PackedVector3Array([Vector3(-2, -1, -2), Vector3(2, -1, -2), Vector3(2, -1, 2), Vector3(-2, -1, 2), Vector3(0, 3, 0)])
	add_shape(house, hull, Transform3D(Basis(), Vector3(0, -0.5, 20)))
	var floor_plan := ConcavePolygonShape3D.new()
	floor_plan.set_faces(PackedVector3Array([Vector3(0, 0, 0), Vector3(8, 0, 0), Vector3(0, 0, 8)]))
	add_shape(house, floor_plan, Transform3D(Basis(), Vector3(-50, -1.5, 0)))
	add_shape(house, WorldBoundaryShape3D.new())  # ground: no obstacle
	house.add_to_group(&"grass_exclusion")
	var field := await _add_filled(_rule({exclusion_fade = 0.0}))
	assert_eq(_density(field, 30, 0), 0.0, "box")
	assert_eq(_density(field, 30, 5), 1.0)
	assert_eq(_density(field, 40, 2), 0.0, "sphere")
	assert_eq(_density(field, 30, 20), 0.0, "hull")
	assert_eq(_density(field, 27, 20), 1.0)
	assert_eq(_density(field, -18, 2), 0.0, "mesh")
	assert_eq(_density(field, -13, 7), 1.0)
	wing.position.x = 20.0
	await _follow()
	assert_eq(_density(field, 40, 2), 1.0)
	assert_eq(_density(field, 50, 2), 0.0)
	wing.disabled = true
	await _follow()
	assert_eq(_density(field, 50, 2), 1.0)
	house.remove_from_group(&"grass_exclusion")
	await _follow()
	assert_eq(_density(field, 30, 0), 1.0)


func test_a_distance_is_kept_from_nodes_and_along_paths() -> void:
	var tree := Node3D.new()
	tree.position = Vector3(10, 7, 10)
	var road := Path3D.new()
	road.curve = Curve3D.new()
	road.curve.add_point(Vector3(-60, 0, -20))
	road.curve.add_point(Vector3(60, 0, -20))
	for node: Node3D in [tree, road]:
		node.add_to_group(&"clear")
		add_child(node)
	var field := await _add_filled(_rule({distance_group = &"clear", distance = 3.0, distance_fade = 0.0}))
	assert_eq(_density(field, 12, 10), 0.0)
	assert_eq(_density(field, 14, 10), 1.0)
	assert_eq(_density(field, 20, -18), 0.0)
	assert_eq(_density(field, 20, -24), 1.0)
	road.curve.set_point_position(1, Vector3(60, 0, 60))
	await _follow()
	assert_eq(_density(field, 55, -20), 1.0)
	assert_eq(_density(field, 0, 20), 0.0)


func test_places_are_the_fields_own_wherever_it_stands() -> void:
	_add_exclusion(box(Vector3(4, 2, 4)), Vector3(1000, 50, 0))
	var field := await _add_filled(_rule(), {position = Vector3(1000, 50, 30), rotation = Vector3(0, PI / 2, 0)})
	assert_eq(field.get_density_at(Vector3(1000, 50, 0)), 0.0)
	assert_eq(field.get_density_at(Vector3(1005, 50, 0)), 1.0)
	field.position.z = 60.0
	await _follow()
	assert_eq(field.get_density_at(Vector3(1000, 50, 0)), 0.0)
	assert_eq(field.get_density_at(Vector3(1000, 50, 30)), 1.0)


func test_a_mask_is_read_from_its_texture() -> void:
	var image := Image.create_empty(2, 2, false, Image.FORMAT_RGBA8)
	image.set_pixel(1, 0, Color(1, 0, 0, 0))
	image.set_pixel(0, 1, Color(0, 0, 0, 1))
	var mask := ImageTexture.create_from_image(image)
	var rule := _rule({mask = mask})
	var field := await _add_filled(rule)
	assert_eq(_density(field, 100, -100), 1.0)
	assert_eq(_density(field, -100, 100), 0.0)
	rule.mask_channel = GrassFillRule.MASK_ALPHA
	await _follow()
	assert_eq(_density(field, 100, -100), 0.0)
	assert_eq(_density(field, -100, 100), 1.0)
	rule.mask_invert = true
	rule.mask_region = Rect2(0, 0, 40, 40)
	await _follow()
	assert_eq(_density(field, -100, -100), 0.0)
	assert_eq(_density(field, 5, 5), 1.0)
	assert_eq(_density(field, 5, 35), 0.0)
	var cells: int = field.get_counters().fill_cells
	mask.set_image(image)  # headless, the engine keeps the old picture: only that it is read again shows
	await _follow()
	assert_eq(field.get_counters().fill_cells, cells + 16 * CELLS_A_CHUNK)
	image.fill(Color(0, 0, 0, 0.5))
	rule.mask = ImageTexture.create_from_image(image)
	await _follow()
	assert_near(_density(field, 20, 20), 0.5, 0.01)
	var noise := NoiseTexture2D.new()  # without a noise there never is a picture
	rule.mask = noise
	await _follow()
	assert_eq(_density(field, 20, 20), 0.0)


func _colored_quad(left: Color, right: Color, size: float) -> ArrayMesh:
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	var half := size / 2
	arrays[Mesh.ARRAY_VERTEX] = PackedVector3Array(
		[Vector3(-half, 0, -half), Vector3(half, 0, -half), Vector3(half, 0, half), Vector3(-half, 0, half)]
	)
	arrays[Mesh.ARRAY_COLOR] = PackedColorArray([left, right, right, left])
	arrays[Mesh.ARRAY_INDEX] = PackedInt32Array([0, 1, 2, 0, 2, 3])
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	return mesh


func test_the_red_of_a_mesh_says_where_grass_grows() -> void:
	var ground := MeshInstance3D.new()
	ground.mesh = _colored_quad(Color.BLACK, Color.RED, 60.0)
	ground.add_to_group(&"meadow")
	add_child(ground)
	var field := await _add_filled(_rule({mask_group = &"meadow"}))
	assert_near(_density(field, 15, 0), 0.75, 0.01)
	assert_near(_density(field, -28, 10), 1.0 / 30.0, 0.01)
	assert_eq(_density(field, 40, 0), 0.0)
	ground.position.x = 100.0
	await _follow()
	assert_eq(_density(field, 15, 0), 0.0)
	assert_near(_density(field, 115, 0), 0.75, 0.01)
	var plane := PlaneMesh.new()  # without colours: all of it
	plane.size = Vector2(20, 20)
	ground.mesh = plane
	await _follow()
	assert_eq(_density(field, 105, 5), 1.0)
	assert_eq(_density(field, 115, 0), 0.0)


## A mesh that tells of its changes is read again by itself, and every mesh once the rule says that it has changed.
func test_a_mask_mesh_that_changes_itself_is_read_again() -> void:
	var plane := PlaneMesh.new()
	plane.size = Vector2(20, 20)
	var ground := MeshInstance3D.new()
	ground.mesh = plane
	ground.add_to_group(&"meadow")
	add_child(ground)
	var rule := _rule({mask_group = &"meadow"})
	var field := await _add_filled(rule)
	assert_eq([_density(field, 5, 0), _density(field, 35, 0)], [1.0, 0.0])
	plane.size = Vector2(80, 80)
	await _follow()
	assert_eq(_density(field, 35, 0), 1.0)
	var cells: int = field.get_counters().fill_cells
	plane.emit_changed()
	rule.emit_changed()
	await _follow()
	assert_eq(field.get_counters().fill_cells, cells, "nothing is filled again for a mesh that is the same")
	var quad := _colored_quad(Color.RED, Color.RED, 20.0)
	ground.mesh = quad
	await _follow()
	assert_eq([_density(field, 5, 0), _density(field, 35, 0)], [1.0, 0.0])
	plane.size = Vector2(90, 90)
	await _follow()
	assert_eq(_density(field, 35, 0), 0.0, "it is no longer in the group")
	var arrays := quad.surface_get_arrays(0)
	quad.clear_surfaces()
	for i: int in arrays[Mesh.ARRAY_VERTEX].size():
		arrays[Mesh.ARRAY_VERTEX][i] *= 4.0
	quad.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	await _follow()
	rule.emit_changed()
	await _follow()
	assert_eq(_density(field, 35, 0), 1.0)
	field.fill_rule = null
	await frames(2)
	assert_eq(plane.changed.get_connections().size() + quad.changed.get_connections().size(), 1, "only of the MeshInstance3D")


## A shape of another kind may have the same numbers.
func test_an_exclusion_whose_shape_becomes_another_kind() -> void:
	var capsule := CapsuleShape3D.new()
	capsule.radius = 4.0
	capsule.height = 20.0
	var cylinder := CylinderShape3D.new()
	cylinder.radius = 4.0
	cylinder.height = 20.0
	var exclusion := _add_exclusion(capsule, Vector3(0, 0, 0))
	exclusion.rotation.z = PI / 2
	var field := await _add_filled(_rule())
	assert_eq([_density(field, 0, 3), _density(field, 9.5, 3.5)], [0.0, 1.0], "its end is round")
	exclusion.shape = cylinder
	await frames(2)
	assert_eq([_density(field, 0, 3), _density(field, 9.5, 3.5)], [0.0, 0.0])
	exclusion.shape = capsule
	await frames(2)
	assert_eq([_density(field, 0, 3), _density(field, 9.5, 3.5)], [0.0, 1.0])
