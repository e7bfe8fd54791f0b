# SPDX-License-Identifier: MIT
## Plants with a scene: near eyes they have a node, where they are drawn; farther away, mown, painted away or hidden they have none.
extends "res://tests/plant_nodes_case.gd"


func test_plants_near_a_camera_have_a_node_where_they_are_drawn() -> void:
	var field := add_shrubs()
	await settled(field)
	var near := shrubs_within(field, camera.position, DISTANCE)
	assert_greater(near.size(), 50)
	assert_eq(sorted(nodes.keys()), sorted(near))
	for blade: int in nodes:
		var node: Node3D = nodes[blade]
		assert_near(node.global_position, root_of(field, blade), 1e-5)
		assert_near(node.global_basis.y.normalized(), Vector3.UP, 1e-5, "upright")
		var knots := field.get_blade_knots([blade])
		assert_near(node.global_basis.get_scale(), Vector3.ONE * length_of(knots, 0) / 1.25, 0.03, "as its length to the mean")
	assert_eq(field.get_counters().plant_nodes, nodes.size())


func test_scale_and_turn_are_those_of_the_drawn_mesh() -> void:
	var mesh := BoxMesh.new()
	mesh.size = Vector3(1, 2, 1)
	var array := ArrayMesh.new()
	var arrays := mesh.get_mesh_arrays()
	var points: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	for i in points.size():
		points[i].y += 1.0
	arrays[Mesh.ARRAY_VERTEX] = points
	array.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	var field := add_shrubs({}, shrub(shrub_scene(), {plant_mesh = array}))
	await settled(field)
	assert_greater(nodes.size(), 50)
	var turns := {}
	for blade: int in nodes:
		var node: Node3D = nodes[blade]
		var knots := field.get_blade_knots([blade])
		assert_near(node.global_basis.get_scale(), Vector3.ONE * length_of(knots, 0) / 2.0, 1e-3, "the mesh is 2 m high")
		assert_greater(node.global_basis.determinant(), 0.0)
		turns[roundi(rad_to_deg(node.global_basis.get_euler().y) / 30.0)] = true
	assert_greater(turns.size(), 8, "they are turned to all sides")


func test_a_field_elsewhere_turned_and_scaled_has_its_nodes_where_its_plants_are() -> void:
	var place := Transform3D(Basis(Vector3.UP, 0.7).scaled(Vector3(2, 2, 2)), Vector3(100, 20, -50))
	camera.position = place.origin + Vector3(0, 1.0, 0)
	var field := add_shrubs({transform = place})
	await settled(field)
	assert_greater(nodes.size(), 20)
	for blade: int in nodes:
		assert_near(nodes[blade].global_position, root_of(field, blade), 1e-4)
		assert_near(nodes[blade].global_basis.get_scale().x, length_of(field.get_blade_knots([blade]), 0) / 1.25, 0.03)
	var before := appeared.size()
	for node: Node3D in [field, camera]:
		node.position += Vector3(1000, 0, 500)  # a shift of the origin
	await settled(field)
	assert_eq(appeared.size(), before, "no plant came or went")
	assert_eq(left.size(), 0)
	for blade: int in nodes:
		assert_near(nodes[blade].global_position, root_of(field, blade), 1e-3)


func test_the_nearest_plants_within_the_budget_have_nodes() -> void:
	var field := add_shrubs({plant_nodes_max = 12})
	await settled(field)
	assert_eq(nodes.size(), 12)
	var by_distance := shrubs_within(field, camera.position, DISTANCE)
	by_distance.sort_custom(
		func(a: int, b: int) -> bool: return root_of(field, a).distance_to(camera.position) < root_of(field, b).distance_to(camera.position)
	)
	assert_eq(sorted(nodes.keys()), sorted(by_distance.slice(0, 12)))
	for step in 60:
		camera.position.x += 0.2
		await ticks(1)
		assert_less(field.get_counters().plant_nodes, 13)
	field.plant_nodes_max = 3
	await settled(field)
	assert_eq(nodes.size(), 3)
	field.plant_nodes_max = 0
	await settled(field)
	assert_eq(nodes.size(), 0)


