# SPDX-License-Identifier: MIT
## A field of several species: what may be set, which blade belongs to which species, and that all of them bend and rise.
extends "res://tests/field_case.gd"


func make(share: float, length := 0.5, properties := {}) -> GrassSpecies:
	var species := GrassSpecies.new()
	species.patch = GrassPatch.new()
	species.patch.length_min = length
	species.patch.length_max = length
	species.share = share
	for property: String in properties:
		species.set(property, properties[property])
	return species


## Returns how many blades of the field are which species.
func count(field: GrassField) -> PackedInt32Array:
	var found := PackedInt32Array()
	found.resize(8)
	var tiles := field.get_grid_size()
	for z in tiles.y:
		for x in tiles.x:
			for blade in BLADES:
				found[field.get_blade_species(Vector2i(x, z), blade)] += 1
	return found


func test_properties_are_kept_and_brought_within_limits() -> void:
	var species := GrassSpecies.new()
	var patch := GrassPatch.new()
	var gradient := Gradient.new()
	var values := {
		patch = patch,
		gradient = gradient,
		share = 0.3,
		stand_size = 2.5,
		stand_strength = 0.1,
		natural_frequency = 2.0,
		damping_ratio = 0.2,
		wear_recovery = 0.4,
		dry = 0.5,
		card = GradientTexture2D.new(),
		card_share = 0.2,
		card_width = 0.1,
		card_height = 0.2,
		root_color = Color.RED,
		tip_color = Color.GREEN,
		dry_color = Color.BLUE,
		card_color = Color.YELLOW,
		plant_mesh = BoxMesh.new(),
		plant_distance = 12.0,
		plant_scene = PackedScene.new(),
		plant_scene_distance = 20.0,
		stems = 4,
	}
	var changes: Array[int] = [0]
	species.changed.connect(func() -> void: changes[0] += 1)
	for property: String in values:
		species.set(property, values[property])
		assert_eq(species.get(property), values[property], property)
	assert_eq(changes[0], values.size())
	patch.length_max = 0.8
	gradient.set_color(0, Color.RED)
	assert_eq(changes[0], values.size() + 2, "what changes in a part changes in the species")
	expect_error("GrassSpecies: `share` cannot be")
	species.share = -1.0
	assert_eq(species.share, 0.0)
	species.share = NAN
	assert_eq(species.share, 0.5, "its default")
	expect_error("GrassSpecies: `stand_size` cannot be")
	species.stand_size = 1e9
	assert_eq(species.stand_size, 64.0)


func test_a_field_keeps_its_species_and_says_what_is_wrong_with_them() -> void:
	var field := add_field()
	assert_eq(field.species.size(), 0)
	var one := make(0.5)
	field.species = [one, null, one]
	assert_eq(field.species.size(), 3)
	assert_eq(field.species[0], one)
	assert_true(field.species[1] == null)
	field.species.append(make(0.1))
	assert_eq(field.species.size(), 3, "a copy")
	expect_error("'Meadow': `species` has an empty entry 1")
	await ticks(2)
	one.share = 0.25  # it is there twice
	var many: Array[GrassSpecies] = []
	for i in 10:
		many.append(make(0.1, 0.0 if i == 3 else 0.4))
	field.species = many
	expect_error("`species` has more than 8 entries")
	expect_error("Species 3 has no blades")
	await grown(field)
	assert_eq(field.get_blade_count(), 64 * 64)
	field.species = []
	await grown(field)
	assert_eq(field.get_blade_species(Vector2i.ZERO, 5), 0)


func test_a_field_hears_of_its_own_species_only() -> void:
	var field := add_field()
	var left := make(0.5)
	var kept := make(0.5)
	for list: Array in [[left, kept, left], [kept], [kept, kept]]:
		var species: Array[GrassSpecies] = []
		species.assign(list)
		field.species = species
		assert_eq(left.changed.get_connections().size(), 1 if left in list else 0)
		assert_eq(kept.changed.get_connections().size(), 1)
	field.species = []
	assert_eq(kept.changed.get_connections().size(), 0)


