# SPDX-License-Identifier: MIT
## The savings of sleeping by energy: the demo's bodies, thrown through fields that are in one place and differ in how their tiles go to
## sleep. Counts, not times: they are the same on any machine, except that a slow GPU reports energies late.
extends Node3D

const Bodies := preload("res://demo/bodies.gd")
const Scenery := preload("res://bench/scenery.gd")

const SECONDS := 10.0  # as long as the demo waits before it throws again
const SIDE := 20.0  # metres
const BODIES := 128
const MODES: Dictionary[String, Dictionary] = {
	"while touched": {sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 0.0, settle_time = 0.0},  # the least that must be simulated
	"by timer": {sleep_mode = GrassField.SLEEP_TIMER},
	"by energy": {sleep_mode = GrassField.SLEEP_ENERGY},
}


func run(_p_software: bool) -> Array[PackedStringArray]:
	get_viewport().disable_3d = true
	_add_ground()
	var fields: Array[GrassField] = []
	for mode in MODES:
		fields.append(_add_field(MODES[mode]))
	await Scenery.compiled(fields[0])
	var source := Bodies.new(7)
	for i in BODIES:
		var body := source.make()
		source.throw(body, SIDE)
		add_child(body)
	for tick in roundi(SECONDS * Engine.physics_ticks_per_second):
		await get_tree().physics_frame
	var rows: Array[PackedStringArray] = [["asleep", "tile_steps", "blade_steps", "woken", "awake_at_end"]]
	for i in fields.size():
		var now := fields[i].get_statistics().merged(fields[i].get_counters())
		rows.append([MODES.keys()[i], str(now.tile_steps), str(now.simulated_blades), str(now.woken), str(now.awake_tiles)])
	get_viewport().disable_3d = false
	return rows


func _add_field(p_properties: Dictionary) -> GrassField:
	var field := GrassField.new()
	field.simulation_detail = GrassField.SIMULATION_WHOLE
	field.size = Vector2(SIDE, SIDE)
	for property: String in p_properties:
		field.set(property, p_properties[property])
	add_child(field)
	return field


func _add_ground() -> void:
	var ground := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = WorldBoundaryShape3D.new()
	ground.add_child(shape)
	add_child(ground)
