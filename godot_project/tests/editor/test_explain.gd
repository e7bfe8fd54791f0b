# SPDX-License-Identifier: MIT
## "Why is there no grass here?" in the editor: the answer appears beside the cursor.
@tool
extends "res://tests/editor/editor_case.gd"


func answer() -> String:
	var panel: Control = get_tree().root.find_child("GrassAnswer", true, false)
	return panel.get_child(0).text if panel.is_visible_in_tree() else ""


func test_the_answer_follows_the_cursor() -> void:
	await take("Erase")
	await stroke([Vector3(-1, 0, -0.5), Vector3(0, 0, -0.5), Vector3(1, 0, -1)])
	assert_eq(answer(), "", "nobody asked")
	await take("Why")
	await move(at(Vector3(0, 0, -0.5)))
	assert_true(answer().contains("painted to a density"), answer())
	assert_true(plugin.get_statistics().ring)
	var shown: Control = get_tree().root.find_child("GrassAnswer", true, false)
	assert_true(view().get_global_rect().grow(1.0).encloses(shown.get_global_rect()))
	await move(at(Vector3(0, 0, -3)))
	assert_true(answer().contains("grows here."), answer())
	var map := field.map.data
	await button(MOUSE_BUTTON_LEFT, true, at(Vector3(0, 0, -3)))
	await button(MOUSE_BUTTON_LEFT, false, at(Vector3(0, 0, -3)))
	assert_eq(field.map.data, map, "a click paints nothing")
	var body: Node3D = EditorInterface.get_edited_scene_root().get_node("Csg")
	for pressed: bool in [true, false]:
		await button(MOUSE_BUTTON_LEFT, pressed, at(body.position))
	await frames(3)
	assert_eq(EditorInterface.get_selection().get_selected_nodes(), [field], "and selects nothing")
	await key(KEY_ESCAPE)
	assert_eq(answer(), "")
	assert_false((toolbar.get_node("Why") as Button).button_pressed)
	assert_false(plugin.get_statistics().ring)


func test_another_tool_and_another_node_take_the_answer_away() -> void:
	await take("Why")
	await move(at(Vector3.ZERO))
	assert_ne(answer(), "")
	await take("Erase")
	assert_eq(answer(), "")
	await take("Why")
	await move(at(Vector3.ZERO))
	assert_ne(answer(), "")
	await select(EditorInterface.get_edited_scene_root().get_node("Hill"))
	assert_eq(answer(), "")
