# SPDX-License-Identifier: MIT
## Starts the runner inside the editor, once the editor has come up.
@tool
extends EditorPlugin

const FRAMES := 10  # until the editor's first layout is done


func _enter_tree() -> void:
	_start.call_deferred()


func _start() -> void:
	while EditorInterface.get_resource_filesystem().is_scanning():
		await get_tree().process_frame
	for i in FRAMES:
		await get_tree().process_frame
	add_child(load("res://tests/runner.tscn").instantiate())
