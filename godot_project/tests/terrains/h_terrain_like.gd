# SPDX-License-Identifier: MIT
## Behaves like HTerrain for a field: data counted in cells, heights without the node's scale, clamped beyond the border,
## splat maps of four weights, a colour map whose alpha cuts holes, signals in cells.
extends Node3D


class Data:
	extends Resource

	signal resolution_changed

	const CHANNEL_HEIGHT := 0
	const CHANNEL_SPLAT := 2
	const CHANNEL_COLOR := 3
	const CHANNEL_GLOBAL_ALBEDO := 5
	const CHANNEL_SPLAT_INDEX := 6
	const CHANNEL_SPLAT_WEIGHT := 7

	var heights := Image.create_empty(129, 129, false, Image.FORMAT_RF)
	var splat := Image.create_empty(129, 129, false, Image.FORMAT_RGBA8)
	var color := Image.create_empty(129, 129, false, Image.FORMAT_RGBA8)
	var albedo: Image  # baked, of any size
	var indices: Image  # of the shader of a texture array: numbers of three textures, and the weights of two
	var weights: Image

	var by_rectangle: bool

	## Up to 1.8 `region_changed` has five numbers, later a rectangle and two numbers.
	func _init(by_a_rectangle: bool) -> void:
		by_rectangle = by_a_rectangle
		var numbers := ["channel", "index"] if by_rectangle else ["x", "y", "w", "h", "channel"]
		var arguments: Array = numbers.map(func(named: String) -> Dictionary: return {name = named, type = TYPE_INT})
		if by_rectangle:
			arguments.push_front({name = "rect", type = TYPE_RECT2I})
		add_user_signal("region_changed", arguments)

	func tell_of(rect: Rect2i) -> void:
		if by_rectangle:
			emit_signal("region_changed", rect, CHANNEL_HEIGHT, 0)
		else:
			emit_signal("region_changed", rect.position.x, rect.position.y, rect.size.x, rect.size.y, CHANNEL_HEIGHT)

	func get_resolution() -> int:
		return heights.get_width()

	func get_interpolated_height_at(pos: Vector3) -> float:
		var x := int(floorf(pos.x))
		var y := int(floorf(pos.z))
		var s := pos.x - x
		var t := pos.z - y
		return lerpf(lerpf(_height(x, y), _height(x + 1, y), s), lerpf(_height(x, y + 1), _height(x + 1, y + 1), s), t)

	func get_map_count(map_type: int) -> int:
		if map_type in [CHANNEL_SPLAT_INDEX, CHANNEL_SPLAT_WEIGHT]:
			return 1 if indices else 0
		return 1 if map_type <= CHANNEL_COLOR or map_type == CHANNEL_GLOBAL_ALBEDO and albedo else 0

	func get_image(map_type: int, _index := 0) -> Image:
		var of_array := {CHANNEL_SPLAT_INDEX: indices, CHANNEL_SPLAT_WEIGHT: weights}
		return of_array.merged({CHANNEL_HEIGHT: heights, CHANNEL_SPLAT: splat, CHANNEL_COLOR: color, CHANNEL_GLOBAL_ALBEDO: albedo}).get(
			map_type
		)

	func _height(x: int, y: int) -> float:
		var last := get_resolution() - 1
		return heights.get_pixel(clampi(x, 0, last), clampi(y, 0, last)).r


const Hills := preload("res://tests/terrains/hills.gd")

var map_scale := Vector3(2, 4, 2)  # of cells, and of heights
var hills := Hills.new()
var shader_type := "Classic4"
var _data: Data


func _init(by_rectangle := false) -> void:
	_data = Data.new(by_rectangle)
	shape()


func get_data() -> Data:
	return _data


func get_shader_type() -> String:
	return shader_type


## Centred on the node.
func get_internal_transform() -> Transform3D:
	var half := 0.5 * (_data.get_resolution() - 1.0)
	var place := Transform3D(global_transform.basis * Basis().scaled(map_scale), global_transform.origin)
	place.origin += place.basis * Vector3(-half, 0, -half)
	return place


## Puts the hills into the images; the hills count from the node.
func shape() -> void:
	var half := 0.5 * (_data.get_resolution() - 1.0)
	for y in _data.get_resolution():
		for x in _data.get_resolution():
			var at := Vector2(x - half, y - half) * map_scale.x
			var texture := hills.texture(at.x, at.y)
			var weights := [0.0, 0.0, 0.0]
			weights[int(texture.x)] += 1.0 - texture.z
			weights[int(texture.y)] += texture.z
			_data.heights.set_pixel(x, y, Color(hills.height(at.x, at.y) / map_scale.y, 0, 0))
			_data.splat.set_pixel(x, y, Color(weights[0], weights[1], weights[2], 0))
			_data.color.set_pixel(x, y, Color(hills.color_at(at.x, at.y), 1 if hills.has_ground(at.x, at.y) else 0))
