# SPDX-License-Identifier: MIT
## What a terrain gives to a field: heights, normals, holes, textures.
extends "res://tests/terrain_case.gd"


func test_grass_stands_on_every_kind_of_terrain() -> void:
	for terrain in all_kinds():
		add_terrain(terrain)
		var field := await field_on({position = Vector3(3, 5, -2), rotation = Vector3(0, 0.4, 0)})
		assert_less(off_the_hills(field, hills_of(terrain)), 0.05, str(terrain.get_script().resource_path))
		assert_near(field.map.base_density, 1.0, 0.0, "grass stands everywhere on the map that was made")
		remove([field, terrain])


## Their vertices lie at whole metres; the field's texels have their centres at half metres.
func test_rough_ground_of_terrain_addons_is_that_of_their_cells() -> void:
	for terrain: Node in [Terrain3DLike.new(), HTerrainLike.new()]:
		hills_of(terrain).rough = 0.5
		if terrain is HTerrainLike:
			terrain.shape()
		add_terrain(terrain)
		var field := await field_on({position = Vector3(3, 5, -2)})
		var most := 0.0
		for n in 2000:
			var at := Vector2(fmod(0.731 * n, 39.0) - 19.5, fmod(0.417 * n, 23.0) - 11.5)
			var there := Vector3(at.x + 3.0, 0.0, at.y - 2.0)
			var cell: Vector3 = terrain.get_internal_transform().affine_inverse() * there if terrain is HTerrainLike else there
			var exact: float = (
				4.0 * terrain.get_data().get_interpolated_height_at(cell) if terrain is HTerrainLike else terrain.data.get_height(there)
			)
			most = maxf(most, absf(5.0 + field.map.sample(GrassMap.CHANNEL_GROUND, at) - exact))
		print("    at most %.1f mm off %s" % [1000.0 * most, terrain.get_script().resource_path.get_file()])
		assert_less(most, 0.005, str(terrain.get_script().resource_path))
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
			assert_eq(field.get_density_at(at), 0.0, "%s, %s" % [what, at])
		for at: Vector3 in [Vector3(1, 0, 0), Vector3(15, 0, 0), Vector3(8, 0, 8)]:
			assert_near(field.get_density_at(at), 1.0, 0.01, "%s, %s" % [what, at])
		field.map.stroke(brush(GrassBrush.TOOL_PAINT, 3.0), Vector2(8, 0), Vector2(8, 0))
		await grown(field)
		assert_eq(field.get_density_at(Vector3(8, 0, 0)), 0.0, "painted")
		var answer := field.explain(Vector3(8, 0, 0))
		assert_eq(answer.reason, GrassField.REASON_HOLE, answer.text)
		assert_true(answer.text.contains("hole"), answer.text)
		assert_eq(field.cut(box(Vector3(2, 4, 2)), Transform3D(Basis(), Vector3(8, hills_of(terrain).height(8, 0), 0))).volume, 0.0)
		remove([field, terrain])


func test_a_version_of_terrain_3d_whose_holes_have_heights() -> void:
	var terrain := Terrain3DLike.new()
	terrain.data.hills.hole = Rect2(4, -4, 8, 8)
	terrain.data.holes_have_heights = true
	add_terrain(terrain)
	var field := await field_on()
	assert_eq(field.get_density_at(Vector3(8, 0, 0)), 0.0)
	assert_near(field.get_density_at(Vector3(0, 0, 0)), 1.0, 0.01)


func test_beyond_a_terrains_border_nothing_grows() -> void:
	var terrain := add_terrain(HTerrainLike.new())  # 256 m wide
	var field := await field_on({position = Vector3(128, 0, 0)})
	assert_near(field.get_density_at(Vector3(124, 0, 0)), 1.0, 0.01)
	assert_eq(field.get_density_at(Vector3(132, 0, 0)), 0.0)
	terrain.position = Vector3(20, 3, 0)
	await frames(50)
	await read(field)
	assert_near(field.get_density_at(Vector3(132, 0, 0)), 1.0, 0.01, "the terrain was moved there")
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


func test_heights_in_bulk() -> void:
	var terrain: BulkTerrain = add_terrain(BulkTerrain.new())
	terrain.hills.hole = Rect2(4, -4, 8, 8)
	var field := await field_on()
	assert_less(off_the_hills(field, terrain.hills), 0.05)
	assert_eq(field.get_density_at(Vector3(8, 0, 0)), 0.0)
	assert_less(20 * counter(field, "terrain_calls"), counter(field, "terrain_queries"), "a call for each row")


func test_normals_are_the_terrains_own() -> void:
	add_terrain(PlainTerrain.new())
	var field := await field_on()
	var normal := Vector3(-0.2, 1.0, -0.15).normalized()
	assert_near(field.map.sample(GrassMap.CHANNEL_NORMAL, Vector2(0.5, 0.5), 0), normal.x, 0.01)
	assert_near(field.map.sample(GrassMap.CHANNEL_NORMAL, Vector2(0.5, 0.5), 1), normal.z, 0.01)


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
	assert_eq(field.get_density_at(Vector3.ZERO), 0.0, "no height is a hole")


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
