# SPDX-License-Identifier: MIT
## The time that a large field at rest adds to a frame: behind the camera, hidden, and in view of a still camera without wind. The kinds run
## in turn, so that a rising clock favours none of them.
extends Node3D

const Measure := preload("res://bench/measure.gd")
const Scenery := preload("res://bench/scenery.gd")
const SIDE := 500.0  # metres: 64 million blades
const KINDS: Array[String] = ["nothing", "behind", "hidden", "in_view"]
const ROUNDS := 3
const WARM_UP := 30  # frames
const FRAMES := 120
const COUNTS: Array[String] = ["steps", "culls", "uploaded_bytes", "wind_updates", "instance_updates", "body_reads", "tiles_looked_at"]


func run(p_software: bool) -> Array[PackedStringArray]:
	var camera := Scenery.add_camera(self)
	var field := GrassField.new()
	field.size = Vector2.ONE * (8.0 if p_software else SIDE)
	field.wind_speed = 0.0
	camera.position = Vector3(0.0, 1.7, 0.5 * field.size.y + 2.0)
	RenderingServer.viewport_set_measure_render_time(get_viewport().get_viewport_rid(), true)
	var times := {}
	for round in 1 if p_software else ROUNDS:
		for kind in KINDS:
			field.visible = kind in ["behind", "in_view"]
			if kind == "nothing" and field.is_inside_tree():
				remove_child(field)
			elif kind != "nothing" and not field.is_inside_tree():
				add_child(field)
				await Scenery.compiled(field)
			camera.rotation.y = PI if kind == "behind" else 0.0
			await _frames(20 if p_software else WARM_UP)
			var before := field.get_counters()
			var measured := await _frames(20 if p_software else FRAMES)
			var after := field.get_counters()
			for count in COUNTS:
				measured[count] = float(after[count] - before[count]) / measured.wall.size()
			times.get_or_add(kind, []).append(measured)
	var rows: Array[PackedStringArray] = [["field", "blades", "wall_ms", "gpu_ms"]]
	rows[0].append_array(COUNTS.map(func(p_name: String) -> String: return p_name + "_a_frame"))
	for kind in KINDS:
		var row: PackedStringArray = [kind, str(field.get_blade_count())]
		for time: String in ["wall", "gpu"]:
			var rounds: Array[float] = []
			for measured: Dictionary in times[kind]:
				rounds.append(Measure.median(measured[time]))
			row.append("%.4f" % Measure.median(rounds))
		for count in COUNTS:
			row.append("%.2f" % times[kind][-1][count])
		rows.append(row)
	for node: Node in [camera, field]:
		node.queue_free()
	await get_tree().process_frame
	return rows


## Returns milliseconds of each of p_frames frames: {wall, gpu}.
func _frames(p_frames: int) -> Dictionary:
	var wall: Array[float] = []
	var gpu: Array[float] = []
	var before := Time.get_ticks_usec()
	for i in p_frames:
		await RenderingServer.frame_post_draw
		var now := Time.get_ticks_usec()
		wall.append((now - before) * 1e-3)
		gpu.append(RenderingServer.viewport_get_measured_render_time_gpu(get_viewport().get_viewport_rid()))
		before = now
	return {wall = wall, gpu = gpu}
