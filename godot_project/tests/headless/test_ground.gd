# SPDX-License-Identifier: MIT
## The ground under a field: read from rays and from shapes, read again where it moved, and bodies that roll down it.
extends "res://tests/hill_case.gd"


## Returns how far the roots of some tiles are from the hill, metres.
func off_the_hill(field: GrassField, up := 0.0) -> float:
	var most := 0.0
	var count := field.get_grid_size()
	for x: int in [0, 3, count.x / 2, count.x - 1]:
		for z: int in [0, count.y / 3, count.y - 1]:
			for blade: int in [0, 31, 63]:
				var root := field.get_knots(Vector2i(x, z), blade)[0]
				most = maxf(most, absf(root.y - hill_height(root.x, root.z) - up))
	return most


func test_roots_stand_on_what_rays_meet() -> void:
	add_hill()
	await ticks(2)
	var field := add_field({size = Vector2(16, 12), position = Vector3(2, 3, -1), rotation = Vector3(0, 0.6, 0)})
	await seen()
	assert_greater(off_the_hill(field), 1.0, "level, before")
	assert_eq(field.bake_ground(), 20 * 16, "two metres around the field: one that its blades blend with, one for the slopes there")
	await grown(field)
	assert_less(off_the_hill(field), 0.05)
	assert_near(field.map.base_density, 1.0, 0.0, "grass stands on, on the map that was made")


func test_a_tilted_field_is_baked_along_its_own_axis() -> void:
	var floor_shape := box(Vector3(40, 1, 40))
	add_body(StaticBody3D.new(), floor_shape, Vector3(0, -0.5, 0))
	await ticks(2)
	var field := add_field({size = Vector2(8, 8), position = Vector3(0, 0.5, 0), rotation = Vector3(0, 0, 0.3)})
	field.bake_ground()
	await seen()
	for x: int in [0, 7, 15]:
		assert_near(field.get_knots(Vector2i(x, 4), 10)[0].y, 0.0, 0.01, "column %d" % x)


func test_heights_of_shapes_are_those_of_rays() -> void:
	var hill := add_hill(Vector3(0.3, 0.7, 0.2))
	await ticks(2)
	var by_rays := add_field({size = Vector2(20, 20), rotation = Vector3(0.1, 0.4, 0.05)})
	var by_shape := add_field({size = Vector2(20, 20), rotation = Vector3(0.1, 0.4, 0.05)})
	var by_faces := add_field({size = Vector2(20, 20), rotation = Vector3(0.1, 0.4, 0.05)})
	assert_greater(by_rays.bake_ground(), 400)
	var node := shape_of(hill)
	assert_greater(by_shape.bake_ground_from(node.shape, node.global_transform), 400)
	var faces := ConcavePolygonShape3D.new()
	faces.set_faces(faces_of_hill())
	assert_greater(by_faces.bake_ground_from(faces, node.global_transform), 400)
	var off := 0.0
	var off_by_faces := 0.0
	for x in range(-9, 10, 2):
		for z in range(-9, 10, 2):
			for channel: GrassMap.Channel in [GrassMap.CHANNEL_GROUND, GrassMap.CHANNEL_NORMAL]:
				var exact := by_rays.map.sample(channel, Vector2(x, z))
				off = maxf(off, absf(by_shape.map.sample(channel, Vector2(x, z)) - exact))
				off_by_faces = maxf(off_by_faces, absf(by_faces.map.sample(channel, Vector2(x, z)) - exact))
	print("    heights of the shape are %.1f mm off those of rays, those of faces %.1f mm" % [1000 * off, 1000 * off_by_faces])
	assert_less(off, 0.006)
	assert_less(off_by_faces, 0.006)


func faces_of_hill() -> PackedVector3Array:
	var faces := PackedVector3Array()
	for z in range(-16, 16):
		for x in range(-16, 16):
			for corner: Vector2i in [Vector2i(0, 0), Vector2i(1, 0), Vector2i(0, 1), Vector2i(1, 0), Vector2i(1, 1), Vector2i(0, 1)]:
				var at := Vector2(x + corner.x, z + corner.y)
				faces.append(Vector3(at.x, hill_height(at.x, at.y), at.y))
	return faces


func test_what_moves_about_and_other_layers_are_no_ground() -> void:
	var hill := add_hill()
	add_held_body(ball(1.0), Vector3(2, 3, 0))
	var roof := box(Vector3(4, 0.1, 4))
	var over := add_body(StaticBody3D.new(), roof, Vector3(-4, 2, 0))
	over.collision_layer = 4
	await ticks(2)
	var field := add_field({size = Vector2(16, 12)})
	field.bake_ground(Rect2(), 1)
	await seen()
	assert_less(off_the_hill(field), 0.05)
	field.bake_ground(Rect2(), 5)
	assert_near(field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(-4, 0)), 2.05, 0.01, "the roof")
	hill.free()
	over.free()
	await ticks(2)
	assert_eq(field.bake_ground(), 0)
	assert_near(field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(-4, 0)), 2.05, 0.01, "what was there stays")


