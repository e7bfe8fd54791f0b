# SPDX-License-Identifier: MIT
## Filling by rule: once and live, undone, over other ground and under paint.
extends "res://tests/fill_case.gd"


func test_a_map_is_filled_and_a_snapshot_undoes_it() -> void:
	var map := GrassMap.new()
	var changes: Array = []
	map.chunks_changed.connect(func(chunks: Array[Vector2i], region: Rect2) -> void: changes.append([chunks, region]))
	var before := map.take_snapshot()
	var data := map.get_data()
	assert_near(map.fill(_rule({density = 0.5}), Rect2(-10, -20, 40, 30)), 600.0, 3.0)
	assert_eq(changes.size(), 1)
	assert_eq(changes[0][0], [Vector2i(-1, -1), Vector2i(-1, 0), Vector2i(0, -1), Vector2i(0, 0)] as Array[Vector2i])
	assert_eq(changes[0][1], Rect2(-10, -20, 40, 30))
	var filled := map.get_data()
	map.restore_snapshot(before)
	assert_eq(map.get_data(), data)
	assert_near(map.fill(_rule({density = 0.5}), Rect2(-10, -20, 40, 30)), 600.0, 3.0)
	assert_eq(map.get_data(), filled, "the same again")
	assert_near(map.fill(null, Rect2(-10, -20, 40, 30)), -600.0, 3.0)
	assert_eq(map.get_data(), data)


func test_slope_and_height_are_those_of_the_ground() -> void:
	var heights := Image.create_empty(64, 1, false, Image.FORMAT_RF)
	for i in 64:  # level up to x = 0, then a slope of 45 degrees
		heights.set_pixel(i, 0, Color(maxf(0.0, i - 31.5), 0, 0))
	var map := GrassMap.new()
	assert_true(map.set_ground(heights, Rect2(-32, -32, 64, 64)))
	map.fill(_rule({slope_max = 30.0}), Rect2(-30, -30, 60, 60))
	assert_eq(map.sample(GrassMap.CHANNEL_DENSITY, Vector2(-10, 0)), 1.0)
	assert_eq(map.sample(GrassMap.CHANNEL_DENSITY, Vector2(10, 0)), 0.0)
	map.fill(_rule({height_min = 5.0, height_fade = 0.0}), Rect2(-30, -30, 60, 60))
	assert_eq(map.sample(GrassMap.CHANNEL_DENSITY, Vector2(-10, 0)), 0.0)
	assert_eq(map.sample(GrassMap.CHANNEL_DENSITY, Vector2(3, 0)), 0.0)
	assert_eq(map.sample(GrassMap.CHANNEL_DENSITY, Vector2(8, 0)), 1.0)


func test_a_field_is_full_when_it_comes_into_the_tree() -> void:
	var finished := [0]
	var field := GrassField.new()
	field.name = "Meadow"
	field.size = Vector2(256, 256)
	field.density = 1.0
	field.fill_rule = _rule({density = 0.75})
	field.fill_finished.connect(func() -> void: finished[0] += 1)
	add_child(field)
	await frames(1)
	assert_eq(finished[0], 1)
	assert_eq(field.get_counters().fill_cells, 16 * CELLS_A_CHUNK)
	assert_eq(field.get_counters().fill_waiting, 0)
	assert_near(field.get_density_at(Vector3(100, 0, -100)), 0.75, 0.01)
	await _follow()
	assert_eq(field.get_counters().fill_cells, 16 * CELLS_A_CHUNK, "nothing changed, nothing done")


