# SPDX-License-Identifier: MIT
## A terrain of a game's own: the plain interface of docs/guide/terrain.md, one place a call.
extends Node3D

signal terrain_changed(area: AABB)

const Hills := preload("res://tests/terrains/hills.gd")

var hills := Hills.new()
var asked := PackedVector3Array()  # where a height was


func get_height(at: Vector3) -> float:
	asked.append(at)
	return position.y + hills.height(at.x - position.x, at.z - position.z)


func is_hole(at: Vector3) -> bool:
	return not hills.has_ground(at.x - position.x, at.z - position.z)


func get_texture_id(at: Vector3) -> int:
	return int(hills.texture(at.x - position.x, at.z - position.z).x)


func get_normal(at: Vector3) -> Vector3:
	return Vector3(-0.2 * cos(0.1 * (at.x - position.x)), 1.0, -0.15)


## Returns the colour where the terrain has one; elsewhere grass keeps its own colours.
func get_color(at: Vector3) -> Color:
	var color := hills.color_at(at.x - position.x, at.z - position.z)
	return Color(color, 0.0 if color == Color.WHITE else 1.0)
