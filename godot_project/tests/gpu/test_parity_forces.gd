# SPDX-License-Identifier: MIT
## Forces on the GPU against forces on the CPU.
extends "res://tests/parity_case.gd"

const IN_WIND := 5e-3  # of a blade's length: it presses some blades onto the ground
const AFTER_FORCES := 2e-3  # of a blade's length
const FEW := 0.04  # share of the blades that stay pressed to another side than they buckled to
const MANY := 0.2  # share of the blades that a blast presses onto the ground, where they buckle by their last bits


func add_force(kind: GrassForce3D.Kind, speed: float, place: Vector3) -> GrassForce3D:
	var force := GrassForce3D.new()
	force.kind = kind
	force.speed = speed
	force.radius = 3.0
	force.position = place
	add_child(force)
	return force


func test_forces_move_both_alike() -> void:
	for method: GrassField.SolverMethod in [GrassField.METHOD_DIRECT, GrassField.METHOD_PBD]:
		if not await add_pair({method = method, sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 30.0}):
			return
		var tiles: Array[Vector2i] = [gpu.get_tile_at(PLACE), gpu.get_tile_at(Vector3(-0.9, 0, 0.6))]
		add_force(GrassForce3D.KIND_DOWNWASH, 12.0, Vector3(0.3, 1, -0.2))
		add_force(GrassForce3D.KIND_VORTEX, 9.0, Vector3(-1, 0.5, 1))
		var blast := add_force(GrassForce3D.KIND_BLAST, 30.0, Vector3(0.5, 0.2, 0.5))
		var most := 0.0
		for i in 6:
			await ticks(10)
			most = maxf(most, difference(tiles))
		assert_less(most, IN_WIND)
		blast.fire()
		await ticks(20)
		var share := share_apart(tiles, AFTER_FORCES)
		assert_less(share, MANY)
		await ticks(160)
		var left := difference(tiles)
		print(
			(
				"    parity of method %d: %s of a blade's length in the wind, %d %% apart in the blast, %s after it"
				% [method, String.num_scientific(most), 100 * share, String.num_scientific(left)]
			)
		)
		assert_less(share_apart(tiles, AFTER_FORCES), FEW)
		assert_eq(gpu.get_counters().forces, 2, "the blast is over")
		assert_greater(gpu.get_counters().free_tile_steps, 0, "a force is no collider")
		for child in get_children():
			child.free()


func test_species_take_forces_by_their_stiffness() -> void:
	var soft := GrassSpecies.new()
	soft.natural_frequency = 0.7
	var stiff := GrassSpecies.new()
	stiff.natural_frequency = 4.0
	if not await add_pair({species = [soft, stiff], sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 30.0}):
		return
	var tile := gpu.get_tile_at(PLACE)
	var rest := tile_knots(cpu, tile)
	var force := add_force(GrassForce3D.KIND_WIND, 8.0, PLACE)
	force.turbulence = 0.0
	await ticks(200)
	assert_less(difference([tile]), AFTER_FORCES)
	var knots := tile_knots(gpu, tile)
	var moved: Array[float] = [0.0, 0.0]
	var count: Array[int] = [0, 0]
	for blade in BLADES:
		var species := gpu.get_blade_species(tile, blade)
		moved[species] += farthest(blade_of(rest, blade), blade_of(knots, blade))
		count[species] += 1
	assert_greater(moved[0] / count[0], 2.0 * moved[1] / count[1])
