# SPDX-License-Identifier: MIT
## GrassPath3D and GrassExclusion3D on fields without a rule, which grow everywhere, minus them.
extends "res://tests/fill_case.gd"


func test_a_house_and_a_path_clear_a_field_without_rule_and_map() -> void:
	var house := _add_exclusion(box(Vector3(8, 2, 4)), Vector3(20, 0, 20))
	var path := _add_path(Vector3(-30, 5, 0))
	var field := await _add_filled(null)
	assert_eq(field.get_density_at(Vector3(22, 0, 20)), 0.0)
	assert_eq(field.get_density_at(Vector3(-30, 0, 1)), 0.0)
	assert_eq(field.get_density_at(Vector3(22, 0, 24)), 1.0)
	var answer := field.explain(Vector3(22, 0, 20))
	assert_eq(answer.reason, GrassField.REASON_FILL_NODE)
	assert_eq(answer.node, house)
	assert_eq(answer.text, "No grass grows here: GrassExclusion3D '%s' leaves none." % house.name)
	var cells: int = field.get_counters().fill_cells
	house.position.x = -50.0
	path.curve.set_point_position(1, Vector3(0, 0, 10))
	await frames(2)
	assert_eq(_density(field, 22, 20), 1.0, "grass comes back")
	assert_eq(_density(field, -48, 20), 0.0)
	assert_eq(_density(field, -22, 0), 1.0)
	assert_eq(_density(field, -30, 10), 0.0)
	assert_eq(field.get_counters().fill_cells, cells + 3 * CELLS_A_CHUNK, "the chunks left and entered, of 16")
	house.queue_free()
	path.queue_free()
	await frames(3)
	assert_eq(_density(field, -48, 20), 1.0)
	assert_eq(_density(field, -30, 10), 1.0)


func test_a_house_that_a_game_builds_clears_and_bare_ground_is_planted() -> void:
	var map := GrassMap.new()
	map.base_density = 0.5
	var field := await _add_filled(null, {map = map})
	var near := _add_exclusion(box(Vector3(8, 2, 4)), Vector3(20, 0, 20))
	_add_path(Vector3(-30, 0, 0), {mode = GrassPath3D.MODE_PLANT})
	await frames(2)
	assert_eq(_density(field, 22, 20), 0.0)
	assert_eq(_density(field, -30, 1), 1.0)
	assert_near(_density(field, 60, 60), 0.5, 0.01)
	_erase(map, Vector2(-30, 0), 1.0)
	map.base_density = 0.25
	near.position.x = 40.0
	await frames(2)
	assert_near(_density(field, 22, 20), 0.25, 0.01, "the new base density")
	assert_eq(_density(field, -30, 0), 0.0, "hand paint stays")
	assert_eq(_density(field, -34, 0), 1.0)


func test_what_a_rule_once_filled_stays_beside_a_path() -> void:
	var field := await _add_filled(null)
	field.fill(_rule({density = 0.5}))
	_add_path(Vector3(0, 0, 20))
	await frames(20)
	assert_eq(_density(field, 0, 20), 0.0)
	assert_near(_density(field, 0, 30), 0.5, 0.01)


func test_a_rule_that_comes_fills_all_and_one_that_goes_leaves_the_clearing() -> void:
	_add_exclusion(box(Vector3(8, 2, 4)), Vector3(20, 0, 20))
	var field := await _add_filled(null)
	field.fill_rule = _rule({density = 0.25})
	await frames(8)
	assert_near(_density(field, 60, 60), 0.25, 0.01)
	assert_eq(_density(field, 22, 20), 0.0)
	field.fill_rule = null
	await frames(3)
	assert_eq(_density(field, 60, 60), 1.0)
	assert_eq(_density(field, 22, 20), 0.0)


func test_a_field_that_none_of_them_concerns_gets_no_map() -> void:
	_add_exclusion(box(Vector3(8, 2, 4)), Vector3(500, 0, 20))
	_add_path(Vector3(0, 0, 0), {field_group = &"others"})
	var field := await _add_filled(null)
	await _follow()
	assert_true(field.map == null)
	field.add_to_group(&"others")
	await _follow()
	assert_eq(_density(field, 0, 0), 0.0)


func test_without_live_fill_nothing_is_cleared_and_the_field_says_so() -> void:
	_add_exclusion(box(Vector3(8, 2, 4)), Vector3(20, 0, 20))
	expect_error("`fill_live` is off, so GrassExclusion3D and GrassPath3D do not change this field")
	var field := await _add_filled(null, {fill_live = false})
	assert_true(field.map == null)
	field.fill_live = true
	await _follow()
	assert_eq(_density(field, 22, 20), 0.0)
