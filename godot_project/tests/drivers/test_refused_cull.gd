# SPDX-License-Identifier: MIT
## The driver refuses, from the start, the pass that chooses what is drawn.
extends "res://tests/drivers/refused_case.gd"


func test_no_field_is_bare() -> void:
	expect_refusal(["cull"])
	var field := add_seen_field({soil_enabled = false, map = half_map()})
	await assert_lives(field, "CPU")
	assert_eq(said.warnings, 1)
	var half := grass_of(await picture())
	field.map = full_map()
	await drawn()
	assert_greater(grass_of(await picture()), 1.5 * half, "the map's left half was bare")
	field.free()
	var species: Array[GrassSpecies] = [GrassSpecies.new(), GrassSpecies.new()]
	field = add_seen_field({soil_enabled = false, species = species})
	await assert_lives(field, "CPU")
	assert_eq(said.count, 1, "however many fields there are")
	assert_eq(said.warnings, 1)
	var asked := asked_passes()
	assert_greater(asked.size(), 0)
	assert_eq(asked.count("cull"), asked.size(), "no field uses another pass: %s" % asked)


func test_a_field_of_the_cpu_s_warns_of_nothing() -> void:
	var field := add_seen_field({soil_enabled = false, backend = GrassField.BACKEND_CPU})
	await assert_lives(field, "CPU")
	field.backend = GrassField.BACKEND_AUTO
	await assert_lives(field, "CPU")
	assert_eq(said.count + said.warnings, 0, "all is said")
