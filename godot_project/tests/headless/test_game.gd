# SPDX-License-Identifier: MIT
## Grass in a game: queries, cutting, trampling, regrowing; and that changes last.
extends "res://tests/field_case.gd"

const FILE := "user://lawn.grassmap"


func after() -> void:
	DirAccess.remove_absolute(FILE)


func at(place: Vector3) -> Transform3D:
	return Transform3D(Basis(), place)


func lengths(field: GrassField, tile: Vector2i) -> Array[float]:
	var all: Array[float] = []
	var knots := tile_knots(field, tile)
	for blade in BLADES:
		all.append(length_of(knots, blade))
	return all


func heights(field: GrassField, tile: Vector2i) -> float:
	var sum := 0.0
	for blade in BLADES:
		var top := 0.0
		for knot in field.get_knots(tile, blade):
			top = maxf(top, knot.y)
		sum += top
	return sum / BLADES


func test_questions_without_a_map() -> void:
	var field := add_field()
	assert_true(field.is_grass_at(Vector3(1, 5, 1)), "however high above")
	assert_eq(field.get_density_at(Vector3(1, 0, 1)), 1.0)
	assert_eq(field.get_bend_at(Vector3(1, 0, 1)), Vector3.ZERO)
	for outside: Vector3 in [Vector3(2.1, 0, 0), Vector3(0, 0, -1e9), Vector3(NAN, 0, 0), Vector3(INF, 0, 0)]:
		assert_false(field.is_grass_at(outside))
		assert_eq(field.get_density_at(outside), 0.0)
		assert_eq(field.get_height_at(outside), 0.0)
	field.clump_height = 0.0
	var tile := Vector2i(2, 5)
	assert_near(field.get_height_at(field.get_tile_center(tile)), heights(field, tile), 0.06, "metres")


func test_questions_follow_the_field() -> void:
	var field := add_field({map = full_map(), position = Vector3(100, 20, -50), rotation = Vector3(0, 1, 0)})
	field.paint(brush(GrassBrush.TOOL_ERASE, 0.8), field.to_global(Vector3(1, 0, 1)), field.to_global(Vector3(1, 0, 1)))
	assert_false(field.is_grass_at(field.to_global(Vector3(1, 0, 1))))
	assert_true(field.is_grass_at(field.to_global(Vector3(-1, 0, 1))))
	assert_eq(field.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(1, 1)), 0.0)


func test_bend_tells_how_far_and_which_way() -> void:
	var field := add_field({size = Vector2(8, 8), position = Vector3(3, 0, 0), rotation = Vector3(0, PI / 2, 0)})
	await ticks(2)
	var roller := CapsuleShape3D.new()
	roller.radius = 0.5
	roller.height = 3.0
	var body := add_held_body(roller, Vector3(3 - 2.0, 0.52, 0))
	body.rotation.x = PI / 2  # lies along z
	for i in 80:
		body.position.x += 0.025
		await ticks(1)
	var bend := field.get_bend_at(body.position - Vector3(0.1, 0, 0))
	print("    under a roller that moves along x: bent by %s of the blades' length" % bend)
	assert_greater(bend.x, 0.15, "pushed along")
	assert_less(absf(bend.z), 0.1)
	assert_less(bend.y, -0.15, "pressed down")
	assert_eq(field.get_bend_at(body.position + Vector3(-3.5, 0, 3)), Vector3.ZERO, "far away")
	body.free()
	await ticks(400)
	assert_eq(field.get_bend_at(Vector3(3, 0, 0)), Vector3.ZERO, "asleep")


func test_cut_says_how_much_and_shows() -> void:
	var field := add_field({map = full_map()})
	var fallen := field.cut(box(Vector3(2, 0.2, 2)), at(Vector3(0, 0.2, 0)))
	print("    a deck of 2 x 2 m at 10 cm: %s" % fallen)
	assert_near(fallen.area, 4.0, 0.001)
	assert_eq(fallen.blades, 1024)
	assert_greater(fallen.volume, 0.4)
	assert_less(fallen.volume, 2.0)
	await ticks(2)
	for length in lengths(field, field.get_tile_at(Vector3(0.1, 0, 0.1))):
		assert_less(length, 0.11)
	assert_near(field.get_height_at(Vector3(0, 0, 0)), 0.1, 0.02)
	assert_greater(field.get_height_at(Vector3(0, 0, 1.5)), 0.2)
	assert_eq(field.cut(box(Vector3(2, 0.2, 2)), at(Vector3(0, 0.2, 0))).blades, 0, "nothing left to cut")
	assert_eq(field.cut(ball(0.5), at(Vector3(0, 3, 1.5))).area, 0.0, "above the grass")


func test_a_field_without_a_map_gets_one() -> void:
	var field := add_field()
	assert_eq(field.cut(ball(0.5), at(Vector3(0, 0.5, 0))).area, 1.0)
	assert_true(field.map != null)
	assert_eq(field.get_density_at(Vector3(-1.5, 0, -1.5)), 1.0)
	await ticks(2)
	assert_eq(field.get_counters().bare_tiles, 0)


func test_what_is_asked_badly_is_told() -> void:
	var field := add_field({map = full_map()})
	await ticks(1)
	expect_error("cut() needs a shape")
	assert_eq(field.cut(null, Transform3D()).area, 0.0)
	expect_error("solid shape")
	field.cut(WorldBoundaryShape3D.new(), Transform3D())
	expect_error("needs a finite transform")
	field.cut(ball(1), at(Vector3(NAN, 0, 0)))
	expect_error("regrow()")
	field.regrow(-1.0)
	expect_error("trample()")
	field.trample(Vector3.ZERO, 0.0, 1.0)
	expect_error(": register_collider() needs a node")
	field.register_collider(null, ball(1))
	expect_error("bends no grass")
	field.register_collider(self, WorldBoundaryShape3D.new())
	expect_error("the ConvexPolygonShape3D registered for '%s' encloses no volume" % name)
	field.register_collider(self, ConvexPolygonShape3D.new())
	expect_error("unregister_collider() needs")
	field.unregister_collider(null)
	expect_error("GrassBrush")
	field.paint(null, Vector3.ZERO, Vector3.ZERO)
	expect_error("before asking")
	var outside := GrassField.new()
	outside.get_density_at(Vector3.ZERO)
	outside.free()
	assert_true(field.map.is_empty())


