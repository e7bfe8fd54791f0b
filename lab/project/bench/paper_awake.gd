# SPDX-License-Identifier: MIT
## The paper's figure 7: time of a simulation step against awake blades, and against all blades with 64 K of them awake.
## A lid lies in the tips of the grass. Physics ticks come faster than in a game, so that the card does not idle between two steps: a card
## that idles runs a short step at a low clock.
extends Node3D

const Scenery := preload("res://bench/scenery.gd")
const Table := preload("res://bench/table.gd")

const TICK_RATE := 600  # Hz
const TICKS_A_FRAME := 8
const SECONDS := 0.5  # measured, after as many to warm up
const SIDE := 70.5  # metres: 1.27 million blades
const AWAKE: Array[int] = [4096, 3136, 2304, 1600, 1024, 576, 256, 64]  # tiles; the most first, so that the clock has risen
const TOTAL: Array[float] = [256.0, 128.0, 64.0, 32.0, 16.0]  # metres: 16 million to 64 K blades
const HALF := 1024  # tiles: 64 K blades

var _software := false


func run(r_table: Table, p_software: bool) -> void:
	_software = p_software
	r_table.columns(["series", "blades", "awake_blades", "simulate_ms", "management_ms", "outcome"])
	var rate := Engine.physics_ticks_per_second
	var most := Engine.max_physics_steps_per_frame
	if not p_software:
		Engine.physics_ticks_per_second = TICK_RATE
		Engine.max_physics_steps_per_frame = TICKS_A_FRAME
	get_viewport().disable_3d = true
	for tiles: int in [64, 16] if p_software else AWAKE:
		r_table.add(await _measure("awake", 16.0 if p_software else SIDE, tiles))
	for side: float in [16.0, 8.0] if p_software else TOTAL:
		r_table.add(await _measure("total", side, 36 if p_software else HALF))
	get_viewport().disable_3d = false
	Engine.physics_ticks_per_second = rate
	Engine.max_physics_steps_per_frame = most


func _measure(p_series: String, p_side: float, p_tiles: int) -> Dictionary:
	var field := GrassField.new()
	field.simulation_detail = GrassField.SIMULATION_WHOLE
	field.size = Vector2(p_side, p_side)
	field.pool_tiles = p_tiles  # so no more than these are awake
	field.measure_time = true
	add_child(field)
	await Scenery.compiled(field)
	var lid := Scenery.add_lid(self, 0.1)
	await _frames(3)
	var box: BoxShape3D = lid.get_child(0).shape
	while box.size.x < p_side + 1.0 and field.get_awake_tile_count() < p_tiles:  # grows until it has woken so many
		box.size = Vector3(box.size.x + 0.4, 0.2, box.size.z + 0.4)
		await _frames(2)
	await _shake(field, lid)
	var times := await _shake(field, lid)
	var awake := field.get_awake_tile_count()
	var row := {
		series = p_series,
		blades = field.get_blade_count(),
		awake_blades = awake * 64,
		simulate_ms = preload("res://bench/measure.gd").median(times[0]),
		management_ms = preload("res://bench/measure.gd").median(times[1])
	}
	if awake < p_tiles:
		row.outcome = "%d of %d tiles awake" % [awake, p_tiles]
	elif row.simulate_ms <= 0.0:
		row.outcome = "no time was measured"
	lid.queue_free()
	field.queue_free()
	await get_tree().process_frame
	return row


## Moves the lid for some time; returns [simulate_ms, management_ms] of each frame.
func _shake(p_field: GrassField, r_lid: Node3D) -> Array:
	var simulate: Array[float] = []
	var management: Array[float] = []
	var start := Time.get_ticks_msec()
	while simulate.size() < 12 or Time.get_ticks_msec() - start < SECONDS * 1e3 and not _software:
		r_lid.position.y = 0.45 + 0.02 * sin(Engine.get_physics_frames() * 0.02)
		await get_tree().physics_frame
		await get_tree().process_frame
		var now := p_field.get_statistics()
		simulate.append(now.simulate_ms)
		management.append(now.management_ms)
	return [simulate, management]


func _frames(p_count: int) -> void:
	for i in p_count:
		await get_tree().physics_frame
		await get_tree().process_frame
