# SPDX-License-Identifier: MIT
## Counts how many awake tiles move, in the scene of the paper's table 2: 128 thrown bodies among 4 million blades. Tiles are sorted by the
## greatest distance of some blades from rest, and by the greatest way of one of them in a tick. Counts, not times.
extends Node3D

const Scenery := preload("res://bench/scenery.gd")

const SIDE := 128.0  # metres
const BODIES := 128
const SECONDS: Array[int] = [2, 5, 8]  # after the throw
const EVERY := 3  # of a tile's blades one in so many is looked at
const FAR: Array[float] = [1e-6, 1e-3, 1e-2, 5e-2]  # metres
const MODES: Dictionary[String, GrassField.SleepMode] = {"by energy": GrassField.SLEEP_ENERGY, "by timer": GrassField.SLEEP_TIMER}


func run(_p_software: bool) -> Array[PackedStringArray]:
	get_viewport().disable_3d = true
	Scenery.add_ground(self)
	var still := _add_field(GrassField.SLEEP_ENERGY, false)
	var rows: Array[PackedStringArray] = [["asleep", "seconds", "awake", "simulated"]]
	for far in FAR:
		rows[0].append_array(["off_%s_m" % far, "moved_%s_m" % far])
	for mode in MODES:
		var field := _add_field(MODES[mode], true)
		await Scenery.compiled(field)
		var bodies := Scenery.throw(self, BODIES, SIDE, 7)
		var tick := 0
		for seconds in SECONDS:
			while tick < seconds * Engine.physics_ticks_per_second:
				await get_tree().physics_frame
				tick += 1
			rows.append(await _count(field, still, [mode, str(seconds)]))
			print(", ".join(rows[-1]))
			tick += 1
		field.queue_free()
		for body in bodies:
			body.queue_free()
		await get_tree().process_frame
	get_viewport().disable_3d = false
	return rows


func _add_field(p_mode: GrassField.SleepMode, p_simulated: bool) -> GrassField:
	var field := GrassField.new()
	field.simulation_detail = GrassField.SIMULATION_WHOLE
	field.size = Vector2(SIDE, SIDE)
	field.sleep_mode = p_mode
	field.simulated = p_simulated
	field.backend = GrassField.BACKEND_CPU
	add_child(field)
	return field


## Returns the tiles in a tick that are farther from rest, or moved farther, than each of FAR.
func _count(p_field: GrassField, p_still: GrassField, p_row: PackedStringArray) -> PackedStringArray:
	var tiles: Array[Vector2i] = []
	for z in p_field.get_grid_size().y:
		for x in p_field.get_grid_size().x:
			if p_field.is_tile_awake(Vector2i(x, z)):
				tiles.append(Vector2i(x, z))
	var before: Array[PackedVector3Array] = []
	for tile in tiles:
		before.append(p_field.get_tile_knots(tile))
	var steps: Dictionary = p_field.get_counters()
	await get_tree().physics_frame
	var now := p_field.get_counters()
	var simulated: int = now.tile_steps - steps.tile_steps
	var off := PackedInt32Array([0, 0, 0, 0])
	var moved := PackedInt32Array([0, 0, 0, 0])
	for i in tiles.size():
		var knots := p_field.get_tile_knots(tiles[i])
		var farthest := _farthest(knots, p_still.get_tile_knots(tiles[i]))
		var way := _farthest(knots, before[i])
		for n in FAR.size():
			off[n] += int(farthest > FAR[n])
			moved[n] += int(way > FAR[n])
	p_row.append_array([str(tiles.size()), str(simulated)])
	for n in FAR.size():
		p_row.append_array([str(off[n]), str(moved[n])])
	return p_row


func _farthest(p_knots: PackedVector3Array, p_others: PackedVector3Array) -> float:
	const KNOTS := 16
	var most := 0.0
	for blade in range(0, 64, EVERY):
		for knot in range(KNOTS * blade + 2, KNOTS * (blade + 1)):
			most = maxf(most, p_knots[knot].distance_to(p_others[knot]))
	return most
