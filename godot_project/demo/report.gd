# SPDX-License-Identifier: MIT
## The demo's table: the size of the field, the awake tiles over time, and the times.
extends RefCounted

var _field: GrassField
var _awake: Array[String] = []  # one entry every half second
var _management: Array[float] = []  # ms, each tick
var _simulate: Array[float] = []  # ms, each tick
var _draw: Array[float] = []  # ms, each picture
var _most_awake := 0


func _init(p_field: GrassField) -> void:
	_field = p_field


func tick(p_time: float) -> void:
	var statistics := _field.get_statistics()
	var awake: int = statistics.awake_tiles
	_most_awake = maxi(_most_awake, awake)
	_management.append(statistics.management_ms)
	if statistics.simulate_ms > 0.0:
		_simulate.append(statistics.simulate_ms)
	if p_time >= 0.5 * _awake.size():
		_awake.append("%.1f s: %d" % [p_time, awake])


func frame(p_draw_ms: float) -> void:
	if p_draw_ms > 0.0:
		_draw.append(p_draw_ms)


func table(p_bodies: int, p_software: bool) -> String:
	var statistics := _field.get_statistics().merged(_field.get_counters())
	var rows: Array[PackedStringArray] = [
		["device", RenderingServer.get_video_adapter_name() + (" (software)" if p_software else "")],
		["renderer", RenderingServer.get_current_rendering_method()],
		["backend", statistics.backend],
		["blades", _with_commas(statistics.blades)],
		["tiles", _with_commas(_field.get_grid_size().x * _field.get_grid_size().y)],
		["bodies", str(p_bodies)],
		["awake tiles", ", ".join(_awake)],
		["most awake", "%d tiles, %s blades" % [_most_awake, _with_commas(_most_awake * 64)]],
		["pool", "%d tiles gave way, %d wishes refused" % [statistics.evicted, statistics.refused]],
		["tile steps", _with_commas(statistics.tile_steps)],
		["blade steps", _with_commas(statistics.simulated_blades)],
		[
			"drawn (last view)",
			"%s blades, %s triangles" % [_with_commas(statistics.drawn_blades), _with_commas(statistics.drawn_triangles)]
		],
		["draw", _range(_draw, "ms GPU a frame")],
		["simulate", _range(_simulate, "ms a tick")],
		["tile management", _range(_management, "ms CPU a tick")],
		["cull", "%.3f ms" % statistics.cull_ms],
		["memory", "%.1f MB" % (statistics.memory / 1e6)],
	]
	var lines: Array[String] = []
	for row in rows:
		lines.append("  %-18s %s" % [row[0], row[1]])
	return "\n".join(lines)


func _range(p_values: Array[float], p_unit: String) -> String:
	if p_values.is_empty():
		return "not measured"
	var sorted := p_values.duplicate()
	sorted.sort()
	return "median %.3f, most %.3f %s" % [sorted[sorted.size() >> 1], sorted[-1], p_unit]


func _with_commas(p_number: int) -> String:
	var text := str(p_number)
	for at in range(text.length() - 3, 0, -3):
		text = text.insert(at, ",")
	return text
