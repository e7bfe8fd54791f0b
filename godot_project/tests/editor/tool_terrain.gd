# SPDX-License-Identifier: MIT
## A terrain that returns its heights in the editor.
@tool
extends Node3D


func get_height(at: Vector3) -> float:
	return 0.4 * sin(1.2 * at.x) + 0.1 * at.z
