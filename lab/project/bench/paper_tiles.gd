# SPDX-License-Identifier: MIT
## Tiles of 64 blades against tiles of 256 at the same density, 128 thrown bodies, after the paper's section 6. A tile of
## ours always has 64 blades: tiles of 256 are four fields on one spot, each a quarter as dense with tiles twice as wide, that
## the same bodies wake together.
extends Node3D

const Scenery := preload("res://bench/scenery.gd")
const Table := preload("res://bench/table.gd")

const SIDE := 71.0  # metres: 20,164 tiles of 64 blades or 5,041 of 256
const DENSITY := 256.0  # blades a square metre
const BODIES := 128
const THROWS := 3
const SECONDS := 5.0  # after the throw
const TICK_RATE := 600  # Hz: a card that idles between steps takes them at a low clock


func run(r_table: Table, p_software: bool) -> void:
	var rate := Engine.physics_ticks_per_second
	if not p_software:
		Engine.physics_ticks_per_second = TICK_RATE
	get_viewport().disable_3d = true
	Scenery.add_ground(self)
	r_table.columns(["blades_a_tile", "throw", "blades", "awake_tiles", "awake_blades", "simulate_ms", "outcome"])
	for throw in 1 if p_software else THROWS:
		for fields: int in [1, 4]:
			r_table.add(
				await _measure(fields, throw, 8.0 if p_software else SIDE, 8 if p_software else BODIES, 0.7 if p_software else SECONDS)
			)
	get_viewport().disable_3d = false
	Engine.physics_ticks_per_second = rate


func _measure(p_fields: int, p_throw: int, p_side: float, p_bodies: int, p_seconds: float) -> Dictionary:
	var fields: Array[GrassField] = []
	for i in p_fields:
		var field := GrassField.new()
		field.simulation_detail = GrassField.SIMULATION_WHOLE
		field.size = Vector2(p_side, p_side)
		field.density = DENSITY / p_fields
		field.seed = i
		field.sleep_mode = GrassField.SLEEP_TIMER  # as in the paper
		field.measure_time = true  # a field's time is the mean of all that are measured in a frame
		add_child(field)
		fields.append(field)
	await Scenery.compiled(fields[0])
	var bodies := Scenery.throw(self, p_bodies, p_side, 100 + p_throw)
	var simulate: Array[float] = []
	var ticks := roundi(p_seconds * Engine.physics_ticks_per_second)
	for tick in ticks:
		await get_tree().physics_frame
		if tick > 0.8 * ticks:  # before the end: a single step is noisy
			simulate.append(fields[0].get_statistics().simulate_ms * p_fields)
	var awake := 0
	var blades := 0
	for field in fields:
		awake += field.get_awake_tile_count()
		blades += field.get_blade_count()
	var row := {
		blades_a_tile = 64 * p_fields,
		throw = p_throw,
		blades = blades,
		awake_tiles = awake / p_fields,
		awake_blades = awake * 64,
		simulate_ms = preload("res://bench/measure.gd").median(simulate)
	}
	if awake == 0:
		row.outcome = "nothing was awake"
	elif row.simulate_ms <= 0.0:
		row.outcome = "no time was measured"
	for field in fields:
		field.queue_free()
	for body in bodies:
		body.queue_free()
	await get_tree().process_frame
	return row
