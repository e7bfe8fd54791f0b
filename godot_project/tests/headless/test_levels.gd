# SPDX-License-Identifier: MIT
## Fields above one another, and on walls and ceilings.
extends "res://tests/field_case.gd"

const LedgeScene := preload("res://tests/ledge_scene.gd")
const DECK := 4.0  # metres: the top of the bridge
const ON_DECK := Vector3(0.25, DECK, 0.25)
const BELOW := Vector3(0.25, 0, 0.25)

var meadow: GrassField
var bridge: GrassField


## A bridge over a meadow, each with its field at the same place, from one stack of bodies.
func add_levels(has_bands := true) -> void:
	LedgeScene.add_box(self, Vector3(0, -0.5, 0), Vector3(40, 1, 40))
	LedgeScene.add_box(self, Vector3(0, DECK - 0.1, 0), Vector3(40, 0.2, 12))
	await ticks(2)
	meadow = add_field({size = Vector2(12, 12), map = full_map()})
	bridge = add_field({name = "Bridge", size = Vector2(12, 12), position = Vector3(0, DECK, 0), map = full_map()})
	if has_bands:
		meadow.ground_low = -1.0
		meadow.ground_high = 3.0
		bridge.ground_low = -0.5
		bridge.ground_high = 2.0
	await grown(meadow)
	await grown(bridge)


func ground(of: GrassField) -> float:
	return of.map.sample(GrassMap.CHANNEL_GROUND, Vector2(0.5, 0.5))


func test_each_field_finds_its_ground_in_its_band() -> void:
	await add_levels(false)
	assert_greater(meadow.bake_ground(), 100)
	assert_near(ground(meadow), DECK, 0.02, "without a band the meadow climbs onto the bridge")
	meadow.ground_low = -1.0
	meadow.ground_high = 3.0
	bridge.ground_low = -0.5
	bridge.ground_high = 2.0
	assert_greater(meadow.bake_ground(), 100)
	assert_greater(bridge.bake_ground(), 100)
	assert_near(ground(meadow), 0.0, 0.02, "below the bridge")
	assert_near(ground(bridge), 0.0, 0.02, "on the bridge")
	await grown(bridge)
	bridge.position.y = 10.0
	assert_eq(bridge.bake_ground(), 0, "the bridge is not in its band any more, nor is what is below")
	meadow.ground_high = 8.0
	meadow.ground_low = 5.0
	assert_eq(meadow.bake_ground(), 0, "nothing is between 5 and 8 m")


func test_bodies_press_the_field_that_they_stand_in() -> void:
	await add_levels()
	meadow.bake_ground()
	bridge.bake_ground()
	await grown(meadow)
	await grown(bridge)
	var body := add_held_body(ball(0.3), ON_DECK + Vector3(0, 0.3, 0))
	await ticks(10)
	assert_greater(bridge.get_awake_tile_count(), 0)
	assert_eq(meadow.get_awake_tile_count(), 0, "nothing moves below the bridge")
	assert_greater(bridge.get_bend_at(ON_DECK).length(), 0.0)
	body.position = BELOW + Vector3(0, 0.3, 0)
	await ticks_to_sleep(bridge)
	await ticks(10)
	assert_greater(meadow.get_awake_tile_count(), 0)
	assert_eq(bridge.get_awake_tile_count(), 0, "nor on it")
	assert_greater(meadow.get_bend_at(BELOW).length(), 0.0)


func test_places_belong_to_one_level() -> void:
	await add_levels()
	for level: Array in [[meadow, BELOW, ON_DECK], [bridge, ON_DECK, BELOW]]:
		var field: GrassField = level[0]
		assert_eq(field.get_density_at(level[1]), 1.0, field.name)
		assert_greater(field.get_height_at(level[1]), 0.1, field.name)
		assert_eq(field.get_density_at(level[2]), 0.0, "the other level is not %s's" % field.name)
		assert_eq(field.get_height_at(level[2]), 0.0, field.name)
		assert_false(field.is_grass_at(level[2]), field.name)


func test_work_on_one_level_leaves_the_other() -> void:
	await add_levels()
	var hedge := box(Vector3(2, 0.2, 2))
	for field: GrassField in [meadow, bridge]:
		var other := BELOW if field == bridge else ON_DECK
		var own := ON_DECK if field == bridge else BELOW
		var before := field.map.data
		assert_eq(field.cut(hedge, Transform3D(Basis(), other + Vector3(0, 0.2, 0))).area, 0.0, field.name)
		assert_eq(field.trample(other, 1.0, 1.0), 0.0, field.name)
		assert_eq(field.paint(brush(GrassBrush.TOOL_ERASE, 1.0), other, other), 0.0, field.name)
		assert_eq(field.get_mown_share(hedge, Transform3D(Basis(), other)), 0.0, field.name)
		assert_eq(field.map.data, before, "%s does not change" % field.name)
		assert_greater(field.cut(hedge, Transform3D(Basis(), own + Vector3(0, 0.2, 0))).area, 0.0, field.name)
		assert_greater(field.trample(own, 1.0, 1.0), 0.0, field.name)
		assert_ne(field.paint(brush(GrassBrush.TOOL_ERASE, 1.0), own, own), 0.0, field.name)


