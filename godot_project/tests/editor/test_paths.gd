# SPDX-License-Identifier: MIT
## A path in the editor: Godot's own tools for curves bend it, and the grass follows.
@tool
extends "res://tests/editor/editor_case.gd"

const ARROW := 140.0  # pixels from a point to the tip of its arrow


func test_the_grass_follows_a_point_of_the_curve_that_is_dragged() -> void:
	field.fill_rule = GrassFillRule.new()
	var path := GrassPath3D.new()
	path.curve = Curve3D.new()
	for x: float in [-3, 0, 3]:
		path.curve.add_point(Vector3(x, 0, 0))
	path.width = 1.0
	path.fade = 0.0
	EditorInterface.get_edited_scene_root().add_child(path)
	path.owner = EditorInterface.get_edited_scene_root()
	await select(path)
	await frames(10)
	assert_near(density(-2.75, 0.25), 0.0, 0.0, "straight")
	var point := at(Vector3(-3, 0, 0))
	await move(point)
	await button(MOUSE_BUTTON_LEFT, true, point)  # the arrows go to the point
	await button(MOUSE_BUTTON_LEFT, false, point)
	var way := (at(Vector3(-3, 0, 0.1)) - point).normalized()
	var arrow := point + ARROW * way
	await move(arrow)
	await button(MOUSE_BUTTON_LEFT, true, arrow)
	for step in 4:
		await move(arrow + 40.0 * (step + 1) * way, MOUSE_BUTTON_MASK_LEFT)
	await button(MOUSE_BUTTON_LEFT, false, arrow + 160.0 * way)
	await frames(5)
	var bent := path.curve.get_point_position(0)
	if not assert_greater((bent - Vector3(-3, 0, 0)).length(), 0.8, "the point was dragged"):
		return
	assert_near(density(-2.75, 0.25), 1.0, 0.0, "where it was")
	assert_near(field.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(bent.x, bent.z)), 0.0, 0.3, "where it is")
	await undo()
	await frames(5)
	assert_near(density(-2.75, 0.25), 0.0, 0.0, "undone")
	await select(field)
	path.free()
	await frames(5)
	assert_near(density(-2.75, 0.25), 1.0, 0.0, "gone")
