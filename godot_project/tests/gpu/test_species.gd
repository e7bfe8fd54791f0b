# SPDX-License-Identifier: MIT
## Species on the GPU: the picture shows each blade as the species that the simulation has for it.
extends "res://tests/species_case.gd"


## Short, wide, upright blades of three colours, far from each other and without clumps, from above.
func add_markers(properties := {}, own := {}) -> GrassField:
	var shape := {
		length_min = 0.06, length_max = 0.06, width_min = 0.2, width_max = 0.2, weight_drooping = 0.0, weight_wavy = 0.0, stand_size = 3.0
	}
	shape.merge(own, true)
	var field := add_seen_field(
		(
			{
				size = Vector2(16, 16),
				density = 1.0,
				species = [make(0.4, Color.RED, shape), make(0.3, Color.GREEN, shape), make(0.3, Color.BLUE, shape)],
				clump_tint = 0.0,
				clump_height = 0.0,
				clump_lean = 0.0,
				soil_enabled = false,
				root_shade = 0.0,
				pixels_min = 4.0,
				lod_far = 1000.0,
			}
			. merged(properties, true)
		)
	)
	camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	camera.size = 16.0
	look(Vector3(0, 5, 0), Vector3.ZERO)
	return field


func channel_of(color: Color) -> int:
	return 0 if color.r > maxf(color.g, color.b) else (1 if color.g > color.b else 2)


## Compares what every blade is drawn as with what it is simulated as; blades that another one may hide are left out.
func check_markers(field: GrassField) -> void:
	var image := await picture()
	var places: Array[Vector2] = []
	var species: Array[int] = []
	var tiles := field.get_grid_size()
	for z in tiles.y:
		for x in tiles.x:
			for blade in BLADES:
				var knots := field.get_knots(Vector2i(x, z), blade)
				var middle := (knots[0] + knots[8]) / 2.0
				places.append(camera.unproject_position(middle))
				species.append(field.get_blade_species(Vector2i(x, z), blade))
	var seen := [0, 0, 0]
	var wrong := 0
	for i in places.size():
		var at := places[i]
		if at.x < 2 or at.y < 2 or at.x > SIDE - 3 or at.y > SIDE - 3:
			continue
		var is_alone := true
		for j in places.size():
			is_alone = is_alone and (i == j or places[j].distance_squared_to(at) > 144.0)
		if is_alone:
			var color := image.get_pixelv(Vector2i(at))
			if Vector3(color.r - SKY.r, color.g - SKY.g, color.b - SKY.b).length() < 0.1:
				continue  # seen edge on, beside its middle
			if channel_of(color) == species[i]:
				seen[species[i]] += 1
			else:
				wrong += 1
	print("    drawn as simulated: %s blades of each species" % [seen])
	assert_eq(wrong, 0)
	for s in 3:
		assert_greater(seen[s], 20)


func test_each_blade_is_drawn_as_what_it_is_simulated_as() -> void:
	await check_markers(add_markers())


func test_blades_at_frayed_borders_are_drawn_as_what_they_are_simulated_as() -> void:
	await check_markers(add_markers({}, {stand_edge = 0.8}))


func test_painted_blades_are_drawn_as_what_they_are_simulated_as() -> void:
	var field := add_markers({map = full_map()})
	for number in [1, 2, 3]:
		var place := Vector3(-5 + 3.7 * number, 0, -2 + number)
		field.paint(brush(GrassBrush.TOOL_SPECIES, 3.0, {species = number}), place, place)
	await check_markers(field)


## Returns how much of a picture is blades, and the sum of the heights of all blades, metres; aslant from above.
func find_area(field: GrassField) -> Vector2:
	look(Vector3(0, 5, 5), Vector3.ZERO)
	var image := await picture()
	var found := Vector2.ZERO
	for y in SIDE:
		for x in SIDE:
			var color := image.get_pixel(x, y)
			found.x += float(Vector3(color.r - SKY.r, color.g - SKY.g, color.b - SKY.b).length() > 0.1)
	var tiles := field.get_grid_size()
	for z in tiles.y:
		for x in tiles.x:
			for blade in BLADES:
				var knots := field.get_knots(Vector2i(x, z), blade)
				found.y += knots[-1].y - knots[0].y
	return found


