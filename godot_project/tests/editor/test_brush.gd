# SPDX-License-Identifier: MIT
@tool
extends "res://tests/editor/editor_case.gd"


func test_first() -> void:
	print(view().get_global_rect(), toolbar.visible, toolbar.get_global_rect(), plugin.get_statistics())
	print(EditorInterface.get_editor_viewport_3d(0).get_camera_3d().global_transform)
	await move(view().get_global_rect().get_center())
	await key(KEY_F)
	await frames(20)
	print(EditorInterface.get_editor_viewport_3d(0).get_camera_3d().global_transform)
	await take("Erase")
	await stroke([Vector3(0, 0, 0), Vector3(2, 0, 0), Vector3(4, 0, 1)])
	print(plugin.get_statistics(), density(0, 0), density(4,1))
	await shoot("first")
