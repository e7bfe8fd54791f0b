# SPDX-License-Identifier: MIT
## GPU time of a drawn frame against the number of blades, from eye level and from above, with and without shadows.
extends Node3D

const FrameTimer := preload("res://bench/frame_timer.gd")
const Scenery := preload("res://bench/scenery.gd")
const FRAMES := 24  # measured, after as many to warm up

var _field: GrassField
var _camera: Camera3D
var _sun: DirectionalLight3D


func run(p_software: bool) -> Array[PackedStringArray]:
	_camera = Scenery.add_camera(self)
	_sun = Scenery.add_sun(self, false)
	_field = GrassField.new()
	_field.measure_time = true
	add_child(_field)
	get_viewport().msaa_3d = Viewport.MSAA_DISABLED
	RenderingServer.viewport_set_measure_render_time(get_viewport().get_viewport_rid(), true)
	var rows: Array[PackedStringArray] = [["blades", "view", "shadows", "msaa", "drawn_blades", "drawn_triangles", "gpu_ms", "cull_ms"]]
	rows.append(await _measure("nothing", 0.0, false, 0, 1 if p_software else FRAMES))
	for side: float in [4.0, 8.0] if p_software else [32.0, 64.0, 128.0, 256.0]:
		for view: String in ["eye", "above"]:
			for shadows: bool in [false, true]:
				rows.append(await _measure(view, side, shadows, 0, 1 if p_software else FRAMES))
	if not p_software:
		rows.append(await _measure("eye", 64.0, true, 2, FRAMES))
	return rows


func _measure(p_view: String, p_side: float, p_shadows: bool, p_msaa: int, p_frames: int) -> PackedStringArray:
	_field.visible = p_side > 0.0
	_field.size = Vector2.ONE * maxf(p_side, 1.0)
	_sun.shadow_enabled = p_shadows
	get_viewport().msaa_3d = p_msaa as Viewport.MSAA
	FrameTimer.look(_camera, p_view, p_side)
	while _field.visible and _field.get_statistics().waiting:
		await RenderingServer.frame_post_draw
	var times: Array[float] = []
	for frame in 2 * p_frames + 4:
		_camera.position.y += 1e-4  # a still picture would not be culled again
		await RenderingServer.frame_post_draw
		if frame >= p_frames + 4:
			times.append(RenderingServer.viewport_get_measured_render_time_gpu(get_viewport().get_viewport_rid()))
	var statistics := _field.get_statistics()
	var blades: int = statistics.blades if _field.visible else 0
	return [
		str(blades),
		p_view,
		"on" if p_shadows else "off",
		str(p_msaa),
		str(statistics.drawn_blades if blades else 0),
		str(statistics.drawn_triangles if blades else 0),
		"%.3f" % preload("res://bench/measure.gd").median(times),
		"%.4f" % statistics.cull_ms
	]
