# SPDX-License-Identifier: MIT
## A terrain that returns many heights in a call, and nothing else.
extends Node

const Hills := preload("res://tests/terrains/hills.gd")

var hills := Hills.new()


func get_heights(places: PackedVector3Array) -> PackedFloat32Array:
	var heights := PackedFloat32Array()
	for at in places:
		heights.append(hills.height(at.x, at.z) if hills.has_ground(at.x, at.z) else NAN)
	return heights
