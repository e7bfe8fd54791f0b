# SPDX-License-Identifier: MIT
## A field on a terrain that is asked by the names of its methods (docs/guide/terrain.md): heights, holes, textures, changes, what it costs.
extends "res://tests/fill_case.gd"

const PlainTerrain := preload("res://tests/terrains/plain_terrain.gd")
const BulkTerrain := preload("res://tests/terrains/bulk_terrain.gd")
const Terrain3DLike := preload("res://tests/terrains/terrain_3d_like.gd")
const HTerrainLike := preload("res://tests/terrains/h_terrain_like.gd")
const Hills := preload("res://tests/terrains/hills.gd")
const QUERIES_A_FRAME := 16384
const ROW := 66  # places of the longest row


func add_terrain(terrain: Node) -> Node:
	terrain.name = "Terrain"
	add_child(terrain)
	return terrain


func hills_of(terrain: Node) -> Hills:
	return terrain.data.hills if terrain is Terrain3DLike else terrain.hills


func all_kinds() -> Array[Node]:
	return [PlainTerrain.new(), Terrain3DLike.new(), HTerrainLike.new(), HTerrainLike.new(true)]


func field_on(properties := {}) -> GrassField:
	var field := add_field({size = Vector2(40, 24), density = 10.0, terrain = NodePath("../Terrain")}.merged(properties, true))
	await read(field)
	return field


func counter(field: GrassField, key: String) -> int:
	return field.get_counters()[key]


## Frames until nothing of the terrain waits and the rule has followed.
func read(field: GrassField) -> void:
	await frames(1)
	await wait_until(
		func() -> bool:
			var now := field.get_statistics().merged(field.get_counters())
			return now.terrain_waiting == 0 and now.fill_waiting == 0 and now.map_waiting == 0 and not now.waiting,
		"the terrain is read"
	)


## How far the roots of some blades are from the hills, metres.
func off_the_hills(field: GrassField, hills: Hills, place := Vector3.ZERO) -> float:
	var most := 0.0
	var count := field.get_tiles()
	for x: int in [0, count.x / 3, count.x - 1]:
		for z: int in [0, count.y / 2, count.y - 1]:
			var root := field.get_knots(Vector2i(x, z), 20)[0] - place
			most = maxf(most, absf(root.y - hills.height(root.x, root.z)))
	return most


func remove(nodes: Array) -> void:
	for node: Node in nodes:
		node.free()


func test_grass_stands_on_every_kind_of_terrain() -> void:
	for terrain in all_kinds():
		add_terrain(terrain)
		var field := await field_on({position = Vector3(3, 5, -2), rotation = Vector3(0, 0.4, 0)})
		assert_less(off_the_hills(field, hills_of(terrain)), 0.05, str(terrain.get_script().resource_path))
		assert_near(field.map.base_density, 1.0, 0.0, "grass stands everywhere on the map that was made")
		remove([field, terrain])


func test_nothing_grows_in_a_hole() -> void:
	for terrain in all_kinds():
		hills_of(terrain).hole = Rect2(4, -4, 8, 8)
		if terrain is HTerrainLike:
			terrain.shape()
		add_terrain(terrain)
		var field := await field_on()
		var what: String = terrain.get_script().resource_path
		for at: Vector3 in [Vector3(8, 0, 0), Vector3(5.5, 0, -2.5), Vector3(10.5, 0, 2.5)]:
			assert_eq(field.density_at(at), 0.0, "%s, %s" % [what, at])
		for at: Vector3 in [Vector3(1, 0, 0), Vector3(15, 0, 0), Vector3(8, 0, 8)]:
			assert_near(field.density_at(at), 1.0, 0.01, "%s, %s" % [what, at])
		field.map.stroke(brush(GrassBrush.TOOL_PAINT, 3.0), Vector2(8, 0), Vector2(8, 0))
		await grown(field)
		assert_eq(field.density_at(Vector3(8, 0, 0)), 0.0, "painted")
		var answer := field.explain(Vector3(8, 0, 0))
		assert_eq(answer.reason, GrassField.REASON_HOLE, answer.text)
		assert_true(answer.text.contains("hole"), answer.text)
		assert_eq(field.cut(_box(Vector3(2, 4, 2)), Transform3D(Basis(), Vector3(8, hills_of(terrain).height(8, 0), 0))).volume, 0.0)
		remove([field, terrain])


func test_a_version_of_terrain_3d_whose_holes_have_heights() -> void:
	var terrain := Terrain3DLike.new()
	terrain.data.hills.hole = Rect2(4, -4, 8, 8)
	terrain.data.holes_have_heights = true
	add_terrain(terrain)
	var field := await field_on()
	assert_eq(field.density_at(Vector3(8, 0, 0)), 0.0)
	assert_near(field.density_at(Vector3(0, 0, 0)), 1.0, 0.01)


func test_beyond_a_terrains_border_nothing_grows() -> void:
	var terrain := add_terrain(HTerrainLike.new())  # 256 m wide
	var field := await field_on({position = Vector3(128, 0, 0)})
	assert_near(field.density_at(Vector3(124, 0, 0)), 1.0, 0.01)
	assert_eq(field.density_at(Vector3(132, 0, 0)), 0.0)
	terrain.position = Vector3(20, 3, 0)
	await frames(50)
	await read(field)
	assert_near(field.density_at(Vector3(132, 0, 0)), 1.0, 0.01, "the terrain was moved there")
	var ground := field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(0, 0))
	assert_near(ground, 3.0 + terrain.hills.height(108, 0), 0.05)