func test_explain_names_the_level() -> void:
	await add_levels()
	assert_eq(meadow.explain(BELOW).reason, GrassField.REASON_NONE)
	assert_eq(bridge.explain(ON_DECK).reason, GrassField.REASON_NONE)
	var answer := meadow.explain(ON_DECK)
	assert_eq(answer.reason, GrassField.REASON_LEVEL)
	assert_eq(answer.node, bridge)
	for words: String in ["'Bridge'", "4.0 m above", "`ground_high`"]:
		assert_true(answer.text.contains(words), "'%s' in '%s'" % [words, answer.text])
	assert_eq(answer.density, 0.0)
	answer = bridge.explain(BELOW)
	assert_eq(answer.node, meadow)
	assert_true(answer.text.contains("'Meadow'") and answer.text.contains("4.0 m below"), answer.text)
	answer = meadow.explain(Vector3(0, 50, 0))
	assert_eq(answer.reason, GrassField.REASON_LEVEL)
	assert_eq(answer.node, null)
	assert_true(answer.text.contains("No other field"), answer.text)


## Of several fields that have their ground at a place the one with the nearest ground is named, whichever was added first.
func test_explain_names_the_nearest_level() -> void:
	await add_levels()
	for nearer: float in [DECK + 0.2, DECK - 0.3]:
		var field := add_field(
			{name = "Planter", size = Vector2(2, 2), position = Vector3(0, nearer, 0), ground_low = -2.0, ground_high = 2.0}
		)
		await grown(field)
		var place := Vector3(0.25, nearer, 0.25)
		assert_eq(meadow.explain(place).node, field)
		assert_eq(meadow.explain(ON_DECK).node, bridge)
		field.free()


func test_bands_that_are_none() -> void:
	meadow = add_field()
	await grown(meadow)
	assert_eq([meadow.ground_low, meadow.ground_high], [-1024.0, 1024.0])
	assert_eq(meadow.get_density_at(Vector3(0, 5000, 0)), 1.0, "without a band heights do not matter")
	expect_error("`ground_low` is not below `ground_high`, so no ground and no place belongs to the field")
	expect_error("bake_ground() finds nothing: `ground_low`")
	var none := add_field({ground_low = 2.0, ground_high = 1.0})
	await grown(none)
	assert_eq(none.bake_ground(), 0)
	assert_eq(none.get_density_at(Vector3.ZERO), 0.0)
	assert_eq(none.explain(Vector3.ZERO).reason, GrassField.REASON_LEVEL)


## Returns the mean direction from root to tip of a tile's blades, in the world's axes, as shares of their lengths.
func mean_reach(field: GrassField) -> Vector3:
	var knots := tile_knots(field, field.get_grid_size() / 2)
	var sum := Vector3.ZERO
	for blade in BLADES:
		sum += (knots[blade * KNOTS + KNOTS - 1] - knots[blade * KNOTS]) / length_of(knots, blade)
	return sum / BLADES


func add_turned(degrees: Vector3) -> GrassField:
	var field := add_field({rotation_degrees = degrees, clump_lean = 0.0, clump_height = 0.0})
	await grown(field)
	return field


func test_gravity_pulls_blades_down_on_walls_and_ceilings() -> void:
	var level := mean_reach(await add_turned(Vector3.ZERO))
	assert_greater(level.y, 0.6)
	for turn: Vector3 in [Vector3(90, 0, 0), Vector3(0, 60, -90), Vector3(-90, 200, 0)]:
		var wall := await add_turned(turn)
		var unhung := wall.global_basis * level
		var reach := mean_reach(wall)
		assert_less(absf(unhung.y), 0.1, "turned alone it would stand out of the wall")
		assert_less(reach.y, unhung.y - 0.15, "sags, turned by %s" % turn)
		assert_greater(reach.dot(wall.global_basis.y), 0.2, "and grows out of the wall")
	var ceiling := mean_reach(await add_turned(Vector3(180, 30, 0)))
	assert_less(ceiling.y, -level.y - 0.05, "hangs straighter than it stood")
	assert_near(mean_reach(await add_turned(Vector3(15, 0, 0))).length(), level.length(), 1e-4, "a deck that rolls keeps its shape")


func test_a_wall_sags_less_where_grass_is_stiffer() -> void:
	var soft := mean_reach(await add_turned(Vector3(90, 0, 0)))
	var wall := await add_turned(Vector3(90, 0, 0))
	var stiff := GrassSpecies.new()
	stiff.natural_frequency = 4.0
	wall.species = [stiff]
	await grown(wall)
	assert_greater(mean_reach(wall).y, soft.y + 0.1)
	stiff.natural_frequency = 1.2
	await grown(wall)
	assert_near(mean_reach(wall).y, soft.y, 0.01, "a species that changes hangs anew")


## The wind of a force is in the world's axes: what of it blows along the wall bends its blades as it bends those of level ground.
func test_forces_blow_along_the_worlds_axes() -> void:
	var level := 0.0
	for turn: Vector3 in [Vector3.ZERO, Vector3(0, 90, 0), Vector3(180, 0, 0), Vector3(90, 0, 0)]:
		var field := await add_turned(turn)
		for i in 30:
			field.push(Vector3.ZERO, Vector3(12, 0, 0), 8.0, 1.0)
			await ticks(1)
		var bend := field.get_bend_at(Vector3.ZERO)
		var along := bend - bend.dot(field.global_basis.y) * field.global_basis.y  # the face
		level = along.x if turn == Vector3.ZERO else level
		assert_greater(along.x, 0.3, "bends along the world's x, turned by %s" % turn)
		assert_near(along.x, level, 0.25 * level, "as far as on level ground, turned by %s" % turn)
		assert_less(along.slide(Vector3.RIGHT).length(), 0.3 * along.x, "and not aside, turned by %s" % turn)
		field.free()


func test_bodies_press_grass_on_a_wall() -> void:
	var wall := await add_turned(Vector3(90, 0, 0))
	var bent := await bend_with_ball(wall, Vector3(0, 0, 0.25))
	assert_greater(bent, 0.05)
