# SPDX-License-Identifier: MIT
## What each level of GrassQuality saves: GPU time of a frame of a meadow, without a headset and for both eyes of one. The headset is the
## engine's own for phones, which needs the engine's argument `--xr-mode on`.
extends Node3D

const Measure := preload("res://bench/measure.gd")
const Scenery := preload("res://bench/scenery.gd")

const SIDE := 128.0  # metres
const FRAMES := 40
const ROUNDS := 3
const LEVELS := {
	"nothing": GrassQuality.LEVEL_HIGH,
	"low": GrassQuality.LEVEL_LOW,
	"medium": GrassQuality.LEVEL_MEDIUM,
	"high": GrassQuality.LEVEL_HIGH,
	"ultra": GrassQuality.LEVEL_ULTRA,
}

var _rig: XROrigin3D
var _field: GrassField
var _headset: XRInterface = XRServer.find_interface("Native mobile")


func run(p_software: bool) -> Array[PackedStringArray]:
	var rows: Array[PackedStringArray] = [
		["eyes", "level", "gpu_ms", "drawn_blades", "shadow_blades", "drawn_triangles", "pixels_wide", "pixels_high"]
	]
	_build(12.0 if p_software else SIDE)
	for eyes: int in [1, 2]:
		if eyes == 2 and not _put_on():
			break
		await Scenery.compiled(_field)
		var times := {}
		for round in 1 if p_software else ROUNDS:  # in turn, so that a rising clock favours none of them
			for level: String in LEVELS:
				var known: Array[float] = times.get_or_add(level, [] as Array[float])
				known.append(await _measure(level, p_software))
				if round == 0:
					rows.append(_row(eyes, level))
		for row: PackedStringArray in rows.slice(rows.size() - LEVELS.size()):
			row[2] = "%.3f" % Measure.median(times[row[1]])
			rows[rows.find(row)] = row
	get_viewport().use_xr = false
	GrassQuality.reset_level()
	return rows


func _build(p_side: float) -> void:
	_rig = XROrigin3D.new()
	_field = GrassField.new()
	var eye := XRCamera3D.new()
	eye.far = 600.0
	_rig.position = Vector3(0, 0, 0.45 * p_side)
	_rig.add_child(eye)
	add_child(_rig)
	eye.current = true
	eye.position.y = 1.7  # a headset sets it itself
	Scenery.add_sun(self, true)
	_field.size = Vector2(p_side, p_side)
	_field.wind_speed = 3.0
	add_child(_field)
	RenderingServer.viewport_set_measure_render_time(get_viewport().get_viewport_rid(), true)


func _put_on() -> bool:
	if _headset == null or not _headset.initialize():
		return false
	get_viewport().use_xr = true
	return true


## Returns milliseconds of a frame. The rig moves slowly, since a still picture is not culled again.
func _measure(p_level: String, p_software: bool) -> float:
	_field.visible = p_level != "nothing"
	GrassQuality.set_level(LEVELS[p_level])
	var times: Array[float] = []
	for frame in 4 if p_software else FRAMES:
		_rig.position.x = 0.01 * frame
		await RenderingServer.frame_post_draw
		if 2 * frame >= (0 if p_software else FRAMES):
			times.append(RenderingServer.viewport_get_measured_render_time_gpu(get_viewport().get_viewport_rid()))
	return Measure.median(times)


func _row(p_eyes: int, p_level: String) -> PackedStringArray:
	var now := _field.get_statistics().merged(_field.get_counters())
	var counts: Array[int] = [0, 0, 0]
	if _field.visible:
		counts = [now.drawn_blades, now.shadow_blades, now.drawn_triangles]
	var pixels := Vector2i(_headset.get_render_target_size()) if p_eyes == 2 else get_window().size
	return [str(p_eyes), p_level, "", str(counts[0]), str(counts[1]), str(counts[2]), str(pixels.x), str(pixels.y)]
