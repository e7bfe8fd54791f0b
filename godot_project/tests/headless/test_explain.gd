# SPDX-License-Identifier: MIT
## Why there is no grass in a place.
extends "res://tests/fill_case.gd"


func check(field: GrassField, place: Vector3, reason: GrassField.Reason, words := "") -> Dictionary:
	var answer := field.explain(place)
	assert_eq(answer.reason, reason, "%s: %s" % [place, answer.text])
	assert_true(not words or answer.text.contains(words), "'%s' in '%s'" % [words, answer.text])
	return answer


func test_a_field_without_a_map() -> void:
	var field := add_field()
	var answer := check(field, Vector3.ZERO, GrassField.REASON_NONE, "grows here")
	assert_eq(answer.density, 1.0)
	assert_near(answer.height, field.get_height_at(Vector3.ZERO), 1e-6)
	assert_eq(answer.node, null)
	check(field, Vector3(3, 0, 0), GrassField.REASON_OUTSIDE, "`size`")
	check(field, Vector3(NAN, 0, 0), GrassField.REASON_OUTSIDE)
	field.hide()
	check(field, Vector3.ZERO, GrassField.REASON_HIDDEN)
	field.show()
	field.map = GrassMap.new()
	check(field, Vector3.ZERO, GrassField.REASON_MAP, "`base_density` is 0")


func test_what_a_camera_sees() -> void:
	var field := add_field()
	var camera := Camera3D.new()
	camera.position = Vector3(0, 1, 60)
	camera.far = 50.0
	add_child(camera)
	var answer := field.explain(Vector3.ZERO, camera)
	assert_eq(answer.reason, GrassField.REASON_TOO_FAR)
	assert_true(answer.text.contains("60 m") and answer.text.contains("50"), answer.text)
	camera.far = 100.0
	camera.cull_mask = 2
	assert_eq(field.explain(Vector3.ZERO, camera).reason, GrassField.REASON_LAYERS)
	field.layers = 2
	assert_eq(field.explain(Vector3.ZERO, camera).reason, GrassField.REASON_NONE)


func test_what_was_done_to_the_grass() -> void:
	var field := add_field({size = Vector2(40, 8), map = full_map()})
	await grown(field)
	var map := field.map
	for place: Array in [
		[GrassBrush.TOOL_ERASE, -15], [GrassBrush.TOOL_FLATTEN, -5], [GrassBrush.TOOL_HEIGHT, 5], [GrassBrush.TOOL_CUT, 15]
	]:
		var at := Vector2(place[1], 0)
		map.stroke(brush(place[0], 2.0, {target = 0.1 if place[0] == GrassBrush.TOOL_HEIGHT else 1.0, cut_height = 0.04}), at, at)
	check(field, Vector3(-15, 0, 0), GrassField.REASON_PAINTED, "No grass")
	check(field, Vector3(-5, 0, 0), GrassField.REASON_WORN, "trampled")
	check(field, Vector3(5, 0, 0), GrassField.REASON_SHORT, "10 %")
	check(field, Vector3(15, 0, 0), GrassField.REASON_CUT, "4 cm")
	check(field, Vector3(0, 0, 0), GrassField.REASON_NONE)


func test_the_condition_and_the_node_of_a_rule() -> void:
	var exclusion := _add_exclusion(box(Vector3(8, 2, 8)), Vector3(20, 0, 20))
	exclusion.name = "Yard"
	var map := GrassMap.new()
	var heights := Image.create_empty(64, 64, false, Image.FORMAT_RF)
	for z in 64:
		for x in 64:
			heights.set_pixel(x, z, Color(maxf(0.0, 2.0 * (20.0 - x)), 0, 0))
	map.set_ground(heights, Rect2(-128, -128, 256, 256))
	var rule := _rule({slope_max = 15.0})
	var field := await _add_filled(rule, {map = map})
	var answer := check(field, Vector3(20, 0, 20), GrassField.REASON_FILL_NODE, "GrassExclusion3D 'Yard'")
	assert_eq(answer.node, exclusion)
	check(field, Vector3(-100, 0, 0), GrassField.REASON_FILL_SLOPE, "`slope_max` 15")
	rule.slope_max = 90.0
	rule.height_max = 10.0
	await _follow()
	check(field, Vector3(-100, 0, 0), GrassField.REASON_FILL_HEIGHT, "`height_max` 10")
	rule.height_max = 16384.0
	rule.density = 0.5
	await _follow()
	check(field, Vector3(100, 0, 0), GrassField.REASON_FILL_DENSITY, "50 %")
	rule.density = 1.0
	rule.noise_cover = 0.0
	await _follow()
	check(field, Vector3(100, 0, 0), GrassField.REASON_FILL_NOISE)
	rule.noise_cover = 1.0
	rule.mask = ImageTexture.create_from_image(Image.create_empty(2, 2, false, Image.FORMAT_RGBA8))
	await _follow()
	check(field, Vector3(100, 0, 0), GrassField.REASON_FILL_MASK, "`mask`")
	rule.mask = null
	rule.mask_group = &"nobody"
	await _follow()
	check(field, Vector3(100, 0, 0), GrassField.REASON_FILL_MESH, "`mask_group`")
	rule.mask_group = &""
	await _follow()
	check(field, Vector3(100, 0, 0), GrassField.REASON_NONE)
	_erase(map, Vector2(100, 0), 3.0)
	check(field, Vector3(100, 0, 0), GrassField.REASON_PAINTED)


func test_what_keeps_grass_from_bending() -> void:
	var field := add_field({pool_tiles = 1})
	add_held_body(ball(0.2), Vector3(1.2, 0.2, 1.2))
	await ticks(5)
	assert_eq(field.get_awake_tile_count(), 1)
	var answer := check(field, Vector3(-1.2, 0, -1.2), GrassField.REASON_NONE, "`pool_tiles`")
	assert_true(answer.still)
	assert_false(field.explain(field.get_tile_center(awake_tiles(field)[0])).still, "the awake one")
	field.simulated = false
	check(field, Vector3.ZERO, GrassField.REASON_NONE, "`simulated`")


func test_outside_of_the_tree() -> void:
	var field := GrassField.new()
	expect_error("add the node to the scene tree")
	assert_eq(field.explain(Vector3.ZERO), {})
	field.free()
