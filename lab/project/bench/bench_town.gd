# SPDX-License-Identifier: MIT
## What many fields cost: 128 x 128 m of grass, cut into 1, 16 and 64 lawns. Memory of the renderer at rest and once a ball has touched each
## lawn, draw calls, and frames of one tick each: idle, with 16 walkers, and the slowest one while a crowd falls onto sleeping lawns.
extends Node3D

const Measure := preload("res://bench/measure.gd")
const Scenery := preload("res://bench/scenery.gd")
const SIDE := 128.0  # metres
const CUTS: Array[int] = [0, 1, 4, 8]  # lawns along a side; 0: none, for what the rest of a frame costs
const WALKERS := 16
const CROWD := 128
const SPEED := 1.5  # m/s
const WARM_UP := 60  # frames
const FRAMES := 240
const SOFTWARE := 0.05  # share of these frames, and of the side, where the GPU is software

var _share := 1.0
var _walkers: Array[AnimatableBody3D] = []


func run(p_software: bool) -> Array[PackedStringArray]:
	_share = SOFTWARE if p_software else 1.0
	var camera := Scenery.add_camera(self)
	var sun := Scenery.add_sun(self, true)
	camera.position = Vector3(0, 12, 0.6 * _side())
	camera.look_at_from_position(camera.position, Vector3.ZERO)
	var rows: Array[PackedStringArray] = [
		["lawns", "video_mb", "touched_mb", "pool_mb", "draws", "idle_ms", "walk_ms", "walk_p90_ms", "crowd_ms", "crowd_worst_ms"]
	]
	for cut in CUTS:
		rows.append(await _measure(cut))
		print(", ".join(rows[-1]))
	sun.queue_free()
	camera.queue_free()
	await get_tree().process_frame
	return rows


func _side() -> float:
	return SIDE * (0.125 if _share < 1.0 else 1.0)


func _measure(p_cut: int) -> PackedStringArray:
	await _frames(5)
	var video_before := Performance.get_monitor(Performance.RENDER_VIDEO_MEM_USED)
	var lawns: Array[GrassField] = []
	for i in p_cut * p_cut:
		var lawn := GrassField.new()
		lawn.size = Vector2.ONE * _side() / p_cut
		lawn.position = Vector3(i % p_cut + 0.5, 0, i / p_cut + 0.5) * _side() / p_cut - Vector3(0.5, 0, 0.5) * _side()
		add_child(lawn)
		lawns.append(lawn)
	for lawn in lawns:
		await Scenery.compiled(lawn)
	await _frames(int(_share * WARM_UP) + 5)
	var row: PackedStringArray = [str(lawns.size())]
	row.append("%.1f" % (1e-6 * (Performance.get_monitor(Performance.RENDER_VIDEO_MEM_USED) - video_before)))
	var idle := await _frames(int(_share * FRAMES))
	var draws := RenderingServer.get_rendering_info(RenderingServer.RENDERING_INFO_TOTAL_DRAW_CALLS_IN_FRAME)
	for lawn in lawns:
		_walkers.append(Scenery.add_ball(self, lawn.position + Vector3(0, 0.2, 0)))
	await _frames(10)
	row.append("%.1f" % (1e-6 * (Performance.get_monitor(Performance.RENDER_VIDEO_MEM_USED) - video_before)))
	var pool := 0
	for lawn in lawns:
		pool += lawn.get_counters().get("pool_bytes", 0)
	row.append("%.1f" % (1e-6 * pool))
	row.append("%d" % draws)
	row.append("%.4f" % Measure.median(idle))
	_clear()
	for i in WALKERS:
		var aside := 0.8 * _side() * (fposmod(0.37 * i, 1.0) - 0.5)
		_walkers.append(Scenery.add_ball(self, Vector3(0.9 * _side() * ((i + 0.5) / WALKERS - 0.5), 0.3, aside)))
	await _frames(int(_share * WARM_UP), true)
	var walk := await _frames(int(_share * FRAMES), true)
	row.append("%.4f" % Measure.median(walk))
	row.append("%.4f" % _percentile(walk, 0.9))
	_clear()
	await _frames(int(_share * 600) + 5)  # the grass sleeps, and slots go
	_walkers = Scenery.add_crowd(self, CROWD, 0.9 * _side())
	var crowd := await _frames(int(_share * FRAMES), true)
	row.append("%.4f" % Measure.median(crowd))
	row.append("%.4f" % _percentile(crowd, 1.0))
	_clear()
	for lawn in lawns:
		lawn.queue_free()
	await _frames(5)
	return row


func _percentile(p_values: Array[float], p_share: float) -> float:
	var sorted := p_values.duplicate()
	sorted.sort()
	return sorted[mini(int(p_share * sorted.size()), sorted.size() - 1)] if sorted else 0.0


func _clear() -> void:
	for body in _walkers:
		body.queue_free()
	_walkers.clear()


## Returns milliseconds of each of p_count frames. p_walk: bodies walk meanwhile, and turn round at the border.
func _frames(p_count: int, p_walk := false) -> Array[float]:
	var times: Array[float] = []
	var before := Time.get_ticks_usec()
	for i in p_count:
		for body in _walkers if p_walk else [] as Array[AnimatableBody3D]:
			body.position.x += SPEED / Engine.physics_ticks_per_second
			if body.position.x > 0.45 * _side():
				body.position.x -= 0.9 * _side()
		await RenderingServer.frame_post_draw
		var now := Time.get_ticks_usec()
		times.append((now - before) * 1e-3)
		before = now
	return times