func test_a_live_rule_is_followed_a_few_chunks_a_frame() -> void:
	var rule := _rule({density = 0.75})
	var field := await _add_filled(rule)
	var cells: int = field.get_counters().fill_cells
	var finished := [0]
	field.fill_finished.connect(func() -> void: finished[0] += 1)
	rule.density = 0.25
	rule.density = 0.5
	await frames(1)
	for n in 10:
		var done: int = field.get_counters().fill_cells - cells
		assert_eq(done, mini((n + 1) * 4, 16) * CELLS_A_CHUNK)
		await frames(1)
	assert_eq(finished[0], 1)
	assert_near(_density(field, 100, 100), 0.5, 0.01)
	field.fill_rule = null
	assert_eq(_density(field, 100, 100), 1.0, "the field's map is full where no rule fills it")
	field.fill_rule = rule
	await _follow()
	assert_near(_density(field, 100, 100), 0.5, 0.01)


func test_paint_stays_whatever_the_rule_says() -> void:
	var rule := _rule({noise_cover = 0.6, seed = 3})
	var field := await _add_filled(rule)
	_erase(field.map, Vector2(20, 20), 6.0)
	var painted := field.map.get_data()
	rule.noise_cover = 1.0
	await _follow()
	assert_eq(_density(field, 20, 20), 0.0)
	assert_eq(_density(field, 40, 40), 1.0)
	rule.noise_cover = 0.6
	await _follow()
	assert_eq(field.map.get_data(), painted)
	field.fill_rule = null
	assert_eq(_density(field, 20, 20), 0.0)


func test_strokes_and_cuts_fill_nothing_again_but_snapshots_do() -> void:
	var rule := _rule()
	var field := await _add_filled(rule)
	var full := field.map.take_snapshot()
	var cells: int = field.get_counters().fill_cells
	_erase(field.map, Vector2(20, 20), 6.0)
	field.trample(Vector3(-20, 0, 20), 2.0, 1.0)
	await _follow()
	assert_eq(field.get_counters().fill_cells, cells)
	rule.density = 0.5
	await _follow()
	cells = field.get_counters().fill_cells
	field.map.restore_snapshot(full)
	assert_eq(_density(field, 100, 100), 1.0)
	await _follow()
	assert_near(_density(field, 100, 100), 0.5, 0.01, "the rule of now fills the map of then")
	assert_near(_density(field, 20, 20), 0.5, 0.01, "the stroke is undone")
	assert_eq(field.get_counters().fill_cells, cells + 16 * CELLS_A_CHUNK)


func test_what_a_step_takes_back_is_filled_by_the_rule_of_now() -> void:
	var rule := _rule()
	var field := await _add_filled(rule)
	var before_it := field.map.take_snapshot()
	_erase(field.map, Vector2(20, 20), 6.0)
	var after_it := field.map.take_snapshot()
	_erase(field.map, Vector2(-20, 20), 6.0)
	rule.density = 0.5
	await _follow()
	field.map.restore_snapshot(before_it, after_it)
	await _follow()
	assert_near(_density(field, 20, 20), 0.5, 0.01, "undone")
	assert_near(_density(field, -20, 20), 0.0, 0.01, "the other one stays")
	field.map.restore_snapshot(after_it, before_it)
	await _follow()
	assert_near(_density(field, 20, 20), 0.0, 0.01, "and again")


func test_the_maps_base_density_shows_only_where_no_rule_fills() -> void:
	var rule := _rule()
	var field := await _add_filled(rule)
	assert_true(field.map.is_empty(), "full as the map is by itself")
	field.map.base_density = 0.0
	await _follow()
	assert_eq(_density(field, 100, 100), 1.0)
	assert_eq(field.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(200, 0)), 0.0)


func test_another_rule_does_not_make_the_field_anew() -> void:
	var field := await _add_filled(_rule())
	var builds: int = field.get_counters().builds
	field.fill_rule = _rule({density = 0.5})
	await _follow()
	field.fill_rule = null
	field.fill_rule = _rule({density = 0.25})
	await _follow()
	assert_near(_density(field, 100, 100), 0.25, 0.01)
	assert_eq(field.get_counters().builds, builds)