func test_an_eye_that_trembles_changes_nothing() -> void:
	var field := add_shrubs({plant_nodes_max = 30})
	await settled(field)
	for step in 40:
		camera.position.x = 0.35 * (step % 2)  # farther than what is looked at again
		await ticks(2)
	assert_less(left.size(), 8, "plants that another one replaced")
	for blade: int in left:
		assert_eq(left[blade], 1, "none comes and goes")


func test_signals_are_balanced_and_nodes_are_reused() -> void:
	var field := add_shrubs()
	var made_at_first := 0
	for walk in 6:
		for step in 40:
			camera.position.x = (step if walk % 2 == 0 else 40 - step) * 0.3
			await ticks(1)
		await settled(field)
		if walk == 1:
			made_at_first = all_nodes.size()
	assert_greater(left.size(), 20)
	assert_less(all_nodes.size(), made_at_first + 6, "no new ones after the first walk to and fro")
	for blade: int in appeared:
		assert_eq(appeared[blade] - left.get(blade, 0), 1 if nodes.has(blade) else 0)
	for blade in shrubs_within(field, camera.position, DISTANCE):
		assert_true(nodes.has(blade), "no near plant was forgotten on the way")


func test_work_does_not_grow_with_the_field() -> void:
	var looked_at := {}
	for side: int in [60, 252]:  # metres; the larger one has a million blades, and 169,000 shrubs
		var field := add_shrubs({size = Vector2(side, side)})
		await settled(field)
		looked_at[side] = field.get_counters().stems_looked_at
		var steps: int = field.get_counters().plant_tiles_looked_at
		await ticks(20)
		assert_eq(field.get_counters().plant_tiles_looked_at, steps, "nothing while nothing moves")
		assert_eq(field.get_counters().stems_looked_at, looked_at[side])
		field.free()
		nodes.clear()
	assert_eq(looked_at[60], looked_at[252])
	assert_less(looked_at[252], 4000)


func test_an_eye_high_above_looks_at_nothing() -> void:
	camera.position.y = 2.0 * DISTANCE
	var field := add_shrubs()
	await ticks(20)
	assert_eq(field.get_counters().plant_tiles_looked_at, 0)


func test_work_of_a_tick_is_bounded() -> void:
	var field := add_shrubs({density = 1000.0}, shrub(shrub_scene(), {share = 0.0005, plant_scene_distance = 12.0}))
	var before := 0
	for tick in 60:
		await ticks(1)
		var now: int = field.get_counters().stems_looked_at
		assert_less(now - before, 64 * 49)
		before = now
	assert_greater(before, 100000, "and it goes on")


func test_cut_painted_and_hidden_plants_lose_their_nodes() -> void:
	var field := add_shrubs({map = full_map()})
	await grown(field)
	await settled(field)
	var all := nodes.size()
	assert_greater(all, 50)
	var deck := box(Vector3(4, 2, 4))
	field.cut(deck, Transform3D(Basis(), Vector3(3, 1.2, 0)))  # 0.2 m high
	await settled(field)
	assert_less(nodes.size(), all)
	for blade: int in nodes:
		var root := root_of(field, blade)
		assert_false(absf(root.x - 3.0) < 1.5 and absf(root.z) < 1.5, "no node where it is mown: %s" % root)
	var uncut := nodes.size()
	field.paint(brush(GrassBrush.TOOL_ERASE, 2.0), Vector3(-3, 0, 0), Vector3(-3, 0, 0))
	await settled(field)
	assert_less(nodes.size(), uncut)
	for blade: int in nodes:
		assert_greater(Vector2(-3, 0).distance_to(Vector2(root_of(field, blade).x, root_of(field, blade).z)), 1.5)
	field.regrow(2.0, 1.0)
	await settled(field)
	assert_greater(nodes.size(), uncut - 30, "what has grown again has its node again")
	field.visible = false
	await settled(field)
	assert_eq(nodes.size(), 0)
	assert_eq(field.get_counters().plant_nodes, 0)
	field.visible = true
	await settled(field)
	assert_greater(nodes.size(), 20)