func test_textures_of_h_terrains_array_shader() -> void:
	var terrain := HTerrainLike.new()
	var data := terrain.get_data()
	data.indices = Image.create_empty(129, 129, false, Image.FORMAT_RGB8)
	data.weights = Image.create_empty(129, 129, false, Image.FORMAT_RG8)
	for y in 129:
		for x in 129:
			data.indices.set_pixel(x, y, Color8(2, 7, 9) if x < 64 else Color8(9, 2, 7))
			data.weights.set_pixel(x, y, Color8(20, 215, 0) if x < 64 else Color8(10, 20, 0))
	terrain.shader_type = "Array"
	add_terrain(terrain)
	var field := await field_on({fill_rule = _rule({texture_ids = PackedInt32Array([7])})})
	for x: int in [-10, 10]:
		assert_greater(_density(field, x, 0), 0.85, "it weighs most: as the second west of the middle, as the rest east of it")
	remove([field])
	terrain.shader_type = "Classic4"  # maps of another shader are left over
	field = await field_on({fill_rule = _rule({texture_ids = PackedInt32Array([7])})})
	assert_near(_density(field, -10, 0), 0.0, 0.01)


func test_a_rule_grows_grass_on_its_textures() -> void:
	for terrain in all_kinds():
		var hills := hills_of(terrain)
		hills.grass = Rect2(-100, -100, 100, 200)
		if terrain is not PlainTerrain:  # which tells one number only
			hills.path = Rect2(-10, -100, 4, 200)
		if terrain is HTerrainLike:
			terrain.shape()
		add_terrain(terrain)
		var field := await field_on({fill_rule = _rule({texture_ids = PackedInt32Array([1])})})
		var what: String = terrain.get_script().resource_path
		assert_near(_density(field, -15, 0), 1.0, 0.01, what)
		assert_near(_density(field, -8, 0), 1.0 if terrain is PlainTerrain else 0.25, 0.02, what + ", under a path")
		assert_near(_density(field, 8, 0), 0.0, 0.01, what)
		var answer := field.explain(Vector3(8, 0, 0))
		assert_eq(answer.reason, GrassField.REASON_FILL_TEXTURE, answer.text)
		assert_true(answer.text.contains("texture 0"), answer.text)
		field.fill_rule.texture_ids = PackedInt32Array([0, 1])
		await read(field)
		assert_near(_density(field, 8, 0), 1.0, 0.01, what)
		remove([field, terrain])


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


func test_heights_in_bulk() -> void:
	var terrain: BulkTerrain = add_terrain(BulkTerrain.new())
	terrain.hills.hole = Rect2(4, -4, 8, 8)
	var field := await field_on()
	assert_less(off_the_hills(field, terrain.hills), 0.05)
	assert_eq(field.density_at(Vector3(8, 0, 0)), 0.0)
	assert_less(20 * counter(field, "terrain_calls"), counter(field, "terrain_queries"), "a call for each row")


func test_normals_are_the_terrains_own() -> void:
	add_terrain(PlainTerrain.new())
	var field := await field_on()
	var normal := Vector3(-0.2, 1.0, -0.15).normalized()
	assert_near(field.map.sample(GrassMap.CHANNEL_NORMAL, Vector2(0.5, 0.5), 0), normal.x, 0.01)
	assert_near(field.map.sample(GrassMap.CHANNEL_NORMAL, Vector2(0.5, 0.5), 1), normal.z, 0.01)


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


func test_nodes_that_are_no_terrain_are_named() -> void:
	add_terrain(Node3D.new())
	expect_error("`terrain` is 'Terrain' (Node3D), which has neither a method get_height()")
	var field := add_field({terrain = NodePath("../Terrain")})
	await frames(2)
	get_node("Terrain").free()
	var wrong := GDScript.new()
	wrong.source_code = 'extends Node\nfunc get_height(_at: Vector3) -> String:\n\treturn "high"\n'
	wrong.reload()
	var terrain := Node.new()
	terrain.set_script(wrong)
	add_terrain(terrain)
	expect_error("get_height() of 'Terrain' returned String, not a number")
	field.terrain = NodePath("../Terrain")
	await frames(4)
	assert_eq(field.density_at(Vector3.ZERO), 0.0, "no height is a hole")


func test_a_rule_that_asks_for_textures_of_no_terrain() -> void:
	expect_error("`fill_rule` depends on textures (`texture_ids`)")
	var field := await _add_filled(_rule({texture_ids = PackedInt32Array([1])}))
	assert_near(_density(field, 0, 0), 1.0, 0.0)
	expect_error("`texture_ids` must be numbers of a terrain's textures, from 0 to 255, but one is 256.")
	field.fill_rule.texture_ids = PackedInt32Array([256])
	assert_eq(field.fill_rule.texture_ids, PackedInt32Array([1]))


func test_a_tilted_field_says_so() -> void:
	add_terrain(PlainTerrain.new())
	expect_error("the field is tilted")
	var field := add_field({terrain = NodePath("../Terrain"), rotation = Vector3(0.2, 0, 0)})
	await frames(3)
	assert_eq(counter(field, "terrain_queries"), 0)
