# SPDX-License-Identifier: MIT
## Ground of 128 x 128 m as one field and cut into many, at rest: draws, the renderer's memory and the time of a frame, from the middle of
## one edge at eye level, where all of it is in view, under a sun with shadows. Each number of fields is measured against none.
extends Node3D

const Measure := preload("res://bench/measure.gd")
const Scenery := preload("res://bench/scenery.gd")
const SIDE := 128.0  # metres
const COUNTS: Array[int] = [0, 1, 16, 64]
const WARM_UP := 30  # frames
const FRAMES := 120


func run(p_small: bool) -> Array[PackedStringArray]:
	var camera := Scenery.add_camera(self)
	Scenery.add_sun(self, true)
	camera.position = Vector3(0.0, 1.7, 0.5 * SIDE + 2.0)
	RenderingServer.viewport_set_measure_render_time(get_viewport().get_viewport_rid(), true)
	var rows: Array[PackedStringArray] = [
		["fields", "draws", "video_mb", "textures_mb", "buffers_mb", "objects", "tick_ms", "wall_ms", "gpu_ms"]
	]
	for count in COUNTS:
		var fields := _add_lawns(count, 64 if p_small else 4096)
		for field in fields:
			await Scenery.compiled(field)
		rows.append(await _measure(count, 4 if p_small else FRAMES, 4 if p_small else WARM_UP))
		for field in fields:
			field.queue_free()
		for i in 5:
			await get_tree().process_frame
	return rows


func _add_lawns(p_count: int, p_pool_tiles: int) -> Array[GrassField]:
	var fields: Array[GrassField] = []
	var across := roundi(sqrt(p_count))
	for i in p_count:
		var field := GrassField.new()
		field.size = Vector2.ONE * SIDE / across
		@warning_ignore("integer_division")
		field.position = Vector3(i % across + 0.5 - 0.5 * across, 0.0, i / across + 0.5 - 0.5 * across) * SIDE / across
		field.pool_tiles = p_pool_tiles
		add_child(field)
		fields.append(field)
	return fields


func _measure(p_count: int, p_frames: int, p_warm_up: int) -> PackedStringArray:
	for i in p_warm_up:
		await get_tree().process_frame
	var wall: Array[float] = []
	var gpu: Array[float] = []
	var tick: Array[float] = []
	var before := Time.get_ticks_usec()
	for i in p_frames:
		await RenderingServer.frame_post_draw
		var now := Time.get_ticks_usec()
		wall.append((now - before) * 1e-3)
		gpu.append(RenderingServer.viewport_get_measured_render_time_gpu(get_viewport().get_viewport_rid()))
		tick.append(1e3 * Performance.get_monitor(Performance.TIME_PHYSICS_PROCESS))
		before = now
	var row: PackedStringArray = [str(p_count), str(int(Performance.get_monitor(Performance.RENDER_TOTAL_DRAW_CALLS_IN_FRAME)))]
	for monitor: Performance.Monitor in [
		Performance.RENDER_VIDEO_MEM_USED, Performance.RENDER_TEXTURE_MEM_USED, Performance.RENDER_BUFFER_MEM_USED
	]:
		row.append("%.1f" % (Performance.get_monitor(monitor) / 1e6))
	row.append(str(int(Performance.get_monitor(Performance.OBJECT_COUNT))))
	for times: Array[float] in [tick, wall, gpu]:
		row.append("%.3f" % Measure.median(times))
	return row
