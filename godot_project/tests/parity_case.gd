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
		for blade in BLADES:
			most = maxf(most, blade_difference(tile, blade))
	return most


func blade_difference(tile: Vector2i, blade: int) -> float:
	var a := gpu.get_knots(tile, blade)
	return farthest(a, cpu.get_knots(tile, blade)) / (15 * a[0].distance_to(a[1]))
