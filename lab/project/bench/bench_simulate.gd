# SPDX-License-Identifier: MIT
## Time of a simulation step against the number of awake blades. A flat box is in the tips of the grass, so that every
## tile below it is awake and has one object.
extends Node3D

const Scenery := preload("res://bench/scenery.gd")
const TICKS := 60


func run(p_software: bool) -> Array[PackedStringArray]:
	get_viewport().disable_3d = true
	var rows: Array[PackedStringArray] = [["awake_blades", "simulate_ms", "management_ms", "uploaded_bytes_a_tick", "ns_a_knot"]]
	for side: float in [2.0, 4.0] if p_software else [4.0, 8.0, 16.0, 24.0, 31.0]:
		rows.append(await _measure(side, 6 if p_software else TICKS))
	get_viewport().disable_3d = false
	return rows


func _measure(p_side: float, p_ticks: int) -> PackedStringArray:
	var field := GrassField.new()
	field.simulation_detail = GrassField.SIMULATION_WHOLE
	field.size = Vector2(64.0, 64.0)
	field.measure_time = true
	add_child(field)
	await Scenery.compiled(field)
	var body := Scenery.add_lid(self, p_side)
	var simulate: Array[float] = []
	var management: Array[float] = []
	var uploaded := 0
	for tick in p_ticks + 10:
		await get_tree().physics_frame
		body.position.y = 0.45 + 0.02 * sin(0.2 * tick)
		if tick == 10:
			uploaded = field.get_counters().uploaded_bytes
		if tick >= 10:
			await get_tree().process_frame
			simulate.append(field.get_statistics().simulate_ms)
			management.append(field.get_statistics().management_ms)
	var statistics := field.get_statistics().merged(field.get_counters())
	var median := preload("res://bench/measure.gd").median
	var blades: int = statistics.awake_tiles * 64
	var ms: float = median.call(simulate)
	body.queue_free()
	field.queue_free()
	await get_tree().process_frame
	return [
		str(blades),
		"%.4f" % ms,
		"%.4f" % median.call(management),
		str((statistics.uploaded_bytes - uploaded) / p_ticks),
		"%.3f" % (ms * 1e6 / maxi(1, blades * 16))
	]
