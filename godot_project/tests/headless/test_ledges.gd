# SPDX-License-Identifier: MIT
## Baked ground with edges: the test compares the root of each blade with what a ray from above hits there.
extends "res://tests/field_case.gd"

const LedgeScene = preload("res://tests/ledge_scene.gd")
const OFF := 0.03  # metres from the ground at which a blade counts as hanging or buried


## Returns how many of the field's standing blades are off the ground, and how many stand.
func count_off(field: GrassField) -> Vector2i:
	var space := field.get_world_3d().direct_space_state
	var query := PhysicsRayQueryParameters3D.new()
	var blades := field.find_blades(field.global_position, 2.0 * LedgeScene.HALF)
	var knots := field.get_blade_knots(blades)
	var off := 0
	for blade in blades.size():
		var root := knots[blade * KNOTS]
		query.from = Vector3(root.x, 100, root.z)
		query.to = Vector3(root.x, -100, root.z)
		var hit := space.intersect_ray(query)
		if not hit or absf(hit.position.y - root.y) > OFF:
			off += 1
	return Vector2i(off, blades.size())


func test_no_blade_hangs_or_is_buried_however_a_level_lies() -> void:
	var random := RandomNumberGenerator.new()
	random.seed = 11
	for scene in 6:
		var level := Node3D.new()
		add_child(level)
		var turn := 0.0 if scene < 2 else random.randf() * TAU
		LedgeScene.add_to(level, Vector2(random.randf(), random.randf()), turn)
		await ticks(2)
		var field := add_field({size = Vector2(26, 26), density = 128.0})
		field.bake_ground()
		await seen()
		await grown(field)
		var count := count_off(field)
		print("    level %d: %d of %d blades are off the ground" % [scene, count.x, count.y])
		assert_less(float(count.x), 0.001 * count.y, "level %d" % scene)
		assert_greater(count.y, int(0.85 * 128 * 26 * 26), "and grass stands nearly everywhere")
		field.free()
		level.free()
		await ticks(2)


func test_a_ledge_is_an_answer_and_follows_its_property() -> void:
	LedgeScene.add_box(self, Vector3(0, -0.5, 0), Vector3(20, 1, 20))
	LedgeScene.add_box(self, Vector3(0.3, 0.5, 0.4), Vector3(4, 1, 3))
	await ticks(2)
	var field := add_field({size = Vector2(12, 12)})
	field.bake_ground()
	await seen()
	var edge := Vector3(2.3, 0, 0.1)
	assert_eq(field.explain(edge).reason, GrassField.REASON_LEDGE)
	assert_near(field.get_density_at(edge), 0.0, 0.0)
	assert_near(field.map.sample(GrassMap.CHANNEL_LEDGE, Vector2(edge.x, edge.z)), 0.0, 0.0)
	assert_near(field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(2.1, 0.1)), 1.0, 0.001, "on the block")
	assert_near(field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(2.5, 0.1)), 0.0, 0.001, "beside it")
	assert_eq(field.explain(Vector3(2.6, 0, 0.1)).reason, GrassField.REASON_NONE)
	var before := field.map.get_data()
	field.bake_ground()
	assert_eq(field.map.get_data(), before, "the same again")
	assert_near(field.ledge_slope, 70.0, 0.0)
	var other := GrassMap.new()
	other.data = before
	assert_eq(other.get_data(), before, "saved and loaded")


func test_shapes_and_pictures_of_heights_have_the_edges_of_rays() -> void:
	var faces := PackedVector3Array()
	for quad: Array in [[-10.0, 2.3, 0.0], [2.3, 10.0, 1.5]]:
		var a := Vector3(quad[0], quad[2], -10)
		var b := Vector3(quad[1], quad[2], -10)
		var c := Vector3(quad[1], quad[2], 10)
		var d := Vector3(quad[0], quad[2], 10)
		faces.append_array([a, b, c, a, c, d])
	var shape := ConcavePolygonShape3D.new()
	shape.set_faces(faces)
	var field := add_field({size = Vector2(12, 12)})
	assert_eq(field.bake_ground_from(shape, Transform3D()), 16 * 16)
	var image := Image.create_empty(160, 160, false, Image.FORMAT_RF)
	for z in 160:
		for x in 160:
			image.set_pixel(x, z, Color(0.0 if x < 98 else 1.5, 0, 0))  # 12.5 cm a pixel; 98 * 0.125 - 10 = 2.25
	var map := full_map()
	assert_true(map.set_ground(image, Rect2(-10, -10, 20, 20)))
	for of: GrassMap in [field.map, map]:
		assert_near(of.sample(GrassMap.CHANNEL_GROUND, Vector2(2.0, 0.3)), 0.0, 0.001)
		assert_near(of.sample(GrassMap.CHANNEL_GROUND, Vector2(2.6, 0.3)), 1.5, 0.001)
		assert_near(of.sample(GrassMap.CHANNEL_LEDGE, Vector2(2.26, 0.3)), 0.0, 0.0)