func test_each_species_has_its_share_and_its_blades() -> void:
	var field := add_field(
		{
			size = Vector2(16, 16),
			clump_height = 0.0,
			species = [make(0.7, 0.3, {stand_size = 1.0}), make(0.2, 0.6, {stand_size = 1.0}), make(0.1, 0.9, {stand_size = 0.5})]
		}
	)
	await ticks(2)
	var found := count(field)
	for s in 3:
		assert_near(float(found[s]) / field.get_blade_count(), [0.7, 0.2, 0.1][s], 0.03, "species %d" % s)
	var knots := tile_knots(field, Vector2i(3, 4))
	for blade in BLADES:
		var species := field.get_blade_species(Vector2i(3, 4), blade)
		assert_near(length_of(knots, blade), [0.3, 0.6, 0.9][species], 0.01)
	var before := found
	field.seed = 5
	await grown(field)
	assert_ne(count(field), before)
	field.seed = 0
	await grown(field)
	assert_eq(count(field), before)


func test_what_is_painted_grows_alone() -> void:
	var field := add_field({size = Vector2(8, 8), map = full_map(), species = [make(0.9, 0.3), make(0.1, 0.6), make(0.0, 0.9)]})
	await ticks(2)
	assert_eq(count(field)[2], 0)
	field.paint(brush(GrassBrush.TOOL_SPECIES, 2.0, {species = 3}), Vector3.ZERO, Vector3.ZERO)
	await ticks(2)
	var found := count(field)
	assert_near(float(found[2]) / field.get_blade_count(), PI * 4.0 / 64.0, 0.04)
	for blade in BLADES:
		assert_eq(field.get_blade_species(Vector2i(8, 8), blade), 2)
	assert_greater(field.get_height_at(Vector3.ZERO), 1.5 * field.get_height_at(Vector3(3.5, 0, 3.5)))


## Two species of the same blades, of which one is four times as fast: after the same push it is back far earlier.
func test_species_swing_by_their_own_numbers() -> void:
	var field := add_field(
		{
			sleep_mode = GrassField.SLEEP_TIMER,
			sleep_delay = 20.0,
			species =
			[
				make(0.5, 0.5, {stand_strength = 0.0, natural_frequency = 0.5, damping_ratio = 1.0}),
				make(0.5, 0.5, {stand_strength = 0.0, natural_frequency = 2.0, damping_ratio = 1.0})
			]
		}
	)
	await ticks(2)
	var tile := field.get_tile_at(Vector3(0.2, 0, 0.2))
	var rest := tile_knots(field, tile)
	var body := add_held_body(ball(0.3), Vector3(0.25, 0.2, 0.25))
	await ticks(20)
	body.free()
	await ticks(30)
	var knots := tile_knots(field, tile)
	var off := [0.0, 0.0]
	for blade in BLADES:
		var tip := blade * KNOTS + KNOTS - 1
		off[field.get_blade_species(tile, blade)] += knots[tip].distance_to(rest[tip])
	assert_greater(off[0], 0.5, "metres, of all tips together")
	assert_less(off[1], 0.2 * off[0])
	assert_greater(field.get_counters().simulated_blades, 0)
	var makings: int = field.get_counters().makings
	var species := field.species
	species[0].natural_frequency = 3.0
	species[1].tip_color = Color.RED
	await ticks(2)
	assert_eq(field.get_counters().makings, makings)
	assert_greater(field.get_awake_tile_count(), 0, "colours and frequencies disturb nothing")
	await ticks(60)
	assert_less(farthest(tile_knots(field, tile), rest), 0.02)
	species[1].patch.length_max = 0.9
	await grown(field)
	assert_eq(field.get_counters().makings, makings + 1)


## What leaves cover counts as width of blades, by which the level of detail thins them.
func test_a_leaf_that_covers_less_makes_the_field_again() -> void:
	var picture := Image.create_empty(8, 8, false, Image.FORMAT_RGBA8)
	picture.fill(Color.WHITE)
	var species := make(1.0, 0.4, {leaf = ImageTexture.create_from_image(picture)})
	var field := add_field({species = [species]})
	await grown(field)
	var makings: int = field.get_counters().makings
	picture.fill_rect(Rect2i(0, 0, 4, 8), Color.TRANSPARENT)
	species.leaf = ImageTexture.create_from_image(picture)
	await grown(field)
	assert_eq(field.get_counters().makings, makings + 1)


