# SPDX-License-Identifier: MIT
## The driver refuses a pass that only the first edge, crowd, plant or species, or another method, needs, while other fields are drawn. The
## tests run in order, since a process compiles a pass only once.
extends "res://tests/drivers/refused_case.gd"

const DAISY := "res://addons/grass_field/presets/ox_eye_daisy.tres"  # with a mesh


func test_1_the_pass_for_all_tiles_stands_in() -> void:
	refuse("simulate_GRASS_FREE,simulate_GRASS_EDGES,simulate_GRASS_EDGES+crowd")
	expect_refusal(["simulate free", "simulate edges", "simulate crowds"])
	# Whole tiles: the same code for several tiles in a workgroup is compiled with the first thinned one, and would be refused, too.
	var field := add_seen_field({soil_enabled = false, simulation_detail = GrassField.SIMULATION_WHOLE})
	await compiled(field)
	var box := AnimatableBody3D.new()
	box.sync_to_physics = false
	var shape := BoxShape3D.new()
	shape.size = Vector3(0.5, 0.1, 0.3)
	add_shape(box, shape)
	box.position = Vector3(1, 0.2, 0)
	viewport.add_child(box)
	for i in 40:  # more than a workgroup shares
		var body := AnimatableBody3D.new()
		body.sync_to_physics = false
		add_shape(body, ball(0.02))
		body.position = Vector3(-1.2 + 0.01 * i, 0.1, -1.2)
		viewport.add_child(body)
	await ticks(20)
	await assert_lives(field, "GPU")
	var now := field.get_counters()
	assert_eq(now.free_tile_steps + now.edge_tile_steps + now.crowd_tile_steps, 0)
	assert_eq(said.warnings, 0, "it lacks nothing")
	assert_eq(said.count, 3)


func test_2_plants_are_the_cpu_s() -> void:
	refuse("plants,plants_GRASS_MAP")
	expect_refusal(["plants", "plants map"])
	var other := add_seen_field({soil_enabled = false, position = Vector3(0, 0, -4)})
	var field := add_seen_field({soil_enabled = false})
	await assert_lives(field, "GPU")
	var species: Array[GrassSpecies] = [load(DAISY)]
	field.species = species
	await wait_until(func() -> bool: return field.get_statistics().backend == "CPU", "the CPU has it")
	await drawn()
	assert_greater(field.get_counters().drawn_plants, 0)
	assert_eq(said.warnings, 1)
	field.free()
	field = add_seen_field({soil_enabled = false, map = half_map(), species = species})
	await wait_until(func() -> bool: return field.get_statistics().backend == "CPU", "the CPU has it")
	await drawn()
	assert_greater(field.get_counters().drawn_plants, 0)
	assert_eq(said.warnings, 2)
	assert_eq(other.get_statistics().backend, "GPU", "a field without plants")
	assert_eq(said.count, 2)


func test_3_species_are_the_cpu_s() -> void:
	refuse("simulate_GRASS_SPECIES")
	expect_refusal(["simulate"])
	var species: Array[GrassSpecies] = [GrassSpecies.new(), GrassSpecies.new()]
	var field := add_seen_field({soil_enabled = false, species = species, method = GrassField.METHOD_PBD})
	await assert_lives(field, "CPU")
	assert_eq(said.warnings, 1)
	assert_eq(said.count, 1)


func test_4_nothing_of_the_map_is_lost() -> void:
	expect_refusal(["simulate"])
	var field := add_seen_field({soil_enabled = false, map = half_map()})
	await assert_lives(field, "GPU")
	refuse("simulate")
	field.map.stroke(brush(GrassBrush.TOOL_CUT, 0.4, {cut_height = 0.05}), Vector2(1, -2), Vector2(1, 2))
	await grown(field)
	await ticks_to_sleep(field)
	await drawn()
	var before := await picture()
	field.method = GrassField.METHOD_PBD
	await wait_until(func() -> bool: return field.get_statistics().backend == "CPU", "the CPU has it")
	await grown(field)
	await drawn()
	var after := await picture()
	var off := difference(before, after)
	print("    %.3f and %.3f of grass, the pictures differ by %s" % [grass_of(before), grass_of(after), off])
	assert_less(off.y, 0.01)
	assert_eq(said.count, 1)