func test_mown_share_of_a_region_and_of_all() -> void:
	var field := add_field({map = full_map()})
	assert_eq(field.get_mown_share(), 0.0)
	field.cut(box(Vector3(2, 0.2, 4)), at(Vector3(-1, 0.2, 0)))
	assert_near(field.get_mown_share(), 0.5, 0.001)
	assert_eq(field.get_mown_share(box(Vector3(1.9, 1, 1.9)), at(Vector3(-1, 0, 0))), 1.0)
	assert_eq(field.get_mown_share(box(Vector3(1.9, 1, 1.9)), at(Vector3(1, 0, 0))), 0.0)
	field.paint(brush(GrassBrush.TOOL_ERASE, 1.0), Vector3(1, 0, -3), Vector3(1, 0, 3))
	assert_near(field.get_mown_share(), 1.0, 0.001, "bare ground does not count")


func test_cut_grass_grows_again() -> void:
	var field := add_field({map = full_map()})
	var before := field.get_height_at(Vector3.ZERO)
	field.cut(box(Vector3(4, 0.2, 4)), at(Vector3(0, 0.15, 0)))
	assert_near(field.get_height_at(Vector3.ZERO), 0.05, 0.001)
	field.regrow(0.1, 0.0, box(Vector3(2, 1, 4)), at(Vector3(-1, 0, 0)))
	assert_near(field.get_height_at(Vector3(-1, 0, 0)), 0.15, 0.001)
	assert_near(field.get_height_at(Vector3(1, 0, 0)), 0.05, 0.001)
	field.regrow(2.0)
	assert_near(field.get_height_at(Vector3.ZERO), before, 0.001)
	assert_eq(field.get_mown_share(), 0.0)


func test_time_heals_at_its_rates() -> void:
	var field := add_field({map = full_map(), regrowth = 3000.0, species = kind({wear_recovery = 6.0})})  # 50 mm/s and 0.1/s
	field.cut(box(Vector3(4, 0.2, 4)), at(Vector3(0, 0.15, 0)))
	field.trample(Vector3.ZERO, 1.0, 1.0)
	await ticks(60)
	assert_near(field.map.sample(GrassMap.CHANNEL_CUT, Vector2.ZERO), 0.1, 0.015)
	assert_near(field.map.sample(GrassMap.CHANNEL_WEAR, Vector2.ZERO), 0.9, 0.02)
	field.regrowth = 0.0
	field.species[0].wear_recovery = 0.0
	var cut := field.map.sample(GrassMap.CHANNEL_CUT, Vector2.ZERO)
	await ticks(30)
	assert_eq(field.map.sample(GrassMap.CHANNEL_CUT, Vector2.ZERO), cut)


func test_trampling_wears_the_grass_down_to_the_ground() -> void:
	var field := add_field({map = full_map()})
	var before := field.get_height_at(Vector3.ZERO)
	var wear := field.trample(Vector3.ZERO, 0.6, 0.3)
	assert_greater(wear, 0.1)
	var worn := field.get_height_at(Vector3.ZERO)
	assert_less(worn, before)
	assert_greater(worn, 0.0)
	for i in 40:
		field.trample(Vector3.ZERO, 0.6, 0.3)
	assert_less(field.get_density_at(Vector3.ZERO), 0.05)
	assert_eq(field.get_density_at(Vector3(1.5, 0, 1.5)), 1.0)
	assert_greater(field.trample(Vector3(1.6, 0, 1.6), 0.01, 0.5), 0.0, "a small heel, too")


func test_what_was_done_lasts_through_sleep_scenes_and_files() -> void:
	var field := add_field({map = full_map(), sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 0.1, settle_time = 0.1})
	field.cut(box(Vector3(2, 0.2, 2)), at(Vector3(0, 0.2, 0)))
	field.trample(Vector3(1.5, 0, 1.5), 0.5, 0.5)
	var cut := field.get_height_at(Vector3.ZERO)
	var worn := field.get_density_at(Vector3(1.5, 0, 1.5))
	assert_less(worn, 1.0)
	await bend_with_ball(field, Vector3(0.25, 0.1, 0.25))
	await ticks(60)
	assert_eq(field.get_awake_tile_count(), 0)
	assert_eq(field.get_height_at(Vector3.ZERO), cut, "through sleep")
	remove_child(field)
	add_child(field)
	assert_eq(field.get_height_at(Vector3.ZERO), cut, "out of the tree and back")
	var packed := PackedScene.new()
	field.owner = null
	packed.pack(field)
	assert_eq(ResourceSaver.save(field.map, FILE), OK)
	field.free()
	var again: GrassField = packed.instantiate()
	add_child(again)
	assert_eq(again.get_height_at(Vector3.ZERO), cut, "in another scene")
	again.map = again.map.duplicate()
	assert_eq(again.get_height_at(Vector3.ZERO), cut, "a map of its own")
	again.map = ResourceLoader.load(FILE, "", ResourceLoader.CACHE_MODE_IGNORE)
	assert_eq(again.get_height_at(Vector3.ZERO), cut, "saved and loaded")
	assert_eq(again.get_density_at(Vector3(1.5, 0, 1.5)), worn)
