# SPDX-License-Identifier: MIT
## While a scene is edited, baked ground follows the bodies and terrains that it was read from.
@tool
extends "res://tests/editor/editor_case.gd"

const FLOOR := Vector2(-5, -1)  # the tilted floor's middle
const FLOOR_HEIGHT := 1.316
const FIELD := Rect2(-12, -12, 24, 24)


func bake() -> void:
	await click(toolbar.get_node("Bake"))
	assert_near(ground(FLOOR), FLOOR_HEIGHT, 0.1)
	await settled()


func test_ground_follows_a_body_that_is_moved_and_the_history() -> void:
	await bake()
	var baked := field.map.get_channel_image(GrassMap.CHANNEL_DENSITY, FIELD).get_data()
	await take("Erase")
	await stroke([Vector3(1, 0, -1), Vector3(1, 0, -1)])
	var painted := heights()
	var body: Node3D = field.get_node("../TiltedFloor")
	await move_by_history(body, body.position + Vector3(0, 0.5, 8))
	await settled()
	assert_near(ground(FLOOR), 0.0, 0.0, "what it left: nothing is below")
	assert_near(ground(FLOOR + Vector2(0, 8)), FLOOR_HEIGHT + 0.5, 0.1, "where it came to")
	assert_near(ground(Vector2(-4, -7)), 1.2, 0.15, "the hill stays")
	assert_less(density(1, -1), 0.9, "paint stays")
	var moved: PackedByteArray = field.map.data
	await stroke([Vector3(0, 0, 0), Vector3(0, 0, 0)])
	var twice: PackedByteArray = field.map.data
	await undo()
	assert_eq(field.map.data, moved, "the second stroke")
	await undo()
	await settled()
	assert_near(body.position.z, -1.0, 1e-3)
	assert_eq(heights(), painted, "the motion")
	await undo()
	assert_eq(field.map.get_channel_image(GrassMap.CHANNEL_DENSITY, FIELD).get_data(), baked, "the first stroke")
	assert_eq(heights(), painted, "and nothing of the ground, which no stroke has changed")
	for step in 3:
		await redo()
		await settled()
	assert_near(body.position.z, 7.0, 1e-3)
	assert_eq(field.map.data, twice, "and all of it again")


func test_a_stroke_right_after_a_motion_keeps_undo_right() -> void:
	await bake()
	var baked := heights()
	var body: Node3D = field.get_node("../TiltedFloor")
	await take("Erase")
	await move_by_history(body, body.position + Vector3(0, 0.5, 8))
	await stroke([Vector3(1, 0, -1), Vector3(1, 0, -1)])  # the ground has not been looked at since
	assert_near(ground(FLOOR), 0.0, 0.0)
	await undo()
	await undo()
	await settled()
	assert_eq(heights(), baked)


func test_ground_follows_a_body_that_is_deleted_and_comes_back() -> void:
	await bake()
	var baked: PackedByteArray = field.map.data
	var body: Node = field.get_node("../TiltedFloor")
	var parent := body.get_parent()
	parent.remove_child(body)
	await settled()
	assert_near(ground(FLOOR), 0.0, 0.0)
	parent.add_child(body)
	body.owner = parent
	await settled()
	assert_eq(field.map.data, baked)
	var box: CSGBox3D = field.get_node("../Csg")
	assert_near(ground(Vector2(1.5, -4)), 1.0, 0.1)
	box.size.y = 2.0
	await settled()
	assert_near(ground(Vector2(1.5, -4)), 1.5, 0.1, "it is 2 m high about its middle")


func test_ground_follows_a_shape_that_is_edited_where_it_stands() -> void:
	await bake()
	var baked: PackedByteArray = field.map.data
	var hill: HeightMapShape3D = field.get_node("../Hill/Shape").shape
	var top := Vector2(-4, -8)
	var side := Vector2(-6, -10)
	var top_before := ground(top)
	var side_before := ground(side)
	var heights := hill.map_data
	var turned := heights.duplicate()
	turned[12] = heights[6]  # the top goes to the side; the hill is as high and wide as it was
	turned[6] = heights[12]
	hill.map_data = turned
	await settled()
	assert_less(ground(top), top_before - 0.4)
	assert_greater(ground(side), side_before + 0.4)
	hill.map_data = heights
	await settled()
	assert_eq(field.map.data, baked)


