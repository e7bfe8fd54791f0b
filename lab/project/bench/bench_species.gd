# SPDX-License-Identifier: MIT
## The cost of species: GPU time of a drawn frame and of a simulation step of a field with none, with one like the default, and with four in
## stands. The kinds run in turn, so that a rising clock favours none of them.
extends Node3D

const FrameTimer := preload("res://bench/frame_timer.gd")
const Measure := preload("res://bench/measure.gd")
const Scenery := preload("res://bench/scenery.gd")
const SIDE := 256.0  # metres: 16 million blades
const LID := 31.0  # metres: a quarter of a million blades awake
const TICKS := 60
const ROUNDS := 4
const KINDS: Array[int] = [0, 1, 4]


func run(p_software: bool) -> Array[PackedStringArray]:
	var times := {}
	for round in 1 if p_software else ROUNDS:
		for count in KINDS:
			for case: String in ["draw", "draw with shadows", "step under a lid", "step of free blades"]:
				var key := [count, case]
				var known: Array[float] = times.get_or_add(key, [] as Array[float])
				if case.begins_with("draw"):
					known.append(await _draw(count, case.ends_with("shadows"), p_software))
				else:
					known.append(await _step(count, case.ends_with("lid"), p_software))
	var rows: Array[PackedStringArray] = [["species", "case", "gpu_ms", "least_ms", "most_ms"]]
	for key: Array in times:
		var known: Array[float] = times[key]
		rows.append([str(key[0]), key[1], "%.4f" % Measure.median(known), "%.4f" % known.min(), "%.4f" % known.max()])
	return rows


func _field(p_species: int, p_side: float) -> GrassField:
	var field := GrassField.new()
	field.simulation_detail = GrassField.SIMULATION_WHOLE
	field.size = Vector2.ONE * p_side
	field.measure_time = true
	field.wind_speed = 3.0
	var species: Array[GrassSpecies] = []
	for i in p_species:
		species.append(GrassSpecies.new())
	field.species = species
	add_child(field)
	return field


func _draw(p_species: int, p_shadows: bool, p_software: bool) -> float:
	var camera := Scenery.add_camera(self)
	var sun := Scenery.add_sun(self, p_shadows)
	var side := 8.0 if p_software else SIDE
	var timer := FrameTimer.new(get_viewport(), p_software)
	FrameTimer.look(camera, "eye", side)
	var field := _field(p_species, side)
	for i in 4:
		await get_tree().process_frame
	var time: float = (await timer.measure(camera)).gpu_ms
	for node: Node in [camera, sun, field]:
		node.queue_free()
	await get_tree().process_frame
	return time


func _step(p_species: int, p_lid: bool, p_software: bool) -> float:
	get_viewport().disable_3d = true
	Engine.max_fps = Engine.physics_ticks_per_second  # where frames are quicker than ticks, most of them hold no step to time
	var side := 4.0 if p_software else LID
	var field := _field(p_species, 2.0 * side)
	field.wind_speed = 0.0
	field.sleep_delay = 60.0
	await Scenery.compiled(field)
	var body := Scenery.add_lid(self, side)
	var simulate: Array[float] = []
	for tick in 6 if p_software else 2 * TICKS:
		await get_tree().physics_frame
		body.position.y = 0.45 + 0.02 * sin(0.2 * tick)
		if not p_lid and tick >= 10:  # the blades that it woke swing on
			body.position.y = 100.0
		if tick >= (2 if p_software else TICKS):
			await get_tree().process_frame
			simulate.append(field.get_statistics().simulate_ms)
	body.queue_free()
	field.queue_free()
	await get_tree().process_frame
	get_viewport().disable_3d = false
	Engine.max_fps = 0
	return Measure.median(simulate)