func test_ground_that_moved_is_baked_again() -> void:
	var hill := add_hill()
	await ticks(2)
	var field := add_field({size = Vector2(16, 12)})
	field.bake_ground()
	hill.position.y += 1.5
	await ticks(2)
	field.bake_ground(Rect2(-8, -6, 4, 4))
	await seen()
	assert_near(field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(-6.5, -4.5)) - hill_height(-6.5, -4.5), 1.5, 0.05, "in the region")
	assert_near(field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(4.5, 3.5)) - hill_height(4.5, 3.5), 0.0, 0.05, "beside it")
	field.bake_ground()
	await seen()
	assert_less(off_the_hill(field, 1.5), 0.05, "everywhere")
	field.position.y += 2.0
	field.bake_ground()
	await seen()
	assert_less(off_the_hill(field, 1.5), 0.05, "the field moved")


func test_bodies_roll_down_the_hillside() -> void:
	add_hill()
	await ticks(2)
	var field := add_field({size = Vector2(20, 12), pool_tiles = 512, sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 0.5})
	field.bake_ground()
	await seen()
	var bodies := let_go()
	var woken := {}
	var bent := [0.0, 0.0, 0.0]
	for i in 120:
		await ticks(1)
		for tile in awake_tiles(field):
			woken[tile] = true
		for body in bodies.size():
			bent[body] = maxf(bent[body], field.get_bend_at(bodies[body].position).length())
	for body in bodies.size():
		assert_less(bodies[body].position.x, 4.0, "body %d moves down" % body)
		assert_near(bodies[body].position.y, hill_height(bodies[body].position.x, bodies[body].position.z), 0.6, "on the ground")
		assert_greater(bent[body], 0.05, "body %d bends the grass" % body)
		assert_true(woken.has(field.get_tile_at(Vector3(bodies[body].position.x, 0, bodies[body].position.z))))
	assert_true(all_finite(field, awake_tiles(field)))
	for tile: Vector2i in woken:
		assert_less(field.get_tile_center(tile).x, 6.5, "nothing above where they were let go")
	for body in bodies:
		body.free()
	await ticks(120)
	assert_eq(field.get_awake_tile_count(), 0)


func test_what_cannot_be_baked() -> void:
	var field := GrassField.new()
	expect_error("add the node to the scene tree")
	assert_eq(field.bake_ground(), 0)
	field.free()
	field = add_field()
	await seen()
	expect_error("reads a HeightMapShape3D or a ConcavePolygonShape3D")
	assert_eq(field.bake_ground_from(ball(1.0), Transform3D()), 0)
	assert_eq(field.bake_ground_from(null, Transform3D()), 0)
	expect_error("needs a finite")
	assert_eq(field.bake_ground(Rect2(NAN, 0, 1, 1)), 0)
	assert_eq(field.bake_ground_from(HeightMapShape3D.new(), Transform3D(Basis(), Vector3(NAN, 0, 0))), 0)
	assert_eq(field.bake_ground_from(ConcavePolygonShape3D.new(), Transform3D()), 0, "no faces")
	assert_eq(field.bake_ground(), 0, "no ground")


## Adds a crate on a floor: on layers 1 and 5, the floor below a node that is in the group "ground".
func add_crate() -> GrassField:
	var land := Node3D.new()
	land.add_to_group(&"ground")
	add_child(land)
	var layers := {Vector3(0, -0.5, 0): [Vector3(40, 1, 40), 1 << 4, land], Vector3(0, 1, 0): [Vector3(4, 2, 4), 1, self]}
	for place: Vector3 in layers:
		var body := StaticBody3D.new()
		var shape := box(layers[place][0])
		add_shape(body, shape)
		body.collision_layer = layers[place][1]
		body.position = place
		layers[place][2].add_child(body)
	await ticks(2)
	return add_field({size = Vector2(12, 12)})


func test_grass_grows_on_what_is_ground_and_not_on_crates() -> void:
	var field := await add_crate()
	var baked := func() -> float:
		field.map = null
		return field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(0.5, 0.5)) if field.bake_ground() > 0 else NAN
	assert_near(baked.call(), 2.0, 0.02, "all bodies are ground, unless one says what is")
	field.ground_mask = 1 << 4
	assert_near(baked.call(), 0.0, 0.02, "below the crate")
	field.ground_mask = 1
	assert_near(baked.call(), 2.0, 0.02)
	assert_eq(field.bake_ground(Rect2(), 1 << 4), 0, "the layers of the call, of those of the field")
	field.ground_mask = 0xFFFFFFFF
	field.ground_group = &"ground"
	assert_near(baked.call(), 0.0, 0.02, "a node above the floor is in the group")
	field.ground_group = &"nobody"
	assert_true(is_nan(baked.call()), "nothing is in it")
