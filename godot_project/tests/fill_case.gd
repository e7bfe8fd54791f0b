# SPDX-License-Identifier: MIT
## A test that fills by rule.
extends "res://tests/field_case.gd"

const CELLS_A_CHUNK := 128 * 128


func _rule(properties := {}) -> GrassFillRule:
	var rule := GrassFillRule.new()
	for property: String in properties:
		rule.set(property, properties[property])
	return rule


## Adds a field of 4 x 4 chunks that has been filled.
func _add_filled(rule: GrassFillRule, properties := {}) -> GrassField:
	var field := add_field({size = Vector2(256, 256), density = 1.0, fill_rule = rule}.merged(properties))
	await frames(2)
	return field


func _density(field: GrassField, x: float, z: float) -> float:
	return field.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(x, z))


func _add_exclusion(shape: Shape3D, place: Vector3) -> GrassExclusion3D:
	var exclusion := GrassExclusion3D.new()
	exclusion.shape = shape
	exclusion.fade = 0.0
	exclusion.position = place
	add_child(exclusion)
	return exclusion


## Waits until the live rule has checked the scene and filled the changed places.
func _follow() -> void:
	await frames(20)


func _erase(map: GrassMap, place: Vector2, radius: float) -> void:
	var brush := GrassBrush.new()
	brush.tool = GrassBrush.TOOL_ERASE
	brush.strength = 1.0
	brush.hardness = 1.0
	brush.radius = radius
	map.stroke(brush, place, place)


## Adds a path from west to east through `place`, as far to both sides as `half`, metres.
func _add_path(place: Vector3, properties := {}, half := 10.0) -> GrassPath3D:
	var path := GrassPath3D.new()
	path.curve = Curve3D.new()
	path.curve.add_point(Vector3(-half, 0, 0))
	path.curve.add_point(Vector3(half, 0, 0))
	path.position = place
	path.width = 4.0
	path.fade = 0.0
	for property: String in properties:
		path.set(property, properties[property])
	add_child(path)
	return path
