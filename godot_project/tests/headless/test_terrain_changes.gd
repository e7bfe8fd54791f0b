# SPDX-License-Identifier: MIT
## What is read from a terrain, and when: its changes, a limited number of places a frame, nothing while all is at rest.
extends "res://tests/terrain_case.gd"

const QUERIES_A_FRAME := 16384
const ROW := 66  # places of the longest row


func test_textures_that_change_fill_again_where_they_did() -> void:
	var terrain := add_terrain(Terrain3DLike.new())
	var field := await field_on({size = Vector2(128, 128), fill_rule = _rule({texture_ids = PackedInt32Array([1])})})
	assert_near(_density(field, 30, 30), 0.0, 0.01)
	var cells := counter(field, "fill_cells")
	var queries := counter(field, "terrain_queries")
	terrain.data.hills.grass = Rect2(28, 28, 4, 4)
	terrain.data.maps_edited.emit(AABB(Vector3(28, 0, 28), Vector3(4, 0, 4)))
	terrain.data.maps_changed.emit()
	await read(field)
	assert_near(_density(field, 30, 30), 1.0, 0.01)
	assert_eq(counter(field, "fill_cells") - cells, CELLS_A_CHUNK, "one chunk")
	assert_less(counter(field, "terrain_queries") - queries, 15 * 15, "the edited area")


func test_an_edit_is_noticed_and_only_its_area_is_read() -> void:
	for terrain in all_kinds():
		add_terrain(terrain)
		var field := await field_on()
		var hills := hills_of(terrain)
		var queries := counter(field, "terrain_queries")
		hills.bump = 3.0
		hills.bump_area = Rect2(-4, -4, 8, 8)
		if terrain is PlainTerrain:
			terrain.terrain_changed.emit(AABB(Vector3(-4, 0, -4), Vector3(8, 20, 8)))
		elif terrain is Terrain3DLike:
			terrain.data.maps_edited.emit(AABB(Vector3(-4, 0, -4), Vector3(8, 0, 8)))
		else:
			terrain.shape()
			terrain.get_data().tell_of(Rect2i(61, 61, 6, 6))
		await read(field)
		var what: String = terrain.get_script().resource_path
		assert_near(field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(0.5, 0.5)), hills.height(0.5, 0.5), 0.02, what)
		var side := 10 if terrain is HTerrainLike else 8  # texels of its four corners, each in a chunk of its own, and those around
		assert_eq(counter(field, "terrain_queries") - queries, 4 * side * side, what)
		remove([field, terrain])


func test_all_is_read_again_where_a_terrain_does_not_say_where() -> void:
	var terrain := add_terrain(Terrain3DLike.new())
	var field := await field_on()
	for change: Callable in [terrain.data.maps_changed.emit, field.terrain_changed]:
		terrain.data.hills.bump += 2.0
		terrain.data.hills.bump_area = Rect2(-400, -400, 800, 800)
		change.call()
		await read(field)
		assert_less(off_the_hills(field, terrain.data.hills), 0.05)
	var queries := counter(field, "terrain_queries")
	field.terrain_changed(AABB(Vector3(0, 0, 0), Vector3(2, 0, 2)))
	await read(field)
	assert_eq(counter(field, "terrain_queries") - queries, 100, "2 m, 2 m around them, and those around in four chunks")
	expect_error("terrain_changed() needs a finite area")
	field.terrain_changed(AABB(Vector3(NAN, 0, 0), Vector3(2, 0, 2)))
	await frames(1)


func test_places_of_a_frame_are_bounded_and_the_nearest_come_first() -> void:
	var terrain: PlainTerrain = add_terrain(PlainTerrain.new())
	var camera := Camera3D.new()
	camera.position = Vector3(100, 30, 100)
	add_child(camera)
	var field := add_field({size = Vector2(256, 256), density = 1.0, terrain = NodePath("../Terrain")})
	var before := 0
	var most := 0
	while counter(field, "terrain_waiting") > 0 or before == 0:
		await frames(1)
		var now := counter(field, "terrain_queries")
		most = maxi(most, now - before)
		before = now
	assert_less(most, QUERIES_A_FRAME + 2 * ROW + 1)
	assert_greater(before, 256 * 256)
	assert_less(before, 260 * 260 + 4 * 25 * 66, "each place once, and those around each chunk")
	assert_greater(counter(field, "terrain_calls"), before)
	var first := terrain.asked[0]
	assert_true(first.x >= 63 and first.z >= 63, "the chunk under the camera: %s" % first)


func test_a_field_at_rest_asks_nothing() -> void:
	add_terrain(PlainTerrain.new())
	var field := await field_on()
	var calls := counter(field, "terrain_calls")
	await frames(40)
	assert_eq(counter(field, "terrain_calls"), calls)


func test_a_shifted_origin_asks_nothing_and_a_field_that_moves_alone_does() -> void:
	var terrain: PlainTerrain = add_terrain(PlainTerrain.new())
	var field := await field_on()
	await frames(20)
	var calls := counter(field, "terrain_calls")
	var shift := Vector3(-512, 8, 256)
	terrain.position += shift
	field.position += shift
	await frames(50)
	assert_eq(counter(field, "terrain_calls"), calls)
	assert_less(off_the_hills(field, terrain.hills, shift), 0.05)
	field.position += Vector3(30, 1, 0)
	await frames(50)
	await read(field)
	assert_less(off_the_hills(field, terrain.hills, shift), 0.05)


func test_another_map_and_another_size_are_laid_too() -> void:
	var terrain: PlainTerrain = add_terrain(PlainTerrain.new())
	var field := await field_on()
	field.map = full_map()
	await read(field)
	assert_less(off_the_hills(field, terrain.hills), 0.05)
	field.size = Vector2(100, 24)
	await frames(20)
	await read(field)
	assert_less(off_the_hills(field, terrain.hills), 0.05)


func test_a_terrain_that_comes_late_and_goes() -> void:
	expect_error("`terrain` is '../Terrain', which is not a node of the scene")
	var field := add_field({size = Vector2(40, 24), density = 10.0, terrain = NodePath("../Terrain")})
	await frames(3)
	var terrain: PlainTerrain = add_terrain(PlainTerrain.new())
	await frames(20)
	await read(field)
	assert_less(off_the_hills(field, terrain.hills), 0.05)
	var hills := terrain.hills
	terrain.free()
	await frames(20)
	assert_less(off_the_hills(field, hills), 0.05, "the ground stays")
	field.terrain = NodePath()
	assert_eq(counter(field, "terrain_waiting"), 0)
