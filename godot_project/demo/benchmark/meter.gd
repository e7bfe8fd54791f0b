# SPDX-License-Identifier: MIT
## Measures frames, and what the grass does in them.
extends RefCounted

## What is measured in each frame, milliseconds. frame: from one frame to the next. gpu: drawing the picture, without compute passes. cpu:
## drawing, on the processor. simulate, cull: the field's compute passes, or the same on the processor. manage: what a tick of the field
## takes on the processor. physics: the engine's own, and everything in a tick.
const TIMES: Array[String] = ["frame", "gpu", "cpu", "simulate", "cull", "manage", "physics"]
## Counted at the end.
const COUNTS: Array[String] = ["blades", "drawn_blades", "drawn_triangles", "awake_tiles", "memory"]

var _viewport: Viewport
var _times := {}
var _last := 0  # microseconds


func _init(viewport: Viewport) -> void:
	_viewport = viewport
	RenderingServer.viewport_set_measure_render_time(viewport.get_viewport_rid(), true)
	for key in TIMES:
		_times[key] = PackedFloat64Array()


## Call it once a frame.
func look(field: GrassField) -> void:
	var now := Time.get_ticks_usec()
	var facts := field.get_statistics()
	var rid := _viewport.get_viewport_rid()
	if _last > 0:
		_times.frame.append((now - _last) * 1e-3)
		_times.gpu.append(RenderingServer.viewport_get_measured_render_time_gpu(rid))
		_times.cpu.append(RenderingServer.viewport_get_measured_render_time_cpu(rid) + RenderingServer.get_frame_setup_time_cpu())
		_times.simulate.append(facts.simulate_ms)
		_times.cull.append(facts.cull_ms)
		_times.manage.append(facts.management_ms)
		_times.physics.append(Performance.get_monitor(Performance.TIME_PHYSICS_PROCESS) * 1e3)
	_last = now


## {frames, TIME: [median, the time that one frame in a hundred exceeds], COUNT: number, ...}
func result(field: GrassField) -> Dictionary:
	var facts := field.get_statistics().merged(field.get_counters())
	var made := {frames = _times.frame.size()}
	for key in TIMES:
		var sorted: PackedFloat64Array = _times[key].duplicate()
		sorted.sort()
		made[key] = [_rounded(sorted, 0.5), _rounded(sorted, 0.99)]
	for key in COUNTS:
		made[key] = int(facts.get(key, 0))
	return made


static func _rounded(sorted: PackedFloat64Array, share: float) -> float:
	return snappedf(sorted[mini(int(share * sorted.size()), sorted.size() - 1)], 0.001) if sorted else 0.0
