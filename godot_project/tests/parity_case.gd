# SPDX-License-Identifier: MIT
## A test of the GPU's simulation against the CPU's: two fields of one seed on one spot, pushed by the same bodies.
extends "res://tests/field_case.gd"

const PLACE := Vector3(0.25, 0.25, 0.25)

var cpu: GrassField
var gpu: GrassField


func add_pair(properties := {}) -> bool:
	gpu = add_field(properties)
	cpu = add_field(properties)
	cpu.backend = GrassField.BACKEND_CPU
	await ticks(2)
	await compiled(gpu)
	return assert_eq(gpu.get_statistics().backend, "GPU") and assert_eq(cpu.get_statistics().backend, "CPU")


## The farthest that a knot of the GPU lies from the CPU's, as a share of its blade's length, over all awake tiles.
func difference(tiles: Array[Vector2i]) -> float:
	var most := 0.0
	for tile in tiles:
		for off in blade_differences(tile):
			most = maxf(most, off)
	return most


## The same of each blade of a tile.
func blade_differences(tile: Vector2i) -> PackedFloat64Array:
	var by_gpu := tile_knots(gpu, tile)
	var by_cpu := tile_knots(cpu, tile)
	var off := PackedFloat64Array()
	for blade in BLADES:
		var knots := blade_of(by_gpu, blade)
		off.append(farthest(knots, blade_of(by_cpu, blade)) / (15 * knots[0].distance_to(knots[1])))
	return off


## Share of the tiles' blades that lie farther apart than `limit` of their length. For blades that a body has just squashed: which way
## one of them buckles may hang on its last bits, which differ between cards.
func share_apart(tiles: Array[Vector2i], limit: float) -> float:
	var apart := 0
	for tile in tiles:
		for off in blade_differences(tile):
			apart += int(off > limit)
	return float(apart) / (tiles.size() * BLADES)
