# SPDX-License-Identifier: MIT
## GPU and wall time of drawn frames. GPU time is the engine's measurement of the viewport: it leaves out compute passes outside of it, such
## as simulation and culling.
extends RefCounted

const WARM_UP := 4  # frames, at least: times arrive two frames late, shaders are compiled in the first
const LEAST := 3  # frames

var frames := 24  ## measured, at most
var seconds := 1.5  ## the longest time to measure; warming up takes half as long, at most

var _viewport: Viewport


## Measures as few frames as make sense on software Vulkan.
func _init(p_viewport: Viewport, p_software: bool) -> void:
	_viewport = p_viewport
	if p_software:
		frames = 1
	RenderingServer.viewport_set_measure_render_time(p_viewport.get_viewport_rid(), true)


## {gpu_ms, wall_ms}: medians. The camera moves slowly, since a still picture is not culled again.
func measure(p_camera: Camera3D) -> Dictionary:
	await _shown()
	await _draw(p_camera, frames / 2, 0.5 * seconds, WARM_UP)
	var times := await _draw(p_camera, frames, seconds, LEAST)
	var median := preload("res://bench/measure.gd").median
	return {gpu_ms = median.call(times[0]), wall_ms = median.call(times[1])}


## Waits for frames until all fields are drawn with their present properties: worker threads make their shaders.
func _shown() -> void:
	var waits := func(field: GrassField) -> bool: return field.get_statistics().waiting
	await RenderingServer.frame_post_draw
	var fields := _viewport.find_children("*", "GrassField", true, false)
	while fields.any(waits):
		await RenderingServer.frame_post_draw


func _draw(p_camera: Camera3D, p_frames: int, p_seconds: float, p_least: int) -> Array:
	var gpu: Array[float] = []
	var wall: Array[float] = []
	var start := Time.get_ticks_usec()
	var before := start
	while gpu.size() < p_least or gpu.size() < p_frames and before - start < p_seconds * 1e6:
		p_camera.position.y += 1e-4
		await RenderingServer.frame_post_draw
		var now := Time.get_ticks_usec()
		wall.append((now - before) * 1e-3)
		gpu.append(RenderingServer.viewport_get_measured_render_time_gpu(_viewport.get_viewport_rid()))
		before = now
	return [gpu, wall]


## From eye level into a field of p_side metres, or from above onto all of it.
static func look(p_camera: Camera3D, p_view: String, p_side: float) -> void:
	if p_view == "above":
		p_camera.position = Vector3(0.0, 0.6 * p_side, 0.35 * p_side)
		p_camera.look_at(Vector3.ZERO)
	else:
		p_camera.position = Vector3(0.0, 1.7, 0.45 * p_side)
		p_camera.rotation = Vector3(-0.12, 0.0, 0.0)
