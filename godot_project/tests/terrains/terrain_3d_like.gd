# SPDX-License-Identifier: MIT
## Behaves like Terrain3D for a field: a `data` object that takes global places for any transform of the node, blends heights between
## vertices, returns NaN in holes and outside of its regions, and emits signals about edits.
extends Node3D


class Data:
	extends Object

	signal maps_edited(edited_area: AABB)
	signal maps_changed

	const Hills := preload("res://tests/terrains/hills.gd")
	const REGION := 256.0  # metres from the origin that have data
	const SPACING := 1.0  # of vertices

	var hills := Hills.new()
	var holes_have_heights := false  # as in versions whose get_height() looks at no holes

	func get_height(at: Vector3) -> float:
		if not _has_data(at) or not holes_have_heights and not hills.has_ground(at.x, at.z):
			return NAN
		var x := floorf(at.x / SPACING)
		var z := floorf(at.z / SPACING)
		var s := at.x / SPACING - x
		var t := at.z / SPACING - z
		return lerpf(lerpf(_vertex(x, z), _vertex(x + 1, z), s), lerpf(_vertex(x, z + 1), _vertex(x + 1, z + 1), s), t)

	func get_texture_id(at: Vector3) -> Vector3:
		if not _has_data(at) or not hills.has_ground(at.x, at.z):
			return Vector3(NAN, NAN, NAN)
		return hills.texture(at.x, at.z)

	func get_color(at: Vector3) -> Color:
		return hills.color_at(at.x, at.z) if _has_data(at) else Color(NAN, NAN, NAN, 1.0)

	func _has_data(at: Vector3) -> bool:
		return maxf(absf(at.x), absf(at.z)) < REGION

	func _vertex(x: float, z: float) -> float:
		return hills.height(x * SPACING, z * SPACING)


var data := Data.new()


func get_vertex_spacing() -> float:
	return Data.SPACING


func get_data() -> Data:
	return data


func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE:
		data.free()
