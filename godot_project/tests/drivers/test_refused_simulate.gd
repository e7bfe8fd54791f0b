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
