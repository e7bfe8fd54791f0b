# SPDX-License-Identifier: MIT
## What it saves to simulate only the blades that cameras need: the same bodies thrown over 4 M blades, with each detail, seen by a player
## at the edge. In software, and on the CPU, over a smaller field.
extends Node3D

const FrameTimer := preload("res://bench/frame_timer.gd")
const Measure := preload("res://bench/measure.gd")
const Scenery := preload("res://bench/scenery.gd")

const SIDE := 128.0  # metres: 4,194,304 blades
const BODIES := 128
const SPANS := [1.0, 3.0, 5.0, 7.0]  # seconds after the throw: ends of what each row measures
const DETAILS := {"whole": GrassField.SIMULATION_WHOLE, "seen": GrassField.SIMULATION_SEEN}


func run(p_software: bool) -> Array[PackedStringArray]:
	var rows: Array[PackedStringArray] = [
		[
			"detail",
			"seconds",
			"simulate_ms",
			"cull_ms",
			"management_ms",
			"awake_blades",
			"simulated_blades_a_tick",
			"tiles_a_tick",
			"workgroups_a_tick",
			"widened_tiles_a_tick"
		]
	]
	var camera := Scenery.add_camera(self)
	FrameTimer.look(camera, "eye", 16.0 if p_software else SIDE)
	Scenery.add_ground(self)
	Scenery.add_sun(self, true)
	for warm: bool in [true, false]:  # first once, so that all passes are compiled
		for detail: String in DETAILS:
			var made := await _measure(detail, p_software, warm)
			if not warm:
				rows.append_array(made)
	return rows


func _measure(p_detail: String, p_software: bool, p_warm: bool) -> Array[PackedStringArray]:
	var side := 16.0 if p_software else SIDE
	var field := GrassField.new()
	field.size = Vector2(side, side)
	field.measure_time = true
	field.simulation_detail = DETAILS[p_detail]
	add_child(field)
	await Scenery.compiled(field)
	var bodies := Scenery.throw(self, 8 if p_software else BODIES, side, 7)
	var rows: Array[PackedStringArray] = []
	var ticks := 8 if p_warm and p_software else 60 if p_warm else roundi(SPANS[-1] * Engine.physics_ticks_per_second)
	var span := 0
	var from := field.get_counters()
	var times := {simulate_ms = [] as Array[float], cull_ms = [] as Array[float], management_ms = [] as Array[float]}
	var awake: Array[float] = []
	for tick in ticks:
		await get_tree().physics_frame
		var now := field.get_statistics()
		for key: String in times:
			times[key].append(float(now[key]))
		awake.append(now.awake_tiles * 64.0)
		if tick + 1 >= SPANS[span] * Engine.physics_ticks_per_second:
			var to := field.get_counters()
			var steps := maxi(to.steps - from.steps, 1)
			var row: PackedStringArray = [p_detail, "%.0f" % SPANS[span]]
			for key: String in times:
				row.append("%.4f" % Measure.median(times[key]))
				times[key].clear()
			row.append("%.0f" % Measure.median(awake))
			awake.clear()
			for key: String in ["simulated_blades", "tile_steps", "workgroups", "widened_tiles"]:
				row.append("%.1f" % (float(to[key] - from[key]) / steps))
			rows.append(row)
			from = to
			span += 1
	if p_warm:
		await Scenery.compiled(field)
	for node: Node in bodies + [field]:
		node.queue_free()
	await get_tree().process_frame
	return rows
