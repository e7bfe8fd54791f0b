# SPDX-License-Identifier: MIT
## The time of a tick for reading a crowd, moving and asleep: the quickest tick and the median. The pool is tiny, so that little is
## simulated.
extends Node3D

const Cpu := preload("res://bench/bench_cpu.gd")
const SIDE := 500.0  # metres
const POOL := 16  # tiles
const BODIES: Array[int] = [128, 1024, 5000]
const WARM_UP := 200  # ticks: bodies fall asleep
const TICKS := 300
const TIMES: Array[String] = ["gather_ms", "tiles_ms"]
const COUNTS: Array[String] = ["body_reads", "engine_calls", "tiles_looked_at"]  # a tick


func run(_p_software: bool) -> Array[PackedStringArray]:
	var header: PackedStringArray = ["bodies", "crowd"]
	for time in TIMES:
		header.append_array([time + "_min", time + "_median"])
	header.append_array(COUNTS.map(func(p_name: String) -> String: return p_name + "_a_tick"))
	var rows: Array[PackedStringArray] = [header]
	get_viewport().disable_3d = true
	for bodies in BODIES:
		for crowd: String in ["moving", "asleep"]:
			rows.append(await _measure(bodies, crowd))
			print(", ".join(rows[-1]))
	get_viewport().disable_3d = false
	return rows


func _measure(p_bodies: int, p_crowd: String) -> PackedStringArray:
	var field := GrassField.new()
	field.size = Vector2.ONE * SIDE
	field.pool_tiles = POOL
	add_child(field)
	var source := Cpu.new()
	add_child(source)
	var bodies: Array[RigidBody3D] = []
	for i in p_bodies:
		var body := source._add_body(i)
		if p_crowd == "asleep":
			body.linear_velocity = Vector3.ZERO
			body.angular_velocity = Vector3.ZERO
			body.can_sleep = true
		bodies.append(body)
	var times := {}
	var before := {}
	for tick in WARM_UP + TICKS:
		await get_tree().physics_frame
		if p_crowd == "moving":
			source._turn_back(bodies)
		var now := field.get_counters()
		if tick == WARM_UP:
			before = now
		if tick >= WARM_UP:
			for time in TIMES:
				times.get_or_add(time, []).append(now[time])
	var after := field.get_counters()
	var row: PackedStringArray = [str(p_bodies), p_crowd]
	for time in TIMES:
		times[time].sort()
		row.append_array(["%.4f" % times[time][0], "%.4f" % times[time][TICKS >> 1]])
	for count in COUNTS:
		row.append("%.1f" % (float(after[count] - before[count]) / TICKS))
	for node: Node in [field, source]:
		node.queue_free()
	await get_tree().process_frame
	return row
