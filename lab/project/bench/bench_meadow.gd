# SPDX-License-Identifier: MIT
## A meadow of ten million blades from eye level, as a game would show it (2x MSAA): GPU time of a frame with and without shadows,
## of plain grass, and of four species on a painted map. The kinds run in turn, so that a rising clock favours none of them.
extends Node3D

const FrameTimer := preload("res://bench/frame_timer.gd")
const Measure := preload("res://bench/measure.gd")
const Scenery := preload("res://bench/scenery.gd")
const SIDE := 400.0  # metres
const DENSITY := 64.0  # blades a square metre
const ROUNDS := 3
const KINDS: Array[String] = ["nothing", "plain", "painted"]


func run(p_software: bool) -> Array[PackedStringArray]:
	get_viewport().msaa_3d = Viewport.MSAA_2X
	var times := {}
	for round in 1 if p_software else ROUNDS:
		for kind in KINDS:
			for shadows: bool in [false, true]:
				var known: Array = times.get_or_add([kind, shadows], [])
				known.append(await _measure(kind, shadows, p_software))
	var rows: Array[PackedStringArray] = [
		["field", "shadows", "gpu_ms", "least_ms", "most_ms", "drawn_blades", "shadow_blades", "drawn_triangles", "cull_ms"]
	]
	for key: Array in times:
		var gpu: Array[float] = []
		for time: Dictionary in times[key]:
			gpu.append(time.gpu_ms)
		var last: Dictionary = times[key][-1]
		rows.append(
			[
				key[0],
				"on" if key[1] else "off",
				"%.4f" % Measure.median(gpu),
				"%.4f" % gpu.min(),
				"%.4f" % gpu.max(),
				str(last.get("drawn_blades", 0)),
				str(last.get("shadow_blades", 0)),
				str(last.get("drawn_triangles", 0)),
				"%.4f" % last.get("cull_ms", 0.0)
			]
		)
	get_viewport().msaa_3d = Viewport.MSAA_DISABLED
	return rows


## Returns the frame timer's results, and the field's statistics.
func _measure(p_kind: String, p_shadows: bool, p_software: bool) -> Dictionary:
	var camera := Scenery.add_camera(self)
	var sun := Scenery.add_sun(self, p_shadows)
	var side := 8.0 if p_software else SIDE
	var timer := FrameTimer.new(get_viewport(), p_software)
	FrameTimer.look(camera, "eye", side)
	var field := GrassField.new()
	field.size = Vector2.ONE * side
	field.density = DENSITY
	field.measure_time = true
	field.wind_speed = 3.0
	field.visible = p_kind != "nothing"
	if p_kind == "painted":
		_paint(field, side)
	add_child(field)
	for i in 4:
		await get_tree().process_frame
	var times: Dictionary = await timer.measure(camera)
	if field.visible:
		times.merge(field.get_statistics())
		times.merge(field.get_counters())
	for node: Node in [camera, sun, field]:
		node.queue_free()
	await get_tree().process_frame
	return times


## Four species in stands; hills, paths and mown stripes on a map that covers the field.
func _paint(p_field: GrassField, p_side: float) -> void:
	var species: Array[GrassSpecies] = []
	for i in 4:
		species.append(GrassSpecies.new())
	p_field.species = species
	var map := GrassMap.new()
	map.base_density = 1.0
	var brush := GrassBrush.new()
	brush.radius = 0.02 * p_side
	for tool: int in [GrassBrush.TOOL_PAINT, GrassBrush.TOOL_CUT, GrassBrush.TOOL_TINT, GrassBrush.TOOL_FLATTEN]:
		brush.tool = tool as GrassBrush.Tool
		for stripe in 5:
			var z := p_side * (0.2 * stripe - 0.4 + 0.04 * tool)
			map.stroke(brush, Vector2(-0.5 * p_side, z), Vector2(0.5 * p_side, z))
	p_field.map = map
