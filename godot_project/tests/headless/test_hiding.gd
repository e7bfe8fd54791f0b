# SPDX-License-Identifier: MIT
## How much grass stands between two points, and how fast bodies brush it.
extends "res://tests/field_case.gd"

const LOW := 0.15  # metres above the ground: within grass


## Upright grass without clumps: a meadow that is the same everywhere.
func _even(properties := {}) -> GrassField:
	var field := add_field({size = Vector2(8, 8), clump_height = 0.0}.merged(properties))
	await ticks(1)
	return field


## -log of the free share: the area that blades show to the line, for each square metre.
func _depth(field: GrassField, from: Vector3, to: Vector3) -> float:
	return -log(1.0 - field.get_cover(from, to))


func test_more_grass_hides_more() -> void:
	var field := await _even()
	var one := _depth(field, Vector3(0, LOW, 0), Vector3(1, LOW, 0))
	# 256 blades a square metre, 0.5 m long and 15 mm wide at the root, 0.7 of it on average, 2 / PI of them turned to the eye.
	assert_near(one, 256.0 * 0.7 * 0.015 * 0.5 * 2.0 / PI / field.get_height_at(Vector3.ZERO), 0.6)
	assert_near(_depth(field, Vector3(-1, LOW, 0), Vector3(2, LOW, 0)), 3.0 * one, 0.01 * one)
	assert_near(_depth(field, Vector3(0, LOW, 1), Vector3(0, LOW, 0)), one, 0.01 * one, "any way round")
	assert_eq(field.get_cover(Vector3(-3, 1, 0), Vector3(3, 1, 0)), 0.0, "above")
	assert_eq(field.get_cover(Vector3(20, LOW, 0), Vector3(30, LOW, 0)), 0.0, "beside the field")
	var eyes := Vector3(-3.5, 1.7, 0)
	var lying := field.get_cover(eyes, Vector3(3, 0.2, 0))
	var crouching := field.get_cover(eyes, Vector3(3, 0.4, 0))
	assert_greater(lying, crouching)
	assert_eq(field.get_cover(eyes, Vector3(3, 1.2, 0)), 0.0, "a standing one")


func test_the_field_may_lie_anywhere() -> void:
	var field := await _even()
	var before := field.get_cover(Vector3(-1, 0.5, 0.5), Vector3(1, 0.1, 0.2))
	field.transform = Transform3D(Basis(Vector3(1, 2, 3).normalized(), 0.7), Vector3(500, -20, 300))
	await ticks(2)
	assert_near(field.get_cover(field.to_global(Vector3(-1, 0.5, 0.5)), field.to_global(Vector3(1, 0.1, 0.2))), before, 0.02)


func test_what_is_cut_erased_or_on_a_hill_counts_as_it_is() -> void:
	var map := full_map()
	var field := await _even({map = map})
	var whole := _depth(field, Vector3(-2, LOW, 0), Vector3(2, LOW, 0))
	map.stroke(brush(GrassBrush.TOOL_ERASE, 1.0), Vector2.ZERO, Vector2.ZERO)
	var half := _depth(field, Vector3(-2, LOW, 0), Vector3(2, LOW, 0))
	assert_near(half, 0.5 * whole, 0.1 * whole)
	field.cut(box(Vector3(20, 2, 20)), Transform3D(Basis(), Vector3(0, 1.1, 0)))
	assert_eq(field.get_cover(Vector3(-2, LOW, 2), Vector3(2, LOW, 2)), 0.0, "mown at 0.1 m")
	assert_greater(field.get_cover(Vector3(-2, 0.05, 2), Vector3(2, 0.05, 2)), 0.5)


func test_bent_grass_counts_as_it_lies() -> void:
	var field := await _even()
	var line := [Vector3(-0.4, 0.25, 0), Vector3(0.4, 0.25, 0)]
	var before := field.get_cover(line[0], line[1])
	var body := add_held_body(box(Vector3(3, 0.2, 3)), Vector3(0, 0.8, 0))
	for i in 60:
		body.position.y = 0.8 - 0.011 * i
		await ticks(1)
	await ticks(30)
	assert_less(field.get_cover(line[0], line[1]), 0.3 * before, "over flat grass")
	assert_greater(field.get_cover(Vector3(-0.4, 0.01, 0), Vector3(0.4, 0.01, 0)), before, "in it")
	body.free()
	await ticks_to_sleep(field)
	assert_near(field.get_cover(line[0], line[1]), before, 0.01)


func test_what_is_no_line() -> void:
	var field := await _even()
	assert_eq(field.get_cover(Vector3(0, LOW, 0), Vector3(0, LOW, 0)), 0.0)
	expect_error("get_cover() was asked for 300 m; it looks 256 m far at most (COVER_DISTANCE_MAX)")
	assert_eq(field.get_cover(Vector3(0, LOW, 0), Vector3(300, LOW, 0)), 0.0)
	expect_error("get_cover() needs finite positions")
	assert_eq(field.get_cover(Vector3(NAN, 0, 0), Vector3.ZERO), 0.0)


## Returns the rate with which a body brushes grass that moves so far in each tick.
func _rustle(field: GrassField, body: Node3D, step: Vector3) -> float:
	for i in 6:
		body.position += step
		await ticks(1)
	return field.get_rustle(body)


func test_a_body_brushes_as_many_blades_as_it_moves_over() -> void:
	var map := full_map()
	var field := await _even({map = map})
	var body := add_held_body(box(Vector3(1, 1, 0.5)), Vector3(-2, 0.5, 0))
	await ticks(5)
	assert_eq(field.get_rustle(body), 0.0, "at rest")
	var way := 0.02 * Engine.physics_ticks_per_second  # metres a second
	assert_near(await _rustle(field, body, Vector3(0.02, 0, 0)), 256.0 * way * 0.5, 1.0, "0.5 m wide")
	assert_near(await _rustle(field, body, Vector3(0, 0, 0.02)), 256.0 * way * 1.0, 1.0, "1 m wide")
	assert_eq(await _rustle(field, body, Vector3.ZERO), 0.0, "at rest again")
	map.base_density = 0.5
	assert_near(await _rustle(field, body, Vector3(0.02, 0, 0)), 128.0 * way * 0.5, 1.0, "thin grass")
	map.base_density = 0.0
	assert_eq(await _rustle(field, body, Vector3(0.02, 0, 0)), 0.0, "bare ground")
	map.base_density = 1.0
	body.position = Vector3(0, 2, 0)
	await ticks(3)
	assert_eq(await _rustle(field, body, Vector3(0.02, 0, 0)), 0.0, "above")


func test_registered_nodes_rustle_too_and_others_do_not() -> void:
	var field := await _even()
	var node := Node3D.new()
	node.position = Vector3(-1, 0.2, 0)
	add_child(node)
	assert_eq(await _rustle(field, node, Vector3(0.02, 0, 0)), 0.0, "no body")
	field.register_collider(node, ball(0.25))
	await ticks(3)
	var way := 0.02 * Engine.physics_ticks_per_second
	assert_near(await _rustle(field, node, Vector3(0.02, 0, 0)), 256.0 * way * 0.5, 2.0)
	field.simulated = false
	await grown(field)
	await ticks(3)
	assert_eq(field.get_rustle(node), 0.0, "a field that is only drawn")
	expect_error("get_rustle() needs a body or a registered node")
	assert_eq(field.get_rustle(null), 0.0)