func test_new_ground_is_filled_anew() -> void:
	var rule := _rule({height_max = 2.0, height_fade = 0.0})
	expect_error("the map has no ground")
	var field := await _add_filled(rule)
	assert_eq(_density(field, 20, 20), 1.0)
	var hill := Image.create_empty(8, 8, false, Image.FORMAT_RF)
	hill.fill(Color(5, 0, 0))
	field.map.set_ground(hill, Rect2(10, 10, 20, 20))
	await _follow()
	assert_eq(_density(field, 20, 20), 0.0)
	assert_eq(_density(field, 50, 20), 1.0)


func test_fill_once_does_not_follow() -> void:
	var rule := _rule({density = 0.5})
	var field := add_field({size = Vector2(100, 100), fill_live = false, fill_rule = rule})
	await _follow()
	assert_true(field.map == null, "not asked to")
	assert_near(field.fill(rule), -5000.0, 30.0, "it was full")
	assert_near(_density(field, 40, 0), 0.5, 0.01)
	rule.density = 0.25
	await _follow()
	assert_near(_density(field, 40, 0), 0.5, 0.01)
	field.fill_rule = null
	assert_near(_density(field, 40, 0), 0.5, 0.01, "what is filled stays")
	field.fill_rule = rule
	field.fill_live = true
	await frames(2)
	assert_near(_density(field, 40, 0), 0.25, 0.01)
	expect_error("fill() was called while `fill_rule` is live")
	field.fill(_rule())


func test_two_fields_of_one_rule_and_a_new_map() -> void:
	var rule := _rule({noise_cover = 0.5})
	var one := await _add_filled(rule)
	var other := await _add_filled(rule, {position = Vector3(500, 0, 0)})
	assert_eq(one.map.get_data(), other.map.get_data())
	one.map = GrassMap.new()
	await _follow()
	assert_eq(one.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(200, 0)), 0.0, "beside the field the new map is bare")
	for n in 50:
		assert_eq(_density(one, n * 2.0, 3.0), _density(other, n * 2.0, 3.0))
	rule.noise_cover = 0.0
	await _follow()
	assert_eq(_density(one, 3, 3), 0.0)
	assert_eq(_density(other, 3, 3), 0.0)


func test_rules_are_saved_with_their_properties() -> void:
	var rule := _rule({slope_max = 33.0, noise_cover = 0.4, seed = 9, mask_group = &"meadow", mask_region = Rect2(1, 2, 3, 4)})
	assert_eq(ResourceSaver.save(rule, "user://rule.tres"), OK)
	var loaded := ResourceLoader.load("user://rule.tres", "", ResourceLoader.CACHE_MODE_IGNORE) as GrassFillRule
	for property: String in ["slope_max", "noise_cover", "seed", "mask_group", "mask_region", "exclusion_group"]:
		assert_eq(loaded.get(property), rule.get(property), property)
	DirAccess.remove_absolute("user://rule.tres")


func test_bad_values_are_refused_or_clamped() -> void:
	var rule := GrassFillRule.new()
	expect_error("GrassFillRule: `slope_max` cannot be 400")
	rule.slope_max = 400.0
	assert_eq(rule.slope_max, 90.0)
	rule.density = NAN
	assert_eq(rule.density, 1.0)
	expect_error("`mask_region` must be finite")
	rule.mask_region = Rect2(NAN, 0, 1, 1)
	assert_eq(rule.mask_region, Rect2())
	expect_error("fill() needs a region")
	assert_eq(GrassMap.new().fill(rule, Rect2(0, 0, INF, 4)), 0.0)
	expect_error("fill() needs a GrassFillRule")
	assert_eq(add_field().fill(null), 0.0)
	expect_error("`outline` must have finite numbers only")
	var exclusion := GrassExclusion3D.new()
	exclusion.outline = PackedVector2Array([Vector2(NAN, 0)])
	assert_true(exclusion.outline.is_empty())
	exclusion.free()
