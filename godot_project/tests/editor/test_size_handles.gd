# SPDX-License-Identifier: MIT
## The handles on a field's sides, dragged with the mouse.
@tool
extends "res://tests/editor/editor_case.gd"

const SMALL := Vector2(6, 4)  # metres; all handles are in view


func before() -> void:
	await super()
	field.size = SMALL
	await move(at(Vector3.ZERO))
	await key(KEY_V)  # the mode without arrows at the node
	await frames(3)


## Drags what is at one point of the world to another.
func drag(from: Vector3, to: Vector3, release := true) -> void:
	await move(at(from))
	await button(MOUSE_BUTTON_LEFT, true, at(from))
	for step in 4:
		await move(at(from.lerp(to, 0.25 * (step + 1))), MOUSE_BUTTON_MASK_LEFT)
	if release:
		await button(MOUSE_BUTTON_LEFT, false, at(to))


func test_each_side_is_dragged_and_both_move() -> void:
	await drag(Vector3(3, 0, 0), Vector3(2, 0, 0))
	assert_near(field.size, Vector2(4, 4), 0.05, "the right one")
	assert_near(field.position, Vector3.ZERO, 1e-6)
	await undo()
	assert_eq(field.size, SMALL)
	await redo()
	assert_near(field.size, Vector2(4, 4), 0.05)
	await drag(Vector3(0, 0, 2), Vector3(0, 0, 1.5))
	assert_near(field.size, Vector2(4, 3), 0.05, "the near one")
	await undo()
	await undo()
	assert_eq(field.size, SMALL, "a step each")
	await drag(Vector3(-3, 0, 0), Vector3(-4, 0, 0))
	assert_near(field.size, Vector2(8, 4), 0.05, "the left one")
	await drag(Vector3(0, 0, -2), Vector3(0, 0, 1))
	assert_near(field.size.x, 8.0, 0.05)
	assert_near(field.size.y, 1.0, 0.05, "past the centre it stays as it was before")


func test_the_right_button_cancels() -> void:
	await drag(Vector3(3, 0, 0), Vector3(2, 0, 0), false)
	assert_near(field.size, Vector2(4, 4), 0.05)
	await button(MOUSE_BUTTON_RIGHT, true, at(Vector3(2, 0, 0)))
	await button(MOUSE_BUTTON_RIGHT, false, at(Vector3(2, 0, 0)))
	await button(MOUSE_BUTTON_LEFT, false, at(Vector3(2, 0, 0)))
	assert_eq(field.size, SMALL)


func test_a_field_that_is_turned() -> void:
	field.position = Vector3(0.5, 0.2, -0.5)
	field.rotation.y = 0.6
	await frames(3)
	var side := field.to_global(Vector3(3, 0, 0))
	await drag(side, field.to_global(Vector3(2, 0, 0)))
	assert_near(field.size, Vector2(4, 4), 0.05)


func test_a_field_that_is_scaled() -> void:
	field.scale = Vector3(2, 1, 2)  # which it ignores
	field.update_gizmos()
	await frames(3)
	await drag(Vector3(3, 0, 0), Vector3(2, 0, 0))
	assert_near(field.size, Vector2(4, 4), 0.05)


func test_sizes_snap_as_places_do() -> void:
	await key(KEY_Y)
	var snaps := EditorInterface.is_node_3d_snap_enabled()
	await drag(Vector3(3, 0, 0), Vector3(2.2, 0, 0))
	await key(KEY_Y)
	assert_true(snaps)
	assert_near(field.size.x, snappedf(4.4, EditorInterface.get_node_3d_translate_snap()), 1e-3)


func test_what_was_painted_stays_and_the_brush_goes_first() -> void:
	await take("Erase")
	await stroke([Vector3(-1, 0, 0), Vector3(1, 0, 0)])
	var painted := field.map.data
	await stroke([Vector3(3, 0, 0), Vector3(2.5, 0, 0)])
	assert_eq(field.size, SMALL, "a brush in the hand paints")
	await undo()
	await key(KEY_ESCAPE)
	await drag(Vector3(3, 0, 0), Vector3(4, 0, 0))
	assert_near(field.size, Vector2(8, 4), 0.05)
	assert_eq(field.map.data, painted)