func test_blades_at_the_border_of_stands_are_drawn_as_low_as_they_are_simulated() -> void:
	var long := {length_min = 0.9, length_max = 0.9, width_min = 0.05, width_max = 0.05, stand_strength = 1.0}
	var field := add_markers({}, long)
	var sharp := await find_area(field)
	for species: GrassSpecies in field.species:
		species.stand_edge = 0.9
	await grown(field)
	var soft := await find_area(field)
	print("    soft against sharp: %.3f of the area, %.3f of the heights" % [soft.x / sharp.x, soft.y / sharp.y])
	assert_less(soft.y, 0.85 * sharp.y, "blades are lower")
	assert_near(soft.x / sharp.x, soft.y / sharp.y, 0.05, "and drawn so")


func test_an_awake_tile_of_species_is_drawn_as_it_was_asleep() -> void:
	var long := {length_min = 0.7, length_max = 0.9}
	var species := [make(0.6, Color(0.3, 0.6, 0.2)), make(0.4, Color(0.7, 0.2, 0.2), long)]
	await assert_waking_is_not_seen(add_seen_field({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 5.0, species = species}))


## For people: a meadow of four species, one with flowers, on which a path of one was painted, on both backends.
func test_a_meadow_of_four_species_looks_alike_on_both_backends() -> void:
	viewport.size = Vector2i(960, 540)
	var fescue := make(0.75, Color.WHITE, {root_color = Color(0.15, 0.25, 0.08), tip_color = Color(0.48, 0.6, 0.22), dry = 0.25})
	var sorrel := make(
		0.15,
		Color.WHITE,
		{
			length_min = 0.7,
			length_max = 0.95,
			width_min = 0.006,
			width_max = 0.01,
			weight_drooping = 0.0,
			weight_wavy = 0.0,
			stand_size = 2.5,
			stand_strength = 0.8,
			natural_frequency = 2.0
		}
	)
	sorrel.gradient = Gradient.new()
	sorrel.gradient.offsets = PackedFloat32Array([0.0, 0.6, 0.75, 1.0])
	sorrel.gradient.colors = PackedColorArray([Color(0.2, 0.3, 0.1), Color(0.4, 0.45, 0.2), Color(0.55, 0.2, 0.12), Color(0.6, 0.25, 0.2)])
	var sedge := make(
		0.1,
		Color.WHITE,
		{
			root_color = Color(0.08, 0.2, 0.14),
			tip_color = Color(0.3, 0.5, 0.42),
			length_min = 0.35,
			length_max = 0.55,
			width_min = 0.015,
			width_max = 0.03,
			stand_size = 4.0,
			stand_strength = 0.9
		}
	)
	var daisy := make(
		0.06,
		Color.WHITE,
		{
			root_color = Color(0.15, 0.25, 0.08),
			tip_color = Color(0.4, 0.5, 0.2),
			length_min = 0.5,
			length_max = 0.65,
			width_max = 0.006,
			width_min = 0.004,
			weight_drooping = 0.0,
			weight_wavy = 0.0,
			stand_size = 1.5,
			stand_strength = 0.5,
			card_width = 0.045,
			card_height = 0.045
		}
	)
	daisy.card = daisy_card()
	var field := add_seen_field({size = Vector2(20, 20), map = full_map(), species = [fescue, sorrel, sedge, daisy]})
	field.paint(brush(GrassBrush.TOOL_SPECIES, 1.0, {species = 3}), Vector3(-8, 0, 2), Vector3(8, 0, -5))
	look(Vector3(0, 2.2, 9), Vector3(0, 0, 0))
	var gpu := await picture()
	assert_greater(share_of(gpu, is_green), 0.3, "grass")
	save(gpu, "species")
	field.backend = GrassField.BACKEND_CPU
	var off := difference(gpu, await picture())
	print("    GPU against CPU backend: mean difference %.5f" % off.y)
	assert_less(off.y, 0.003)