func test_grass_of_species_sleeps_again() -> void:
	var field := add_field({species = [make(0.5, 0.4, {natural_frequency = 3.0}), make(0.5, 0.7, {natural_frequency = 0.9})]})
	await ticks(2)
	var rest := tile_knots(field, Vector2i(4, 4))
	assert_greater(await bend_with_ball(field), 0.05)
	await ticks(400)
	assert_eq(field.get_awake_tile_count(), 0)
	assert_eq(farthest(tile_knots(field, Vector2i(4, 4)), rest), 0.0)


func test_wear_goes_at_the_rate_of_the_species_that_grows_there() -> void:
	var moss := make(1.0, 0.2, {wear_recovery = 12.0})  # 0.2/s
	var reed := make(0.0, 0.9)
	var map := full_map()
	var field := add_field({map = map, species = [moss, reed]})
	field.paint(brush(GrassBrush.TOOL_SPECIES, 2.0, {species = 2}), Vector3(2, 0, 0), Vector3(2, 0, 0))
	for x: float in [-1.25, 1.25]:
		field.trample(Vector3(x, 0, 0), 0.5, 1.0)
	await ticks(120)
	assert_near(map.sample(GrassMap.CHANNEL_WEAR, Vector2(-1.25, 0)), 0.6, 0.03)
	assert_eq(map.sample(GrassMap.CHANNEL_WEAR, Vector2(1.25, 0)), 1.0)
	reed.wear_recovery = 6.0
	moss.wear_recovery = 0.0
	await ticks(120)
	assert_near(map.sample(GrassMap.CHANNEL_WEAR, Vector2(-1.25, 0)), 0.6, 0.03)
	assert_near(map.sample(GrassMap.CHANNEL_WEAR, Vector2(1.25, 0)), 0.8, 0.03)


func test_meshes_that_cannot_be_drawn_are_reported() -> void:
	var high := PlaneMesh.new()
	high.subdivide_width = 200
	high.subdivide_depth = 100
	var low := BoxMesh.new()
	low.size = Vector3.ONE
	var sunk := SurfaceTool.new()
	sunk.append_from(low, 0, Transform3D(Basis(), Vector3(0, -2, 0)))
	var reasons := {ArrayMesh.new(): "it has no vertices", high: "it has 20604 vertices", sunk.commit(): "no part of it is above y = 0"}
	for mesh: Mesh in reasons:
		var broken := make(0.5, 0.5, {plant_mesh = mesh})
		expect_error("'Meadow': `plant_mesh` of species 1 is not drawn: " + reasons[mesh])
		var field := add_field({species = [make(1.0), broken]})
		await ticks(2)
		assert_greater(field.get_blade_count(), 0, "it grows as blades")
		broken.plant_mesh = low
		await grown(field)  # and warns no more
		field.free()


## Groups of stems of one species, each at one place, and no more of them than the share asks for.
func test_stems_of_a_plant_share_a_root() -> void:
	var field := add_field({species = [make(0.8), make(0.2, 0.5, {stems = 4, stand_strength = 0.0})], size = Vector2(8, 8)})
	await ticks(2)
	var shared := 0
	var plants := 0
	var tiles := field.get_grid_size()
	for z in tiles.y:
		for x in tiles.x:
			for first in range(0, BLADES, 4):
				var roots := {}
				var tips := {}
				for blade in range(first, first + 4):
					if field.get_blade_species(Vector2i(x, z), blade) == 1:
						var knots := field.get_knots(Vector2i(x, z), blade)
						roots[knots[0]] = true
						tips[knots[KNOTS - 1].snappedf(0.01)] = true
				if not roots.is_empty():
					plants += 1
					shared += int(roots.size() == 1 and tips.size() == 4)
	print("    %d of %d plants have four stems at one root" % [shared, plants])
	assert_eq(shared, plants)
	assert_near(4.0 * plants / field.get_blade_count(), 0.2, 0.03)
	var ball_there := add_held_body(ball(0.5), Vector3(0, 0.3, 0))
	await ticks(20)
	var tile := field.get_tile_at(Vector3(0.1, 0, 0.1))
	assert_true(field.is_tile_awake(tile))
	for first in range(0, BLADES, 4):
		if field.get_blade_species(tile, first) == 1:  # simulated stems keep their root
			var root := field.get_knots(tile, first)[0]
			assert_near(root.distance_to(field.get_knots(tile, first + 3)[0]), 0.0, 1e-6)
	ball_there.free()
