# SPDX-License-Identifier: MIT
## Paths that rules clear or plant, live.
extends "res://tests/fill_case.gd"


## From west to east through (`x`, `z`), 40 m long.
func add_path(x: float, z: float, properties := {}) -> GrassPath3D:
	return _add_path(Vector3(x, 3, z), properties, 20.0)


func test_a_path_is_cleared_and_followed_where_it_is_moved_and_bent() -> void:
	var path := add_path(24, 20)
	var field := await _add_filled(_rule())
	assert_eq(_density(field, 20, 21.5), 0.0)
	assert_eq(_density(field, 20, 22.5), 1.0)
	assert_eq(_density(field, 38, 20), 0.0)
	var cells: int = field.get_counters().fill_cells
	path.curve.set_point_position(1, Vector3(20, 0, 30))
	await frames(2)
	assert_eq(_density(field, 38, 20), 1.0, "where it was")
	assert_eq(_density(field, 44, 50), 0.0, "where it is")
	assert_eq(field.get_counters().fill_cells, cells + CELLS_A_CHUNK, "one chunk of 16")
	path.curve.set_point_out(0, Vector3(0, 0, 30))
	path.curve.set_point_in(1, Vector3(-20, 0, 0))
	await frames(2)
	assert_eq(_density(field, 24, 35), 1.0, "the straight way")
	var middle := path.to_global(path.curve.sample(0, 0.5))
	assert_eq(_density(field, middle.x, middle.z), 0.0, "the bent one")
	path.width = 8.0
	await frames(2)
	var side := path.curve.sample(0, 0.51) - path.curve.sample(0, 0.5)
	var beside := middle + 3.0 * side.normalized().rotated(Vector3.UP, PI / 2)
	assert_eq(_density(field, beside.x, beside.z), 0.0, "wider")
	path.position.x = -60.0
	await frames(2)
	assert_eq(_density(field, middle.x, middle.z), 1.0)
	assert_eq(_density(field, middle.x - 84.0, middle.z), 0.0)
	path.enabled = false
	await frames(2)
	assert_eq(_density(field, middle.x - 84.0, middle.z), 1.0)


func test_a_hedge_is_planted_whatever_the_rule_says() -> void:
	var path := add_path(0, 32, {mode = GrassPath3D.MODE_PLANT, fade = 2.0})
	_add_exclusion(box(Vector3(4, 2, 20)), Vector3(10, 0, 32))
	var field := await _add_filled(_rule({density = 0.0}))
	assert_eq(_density(field, 0, 33), 1.0)
	assert_eq(_density(field, 0, 40), 0.0)
	assert_eq(_density(field, 10, 32), 0.0, "a gate")
	var edge := _density(field, 0, 35)
	assert_true(edge > 0.2 and edge < 0.8, "faded: %f" % edge)
	_erase(field.map, Vector2(-10, 32), 2.0)
	path.mode = GrassPath3D.MODE_CLEAR
	await frames(2)
	assert_eq(_density(field, 0, 33), 0.0)
	path.mode = GrassPath3D.MODE_PLANT
	await frames(2)
	assert_eq(_density(field, 0, 33), 1.0)
	assert_eq(_density(field, -10, 32), 0.0, "what hands erased stays")
	var answer := field.explain(Vector3(10, 0, 32))
	assert_eq(answer.reason, GrassField.REASON_FILL_NODE)


func test_a_path_of_some_fields_and_a_curve_of_two() -> void:
	var hedge := GrassPath3D.new()
	var road := Path3D.new()
	road.curve = Curve3D.new()
	road.curve.add_point(Vector3(-20, 0, 32))
	road.curve.add_point(Vector3(20, 0, 32))
	add_child(road)
	hedge.curve = road.curve
	hedge.field_group = &"hedges"
	road.add_child(hedge)
	var field := await _add_filled(_rule())
	assert_eq(_density(field, 0, 32), 1.0, "not its field")
	field.add_to_group(&"hedges")
	await _follow()
	assert_eq(_density(field, 0, 32), 0.0)
	road.curve.set_point_position(0, Vector3(-20, 0, 10))
	road.curve.set_point_position(1, Vector3(20, 0, 10))
	await frames(2)
	assert_eq(_density(field, 0, 32), 1.0)
	assert_eq(_density(field, 0, 10), 0.0, "it follows the road's curve")
	hedge.queue_free()
	await frames(3)
	assert_eq(_density(field, 0, 10), 1.0)


func test_what_is_no_path() -> void:
	var path := GrassPath3D.new()
	add_child(path)
	var field := await _add_filled(_rule())
	assert_eq(_density(field, 0, 0), 1.0)
	path.curve = Curve3D.new()
	path.curve.add_point(Vector3.ZERO)
	await frames(2)
	assert_eq(_density(field, 0, 0), 1.0, "a point is no way")
	expect_error("`mode` must be MODE_CLEAR or MODE_PLANT")
	path.set("mode", 7)
	assert_eq(path.mode, GrassPath3D.MODE_CLEAR)
	path.width = -3.0
	assert_eq(path.width, 0.0)
