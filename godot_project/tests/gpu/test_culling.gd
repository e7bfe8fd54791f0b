# SPDX-License-Identifier: MIT
## Which tiles are drawn, and at what detail. Nothing is chosen or uploaded where nothing changes.
extends "res://tests/view_case.gd"

# From, at: within, above, along an edge, from afar.
const VIEWS: Array[Array] = [
	[Vector3(0, 1, 3), Vector3(0, 0, 0)],
	[Vector3(0, 3, 0), Vector3(0, 0, 0)],
	[Vector3(1.5, 0.4, 1.5), Vector3(-2, 0.2, 1.9)],
	[Vector3(20, 8, 20), Vector3(0, 0, 0)],
	[Vector3(0.2, 0.5, -0.1), Vector3(4, 0.3, -3)],
]


## Returns tiles in view by the planes that the camera tells, for blades that lean `overhang` metres out of their tile and up to `height`.
func count_in_view(field: GrassField, overhang: float, height: float) -> int:
	var count := 0
	var half := Vector3(0.5 * field.get_tile_size() + overhang, 0.5 * height, 0.5 * field.get_tile_size() + overhang)
	var tiles := field.get_grid_size()
	for z in tiles.y:
		for x in tiles.x:
			var middle := field.to_local(field.get_tile_center(Vector2i(x, z))) + Vector3(0, 0.5 * height, 0)
			var inside := true
			for plane: Plane in camera.get_frustum():
				var normal := field.global_basis.inverse() * plane.normal
				inside = inside and plane.distance_to(field.to_global(middle)) <= normal.abs().dot(half)
			count += int(inside)
	return count


func test_draws_the_tiles_in_view() -> void:
	var gpu := add_seen_field({soil_enabled = false})  # blades do not end far away
	var cpu := add_seen_field({soil_enabled = false, backend = GrassField.BACKEND_CPU})
	var counts := {}
	for turn: Vector3 in [Vector3.ZERO, Vector3(0.1, 0.7, -0.05)]:
		gpu.rotation = turn
		cpu.rotation = turn
		for view in VIEWS:
			look(view[0], view[1])
			await drawn()
			var count: int = gpu.get_statistics().drawn_tiles
			counts[count] = true
			var where := "from %s, turned %s" % [view[0], turn]
			assert_eq(count, cpu.get_statistics().drawn_tiles, "GPU and CPU " + where)
			assert_true(
				count >= count_in_view(gpu, 0.0, 0.1), "%d drawn, at least %d in view %s" % [count, count_in_view(gpu, 0.0, 0.1), where]
			)
			assert_true(
				count <= count_in_view(gpu, 1.0, 1.0), "%d drawn, at most %d in view %s" % [count, count_in_view(gpu, 1.0, 1.0), where]
			)
			assert_eq(gpu.get_statistics().drawn_blades, cpu.get_statistics().drawn_blades, "blades " + where)
			assert_eq(gpu.get_statistics().drawn_triangles, cpu.get_statistics().drawn_triangles, "triangles " + where)
	assert_greater(counts.size(), 3, "the views differ")
	assert_eq(gpu.get_statistics().backend, "GPU")


func test_draws_nothing_when_looking_away() -> void:
	var field := add_seen_field()
	await drawn()
	assert_greater(field.get_statistics().drawn_tiles, 0)
	look(Vector3(0, 1, 3), Vector3(0, 1, 10))
	await drawn()
	assert_eq(field.get_statistics().drawn_tiles, 0)
	assert_eq(field.get_statistics().drawn_triangles, 0)


func test_shadow_margin_draws_more() -> void:
	var field := add_seen_field({cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_ON, shadow_margin = 0.0})
	camera.fov = 15.0
	look(Vector3(0, 3, 0), Vector3.ZERO)
	await drawn()
	var without: int = field.get_counters().shadow_tiles
	var seen_tiles: int = field.get_statistics().drawn_tiles
	assert_eq(without, seen_tiles, "no light, no margin: what is seen casts")
	field.shadow_margin = 1.0
	await drawn()
	assert_greater(field.get_counters().shadow_tiles, without)
	assert_eq(field.get_statistics().drawn_tiles, seen_tiles, "not in the picture")


