# SPDX-License-Identifier: MIT
## The GPU's simulation of several species against the CPU's.
extends "res://tests/parity_case.gd"


func mixed() -> Array[GrassSpecies]:
	var soft := GrassSpecies.new()
	soft.patch = GrassPatch.new()
	soft.patch.length_max = 0.4
	soft.natural_frequency = 0.8
	var stiff := GrassSpecies.new()
	stiff.patch = GrassPatch.new()
	stiff.patch.length_max = 0.8
	stiff.natural_frequency = 3.0
	stiff.damping_ratio = 0.2
	return [soft, stiff]


func test_species_are_simulated_alike() -> void:
	for method: GrassField.SolverMethod in [GrassField.METHOD_DIRECT, GrassField.METHOD_PBD]:
		if not await add_pair({species = mixed(), method = method, sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 30.0}):
			return
		var tile := cpu.get_tile_at(PLACE)
		var rest := tile_knots(cpu, tile)
		await assert_same_rest(tile)
		var body := add_held_body(ball(0.2), Vector3(0.25, 0.9, 0.25))
		while farthest(tile_knots(cpu, tile), rest) < 0.01:
			body.position.y -= 0.02
			await ticks(1)
			if not assert_greater(body.position.y, -1.0):
				return
		body.free()
		var most := 0.0
		for i in 8:
			most = maxf(most, farthest(tile_knots(gpu, tile), tile_knots(cpu, tile)))
			await ticks(5)
		print("    %s: %s m apart in 40 steps" % ["direct" if method == GrassField.METHOD_DIRECT else "PBD", String.num_scientific(most)])
		assert_less(most, 1e-3)
		gpu.free()
		cpu.free()