func test_a_look_at_a_large_shape() -> void:
	await bake()
	var land := StaticBody3D.new()
	land.position = Vector3(2000, 0, 0)  # nothing to bake
	var shape := CollisionShape3D.new()
	shape.shape = HeightMapShape3D.new()
	shape.shape.map_width = 1025
	shape.shape.map_depth = 1025
	land.add_child(shape)
	await settled()
	var without: float = plugin.get_statistics().watch_us
	field.get_parent().add_child(land)
	await settled()
	print("a map of 1,025 x 1,025 heights: looking takes %.0f us, %.0f without it" % [plugin.get_statistics().watch_us, without])
	assert_near(ground(FLOOR), FLOOR_HEIGHT, 0.1)
	land.free()
	await settled()


func test_ground_follows_the_field_that_is_moved() -> void:
	await bake()
	var baked: PackedByteArray = field.map.data
	var at_first := field.position
	field.position.y = -1.0
	await settled()
	assert_near(ground(FLOOR), FLOOR_HEIGHT + 1.0, 0.1, "above the field")
	field.position = at_first
	await settled()
	assert_near(ground(FLOOR), FLOOR_HEIGHT, 0.1)
	assert_eq(field.map.data, baked)


func test_a_frame_casts_some_rays_and_chunks_are_as_the_whole() -> void:
	field.size = Vector2(80, 80)  # four chunks
	await bake()
	var baked: PackedByteArray = field.map.data
	var before: int = plugin.get_statistics().watch_rays
	var at_first := field.position
	field.position.y = -1.0
	await settled()
	await worked()
	assert_near(ground(FLOOR), FLOOR_HEIGHT + 1.0, 0.1)
	field.position = at_first
	await settled()
	await worked()
	assert_eq(field.map.data, baked, "read chunk by chunk, it is as it was read whole")
	assert_greater(plugin.get_statistics().watch_rays - before, 4 * 4096)
	assert_less(plugin.get_statistics().watch_most_rays, 4097, "rays in a frame")


func test_what_is_no_ground_is_not_followed() -> void:
	await bake()
	var baked: PackedByteArray = field.map.data
	var before: int = plugin.get_statistics().watch_rays
	field.get_node("../Ball").position = Vector3(3, 0.4, 3)
	var house := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = BoxShape3D.new()
	shape.shape.size = Vector3(3, 4, 3)
	house.add_child(shape)
	house.position = Vector3(5, 2, 5)
	field.get_parent().add_child(house)
	await settled()
	house.position.x = 7.0
	await settled()
	assert_eq(field.map.data, baked, "grass stands around it, not on it")
	assert_eq(plugin.get_statistics().watch_rays, before)
	await click(toolbar.get_node("Bake"))
	assert_near(ground(Vector2(7, 5)), 4.0, 0.1, "asked for, it is ground")
	await settled()
	house.position.x = -7.0
	await settled()
	assert_near(ground(Vector2(7, 5)), 0.0, 0.0, "and followed")
	assert_near(ground(Vector2(-7, 5)), 4.0, 0.1)


func test_the_menu_turns_it_off() -> void:
	await bake()
	var baked: PackedByteArray = field.map.data
	var menu := (toolbar.get_node("Menu") as MenuButton).get_popup()
	menu.id_pressed.emit(3)
	field.get_node("../TiltedFloor").position.z += 6.0
	await settled()
	menu.id_pressed.emit(3)
	await settled()
	assert_eq(field.map.data, baked)


func test_a_look_at_a_large_scene() -> void:
	await bake()
	var many := Node3D.new()
	for i in 5000:
		var node: Node3D = StaticBody3D.new() if i % 5 == 0 else Node3D.new()
		node.position.x = 100.0 + i
		many.add_child(node)
		if i % 5 == 0:
			var shape := CollisionShape3D.new()
			shape.shape = BoxShape3D.new()
			node.add_child(shape)
	field.get_parent().add_child(many)
	await settled()
	print("1,000 static bodies among 6,000 nodes: looking takes %.0f us in the longest frame" % plugin.get_statistics().watch_us)
	assert_near(ground(FLOOR), FLOOR_HEIGHT, 0.1)
	many.free()
	await settled()


func move_by_history(body: Node3D, to: Vector3) -> void:
	var history := EditorInterface.get_editor_undo_redo()
	history.create_action("Move Body", UndoRedo.MERGE_DISABLE, body)
	history.add_do_property(body, "position", to)
	history.add_undo_property(body, "position", body.position)
	history.commit_action()
	await frames(1)


func ground(place: Vector2) -> float:
	return field.map.sample(GrassMap.CHANNEL_GROUND, place)