func test_plants_follow_raised_ground() -> void:
	var field := add_shrubs({map = full_map()})
	await grown(field)
	await settled(field)
	var sheet := HeightMapShape3D.new()
	sheet.map_width = 41
	sheet.map_depth = 41
	var heights := PackedFloat32Array()
	heights.resize(41 * 41)
	heights.fill(1.5)
	sheet.map_data = heights
	field.bake_ground_from(sheet, Transform3D())
	await settled(field)
	assert_greater(nodes.size(), 30)
	for blade: int in nodes:
		assert_near(nodes[blade].global_position.y, 1.5, 0.01)
		assert_near(nodes[blade].global_position, root_of(field, blade), 1e-4)


func test_stems_with_one_root_have_one_node() -> void:
	var field := add_shrubs({}, shrub(shrub_scene(), {stems = 4, share = 0.2}))
	await settled(field)
	assert_greater(nodes.size(), 20)
	for blade: int in nodes:
		for other: int in nodes:
			assert_true(blade == other or root_of(field, blade).distance_to(root_of(field, other)) > 1e-3)
	assert_eq(field.get_counters().plant_nodes, nodes.size())


func test_a_body_is_stopped_by_a_shrub_and_its_grass_stays_at_rest() -> void:
	var field := add_shrubs({plant_nodes_max = 20})
	await settled(field)
	await ticks(30)
	assert_eq(field.get_awake_tile_count(), 0, "placing nodes wakes nothing")
	assert_eq(field.get_counters().woken, 0)
	assert_eq(field.get_body_count(), 0)
	var target: Vector3 = nodes.values()[0].global_position
	for blade: int in nodes:
		if root_of(field, blade).distance_to(camera.position) < target.distance_to(camera.position):
			target = root_of(field, blade)
	var bullet := RigidBody3D.new()
	bullet.gravity_scale = 0.0
	add_body(bullet, ball(0.1), target + Vector3(0.0, 0.5, 0.0) + Vector3(-1.2, 0, 0))
	bullet.linear_velocity = Vector3(4, 0, 0)
	await ticks(60)
	assert_less(bullet.position.x, target.x, "it has not passed the shrub")
	assert_greater(field.get_counters().woken, 0, "it bends what it meets")


func test_walking_wakes_nothing() -> void:
	var field := add_shrubs({plant_nodes_max = 30})
	for step in 100:
		camera.position.x = 0.1 * step
		await ticks(1)
	assert_greater(left.size(), 10)
	assert_eq(field.get_counters().woken, 0)
	assert_eq(field.get_counters().colliders, 0)


func test_characters_and_rolling_bodies_have_plants_around_them() -> void:
	camera.free()
	var field := add_shrubs({size = Vector2(60, 60)})
	await settled(field)
	assert_eq(nodes.size(), 0, "nobody is there")
	var player := CharacterBody3D.new()
	add_body(player, ball(0.3), Vector3(10, 0.5, 0))
	await ticks(20)
	await settled(field)
	assert_eq(sorted(nodes.keys()), sorted(shrubs_within(field, player.position, DISTANCE)))
	player.free()
	await ticks(20)
	await settled(field)
	assert_eq(nodes.size(), 0)
	var stone := RigidBody3D.new()
	stone.gravity_scale = 0.0
	stone.can_sleep = false
	add_body(stone, ball(0.1), Vector3(-10, 3.0, 0))
	await ticks(20)
	await settled(field)
	assert_greater(nodes.size(), 5)
	for blade: int in nodes:
		assert_less(root_of(field, blade).distance_to(stone.position), 4.6)


func test_bodies_of_plants_have_no_plants_around_them() -> void:
	var body := RigidBody3D.new()
	body.gravity_scale = 0.0
	body.can_sleep = false
	var field := add_shrubs({}, shrub(shrub_scene(body), {share = 0.02}))
	await settled(field)
	await ticks(30)
	await settled(field)
	assert_eq(sorted(nodes.keys()), sorted(shrubs_within(field, camera.position, DISTANCE)))
