# SPDX-License-Identifier: MIT
## Time on the calling thread of a game's queries while bodies bend the grass: microseconds a call, once in each frame, as in a game. The
## waiting call is the last one.
extends Node3D

const Scenery := preload("res://bench/scenery.gd")

const SIDE := 100.0  # metres
const FRAMES := 240
const SOFTWARE := 60  # frames, where they are drawn in software
const WARM_UP := 10

var _field: GrassField
var _place := Vector3(0.3, 0.0, 0.3)


func run(p_software: bool) -> Array[PackedStringArray]:
	var rows: Array[PackedStringArray] = [["question", "blades", "median_us", "p95_us", "most_us"]]
	get_viewport().disable_3d = p_software
	_field = GrassField.new()
	_field.size = Vector2(SIDE, SIDE)
	var map := GrassMap.new()
	map.base_density = 1.0
	map.stroke(_brush(), Vector2(-5, 0), Vector2(5, 0))
	_field.map = map
	add_child(_field)
	var camera := Camera3D.new()
	camera.position = Vector3(0.0, 5.0, 5.0)
	add_child(camera)
	camera.look_at(Vector3.ZERO)
	await Scenery.compiled(_field)
	var body := AnimatableBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = SphereShape3D.new()
	body.sync_to_physics = false
	body.add_child(shape)
	add_child(body)
	for question: Array in _questions():
		var times: Array[float] = []
		for frame in (SOFTWARE if p_software else FRAMES) + WARM_UP:
			await get_tree().physics_frame
			body.position = _place + Vector3(0.3 * sin(0.1 * frame), 0.2, 0.0)
			await get_tree().process_frame
			var ask: Callable = question[2]
			if question.size() > 4:
				question[4].call()
			var begin := Time.get_ticks_usec()
			for i in 10 if question[3] else 1:
				ask.call()
			if frame >= WARM_UP:
				times.append((Time.get_ticks_usec() - begin) / (10.0 if question[3] else 1.0))
		times.sort()
		rows.append(
			PackedStringArray(
				[
					question[0],
					str(question[1]),
					"%.1f" % times[times.size() >> 1],
					"%.1f" % times[times.size() * 95 / 100],
					"%.1f" % times[-1]
				]
			)
		)
	body.queue_free()
	_field.queue_free()
	camera.queue_free()
	get_viewport().disable_3d = false
	await get_tree().process_frame
	return rows


## The query, for how many blades, how, and whether ten times in a row, since the clock counts whole microseconds; what is done before.
func _questions() -> Array[Array]:
	var tile := _field.get_tile_at(_place)
	var blades := _field.get_tile_blades(tile)
	var around := _field.find_blades(_place, 0.4)
	var many := _field.find_blades(_place, 1.5).slice(0, 1000)
	var lawn := BoxShape3D.new()
	lawn.size = Vector3(10, 10, 10)
	return [
		["get_tile_at", 0, func() -> void: _field.get_tile_at(_place), true],
		["is_tile_awake", 0, func() -> void: _field.is_tile_awake(tile), true],
		["is_grass_at", 0, func() -> void: _field.is_grass_at(_place), true],
		["height_at", 0, func() -> void: _field.get_height_at(_place), true],
		["bend_at", 0, func() -> void: _field.get_bend_at(_place), true],
		["get_blade_species", 1, func() -> void: _field.get_blade_species(tile, 3), true],
		["get_knots", 1, func() -> void: _field.get_knots(tile, 3), true],
		["get_tile_knots", 64, func() -> void: _field.get_tile_knots(tile), true],
		["get_tile_knots at rest", 64, func() -> void: _field.get_tile_knots(Vector2i(2, 2)), true],
		["get_blade_knots", around.size(), func() -> void: _field.get_blade_knots(around), true],
		["get_blade_knots", many.size(), func() -> void: _field.get_blade_knots(many), true],
		["find_blades within 0.4 m", around.size(), func() -> void: _field.find_blades(_place, 0.4), true],
		["get_mown_share of 10 x 10 m", 0, func() -> void: _field.get_mown_share(lawn), true],
		["get_mown_share of the field", 0, func() -> void: _field.get_mown_share(), true],
		["get_awake_tile_count", 0, func() -> void: _field.get_awake_tile_count(), true],
		["get_memory_usage", 0, func() -> void: _field.get_memory_usage(), true],
		["get_statistics", 0, func() -> void: _field.get_statistics(), true],
		["density_at after a stroke", 0, func() -> void: _field.get_density_at(_place), false, _paint],
		["height_at after a stroke", 0, func() -> void: _field.get_height_at(_place), false, _paint],
		["wait_for_knots", 1, func() -> void: _field.wait_for_knots(blades.slice(3, 4)), false],
		["wait_for_knots", 64, func() -> void: _field.wait_for_knots(blades), false],
	]


func _paint() -> void:
	_field.map.stroke(_brush(), Vector2(-1, 0), Vector2(1, 0))


func _brush() -> GrassBrush:
	var brush := GrassBrush.new()
	brush.tool = GrassBrush.TOOL_DENSITY if _field == null or randf() < 0.5 else GrassBrush.TOOL_HEIGHT
	return brush
