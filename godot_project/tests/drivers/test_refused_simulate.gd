# SPDX-License-Identifier: MIT
## The driver refuses, from the start, the pass that simulates plain fields.
extends "res://tests/drivers/refused_case.gd"


func test_only_fields_that_need_it_are_the_cpu_s() -> void:
	expect_refusal(["simulate"])
	var field := add_seen_field({soil_enabled = false})
	await assert_lives(field, "CPU")
	assert_eq(said.warnings, 1)
	field.free()
	var species: Array[GrassSpecies] = [GrassSpecies.new(), GrassSpecies.new()]
	field = add_seen_field({soil_enabled = false, species = species})
	await assert_lives(field, "GPU")
	assert_eq(said.warnings, 1, "of the other field")
	field.species = []
	await assert_lives(field, "CPU")
	assert_eq(said.count, 1)
	var asked := asked_passes()
	for pass_name in ["simulate_GRASS_FREE", "simulate_GRASS_EDGES", "strains"]:
		assert_false(asked.has(pass_name), "only fields without species use " + pass_name)
	for pass_name in ["simulate", "simulate_GRASS_SPECIES_FREE", "strains_GRASS_SPECIES"]:
		assert_true(asked.has(pass_name), "fields use " + pass_name)
