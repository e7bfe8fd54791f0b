# SPDX-License-Identifier: MIT
## A test of the GPU's simulation against the CPU's: two fields of one seed on one spot, pushed by the same bodies.
extends "res://tests/field_case.gd"

const PLACE := Vector3(0.25, 0.25, 0.25)
const AT_REST := 1e-5  # of a blade's length, in tiles that are awake and that nothing touches

var cpu: GrassField
var gpu: GrassField


func add_pair(properties := {}) -> bool:
	var whole := properties.merged({simulation_detail = GrassField.SIMULATION_WHOLE})
	gpu = add_field(whole)
	cpu = add_field(whole)
	cpu.backend = GrassField.BACKEND_CPU
	await ticks(2)
	await compiled(gpu)
	return assert_eq(gpu.get_statistics().backend, "GPU") and assert_eq(cpu.get_statistics().backend, "CPU")


## The greatest distance of a knot on the GPU from the CPU's, as a share of its blade's length. INF if a tile is asleep: then both fields
## read its blades from the same place.
func difference(tiles: Array[Vector2i]) -> float:
	var most := 0.0 if tiles else INF
	for tile in tiles:
		if not (gpu.is_tile_awake(tile) and cpu.is_tile_awake(tile)):
			return INF
		for off in blade_differences(tile):
			most = maxf(most, off)
	return most


## Returns the same of each blade of a tile, of the GPU's field or another one.
func blade_differences(tile: Vector2i, field := gpu) -> PackedFloat64Array:
	var others := tile_knots(field, tile)
	var by_cpu := tile_knots(cpu, tile)
	var off := PackedFloat64Array()
	for blade in BLADES:
		var knots := blade_of(others, blade)
		off.append(farthest(knots, blade_of(by_cpu, blade)) * CLAMP_SHARE / knots[0].distance_to(knots[1]))
	return off


## The share of the tiles' blades that are farther apart than `limit` of their length. For blades that a body has just squashed: the way in
## which one buckles may depend on its last bits, which differ between cards.
func share_apart(tiles: Array[Vector2i], limit: float) -> float:
	var apart := 0
	for tile in tiles:
		for off in blade_differences(tile):
			apart += int(off > limit)
	return float(apart) / (tiles.size() * BLADES)


## Compares both fields' blades in `tile` at rest, simulated: a ball above them wakes it.
func assert_same_rest(tile: Vector2i) -> void:
	var rest := tile_knots(cpu, tile)
	var above := add_ball_above(cpu, tile)
	await seen()
	var off := difference([tile])
	print("    parity at rest: %s of a blade's length" % String.num_scientific(off))
	assert_less(off, AT_REST, "at rest")
	assert_less(farthest(tile_knots(cpu, tile), rest), 1e-3, "metres: the ball touches no blade")
	above.free()