func test_nothing_changes_nothing_is_done() -> void:
	for backend: GrassField.BackendMode in [GrassField.BACKEND_AUTO, GrassField.BACKEND_CPU]:
		var field := add_seen_field({wind_speed = 3.0, backend = backend})
		await drawn()
		var before := field.get_counters()
		assert_greater(before.culls, 0)
		await frames(20)
		var after := field.get_counters()
		assert_eq(after.culls, before.culls)
		assert_eq(after.uploaded_bytes, before.uploaded_bytes)
		assert_eq(after.steps, before.steps)
		camera.position.x += 0.1
		await drawn()
		assert_eq(field.get_counters().culls, before.culls + 1, "one for the camera's one move")
		assert_eq(field.get_counters().uploaded_bytes > before.uploaded_bytes, backend == GrassField.BACKEND_AUTO)
		field.pixels_min = 3.0
		await drawn()
		assert_eq(field.get_counters().culls, before.culls + 2, "one for the level of detail")
		field.free()


func test_a_still_body_uploads_little() -> void:
	var field := add_seen_field()
	var body := AnimatableBody3D.new()
	add_shape(body, ball(0.2))
	body.position = Vector3(0.25, 0.2, 0.25)
	viewport.add_child(body)
	await ticks(30)
	assert_greater(field.get_awake_tile_count(), 0)
	var before := field.get_counters()
	await ticks(30)
	var after := field.get_counters()
	assert_greater(after.steps, before.steps + 25)
	assert_eq(after.uploaded_bytes, before.uploaded_bytes, "the records do not change")
	assert_eq(after.culls, before.culls)


func test_less_is_drawn_far_away() -> void:
	var field := add_seen_field({pixels_min = 0.1, lod_error = 0.1, lod_far = 40.0})
	var last_triangles := INF
	var last_blades := INF
	for distance: float in [0.6, 3.5, 9.0, 26.0, 60.0]:
		look(Vector3(0, distance, 0), Vector3.ZERO)
		await drawn()
		var now := field.get_statistics()
		if not assert_greater(now.drawn_tiles, 0):
			return
		var triangles: float = float(now.drawn_triangles) / now.drawn_tiles
		var blades: float = float(now.drawn_blades) / now.drawn_tiles
		assert_less(triangles, last_triangles, "triangles a tile at %s m" % distance)
		assert_true(blades <= last_blades, "blades a tile at %s m" % distance)
		last_triangles = triangles
		last_blades = blades
	assert_less(last_blades, 20.0, "blades a tile from afar")


func test_a_huge_field_is_drawn() -> void:
	var field := add_seen_field({size = Vector2(1200, 1200), lod_far = 20.0})  # 5.8 million tiles
	look(Vector3(0, 2, 0), Vector3(0, 0, -3))
	await drawn()
	assert_eq(field.get_blade_count(), 2400 * 2400 * 64)
	assert_greater(field.get_statistics().drawn_tiles, 10)
	look(Vector3(590, 2, 590), Vector3(600, 0, 600))
	await drawn()
	assert_greater(field.get_statistics().drawn_tiles, 10, "in the corner, the last tiles")


func test_hidden_and_without_a_camera() -> void:
	var field := add_seen_field()
	await drawn()
	field.hide()
	camera.position.x += 1.0
	var culls: int = field.get_counters().culls
	await drawn()
	assert_eq(field.get_counters().culls, culls, "hidden")
	field.show()
	await drawn()
	assert_greater(field.get_counters().culls, culls, "shown")
	viewport.remove_child(camera)
	culls = field.get_counters().culls
	await drawn()
	assert_eq(field.get_counters().culls, culls, "no camera")
	viewport.add_child(camera)
	camera.position.x += 1.0
	await drawn()
	assert_greater(field.get_statistics().drawn_tiles, 0)


func test_blades_end_where_the_ground_carries_them() -> void:
	var properties := {size = Vector2(80, 80), density = 64.0}
	var gpu := add_seen_field(properties)
	var cpu := add_seen_field(properties.merged({backend = GrassField.BACKEND_CPU}))
	look(Vector3(0, 5, 40), Vector3(0, 0, 34))
	await drawn()
	var ended: int = gpu.get_statistics().drawn_tiles
	assert_greater(ended, 0)
	for number: String in ["drawn_tiles", "drawn_blades", "drawn_triangles"]:
		assert_eq(gpu.get_statistics()[number], cpu.get_statistics()[number], "GPU and CPU: " + number)
	gpu.soil_enabled = false
	await drawn()
	assert_greater(gpu.get_statistics().drawn_tiles, 3 * ended, "without ground they go on")
	gpu.soil_enabled = true
	camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	camera.size = 100.0
	await drawn()
	var all: int = gpu.get_statistics().drawn_tiles
	gpu.soil_enabled = false
	await drawn()
	assert_eq(gpu.get_statistics().drawn_tiles, all, "an orthogonal camera sees all")
