# SPDX-License-Identifier: MIT
## Bodies in a game: colliders without physics, and signals about bodies that enter and leave.
extends "res://tests/field_case.gd"

var entered: Array[Node] = []
var exited: Array[Node] = []


func test_a_node_without_physics_bends_grass_until_it_is_taken_back() -> void:
	var field := add_field({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 0.1, settle_time = 0.1})
	var hand := Node3D.new()
	hand.position = Vector3(0.25, 0.2, 0.25)
	add_child(hand)
	await ticks(2)
	var tile := field.get_tile_at(hand.position)
	var rest := tile_knots(field, tile)
	field.register_collider(hand, ball(0.2))
	await ticks(10)
	assert_greater(farthest(tile_knots(field, tile), rest), 0.05, "metres")
	hand.position.x = -1.5
	await ticks(2)
	assert_true(field.is_tile_awake(field.get_tile_at(hand.position)), "it goes where the node goes")
	field.unregister_collider(hand)
	await ticks(40)
	assert_eq(field.get_awake_tile_count(), 0)
	field.register_collider(hand, ball(0.2))
	await ticks(3)
	assert_greater(field.get_awake_tile_count(), 0)
	remove_child(hand)
	await ticks(40)
	assert_eq(field.get_awake_tile_count(), 0, "out of the tree")
	add_child(hand)
	await ticks(3)
	assert_greater(field.get_awake_tile_count(), 0)
	hand.free()
	await ticks(40)
	assert_eq(field.get_awake_tile_count(), 0, "freed")


func listen(field: GrassField) -> void:
	field.body_entered_grass.connect(func(body: Node3D) -> void: entered.append(body))
	field.body_exited_grass.connect(func(body: Node3D) -> void: exited.append(body))


func test_bodies_enter_and_leave_grass() -> void:
	var field := add_field({map = full_map(), size = Vector2(8, 8)})
	field.paint(brush(GrassBrush.TOOL_ERASE, 3.0), Vector3(4, 0, -4), Vector3(4, 0, 4))  # bare from x = 1 on
	listen(field)
	var body := add_held_body(ball(0.2), Vector3(3, 0.2, 0))
	var hand := Node3D.new()
	hand.position = Vector3(3, 0.2, 2)
	add_child(hand)
	field.register_collider(hand, ball(0.1))
	await ticks(10)
	assert_eq(entered, [] as Array[Node], "bare ground is no grass")
	for i in 60:
		body.position.x -= 0.05
		await ticks(1)
	assert_eq(entered, [body] as Array[Node])
	assert_eq(exited, [] as Array[Node])
	hand.position.x = -1.0
	await ticks(2)
	assert_eq(entered, [body, hand] as Array[Node])
	body.position.y = 3.0
	await ticks(3)
	assert_eq(exited, [body] as Array[Node])
	body.position.y = 0.2
	await ticks(3)
	assert_eq(entered, [body, hand, body] as Array[Node], "a footstep")
	field.cut(ball(1), Transform3D(Basis(), Vector3(0, -3, 0)))  # nothing
	body.free()
	hand.free()
	await ticks(5)
	assert_eq(exited.size(), 1, "who is freed leaves without a word")


func test_bodies_leave_grass_that_goes() -> void:
	var field := add_field({map = full_map()})
	listen(field)
	var body := add_held_body(ball(0.2), Vector3(0, 0.2, 0))
	await ticks(5)
	assert_eq(entered, [body] as Array[Node])
	field.simulated = false
	assert_eq(exited, [body] as Array[Node])
	field.simulated = true
	await ticks(5)
	assert_eq(entered.size(), 2)
	remove_child(field)
	assert_eq(exited.size(), 2)
	field.free()


func test_a_listener_may_cut_under_the_body() -> void:
	var field := add_field()
	var cuts: Array[Dictionary] = []
	field.body_entered_grass.connect(func(body: Node3D) -> void: cuts.append(field.cut(ball(0.5), body.global_transform)))
	add_held_body(ball(0.2), Vector3(0, 0.4, 0))
	await ticks(20)
	assert_greater(cuts.size(), 0)
	assert_greater(cuts[0].area, 0.0)
	assert_true(all_finite(field, awake_tiles(field)))
