# SPDX-License-Identifier: MIT
## One switch for all fields and worlds: what it scales, what it leaves alone, and what it says of wrong values. What is drawn is counted
## in tests/gpu/test_quality.gd.
extends "res://tests/world_case.gd"

const LEVEL_SETTING := "grass_field/quality/level"
const CUSTOM_SETTING := "grass_field/quality/custom"
const FILE := "user://test_quality.tres"
const SCENE := "user://test_quality.tscn"
const PAGE := "../docs/guide/performance.md"
const LEVELS: Array[GrassQuality.Level] = [
	GrassQuality.LEVEL_LOW, GrassQuality.LEVEL_MEDIUM, GrassQuality.LEVEL_HIGH, GrassQuality.LEVEL_ULTRA
]
const FACTORS: Array[String] = [
	"pixels_min",
	"lod_error",
	"lod_far",
	"shadow_distance",
	"shadow_coarseness",
	"plant_distance",
	"contact_rate",
	"pool_tiles",
]


func after() -> void:
	super()
	for setting: String in [LEVEL_SETTING, CUSTOM_SETTING]:
		ProjectSettings.set_setting(setting, ProjectSettings.property_get_revert(setting))
	GrassQuality.reset_level()
	for file: String in [FILE, SCENE]:
		if FileAccess.file_exists(file):
			DirAccess.remove_absolute(file)


func pool_of(field: GrassField) -> int:
	return field.get_counters().pool_tiles


func test_two_fields_and_a_world_change_together() -> void:
	var world := add_world()
	await go(world, Vector3(64, 0, 64))
	var mover := add_held_body(ball(0.3), Vector3(64.25, 0.25, 64.25))
	var plot := world.get_field(Vector2i(0, 0))
	for i in 20:
		mover.position.x += 0.05
		await ticks(1)
	await wait_until(func() -> bool: return pool_of(plot) == 128, "its plot has a pool")
	var fields: Array[GrassField] = [add_field({pool_tiles = 400}), add_field({pool_tiles = 1, map = full_map()})]
	for field in fields:
		await grown(field)
	var before: Array[Dictionary] = []
	for field: GrassField in fields + [plot]:
		before.append(field.get_counters())
	for step: Array in [[0, [100, 1, 32]], [3, [800, 2, 256]], [1, [200, 1, 64]], [2, [400, 1, 128]]]:
		GrassQuality.set_level(step[0])
		assert_eq(GrassQuality.get_level(), step[0])
		var wanted: Array = step[1]
		for i in 10:
			mover.position.x += 0.05 if i % 2 == 0 else -0.05
			await ticks(1)
		assert_eq(fields.map(pool_of), wanted.slice(0, 2), "level %d" % step[0])
		assert_eq(pool_of(plot), wanted[2], "level %d" % step[0])
	assert_eq(fields.map(func(field: GrassField) -> int: return field.pool_tiles), [400, 1], "as designed")
	for i in 3:
		var now := (fields + [plot])[i].get_counters() as Dictionary
		for work: String in ["makings", "builds", "map_bytes", "fill_cells", "terrain_queries"]:
			assert_eq(now[work], before[i][work], work)
	mover.free()


func test_a_field_that_comes_later_has_the_level() -> void:
	GrassQuality.set_level(GrassQuality.LEVEL_LOW)
	var field := add_field({pool_tiles = 400})
	await grown(field)
	assert_eq(pool_of(field), 100)
	assert_eq(field.get_counters().makings, 1)
	GrassQuality.set_level(GrassQuality.LEVEL_ULTRA)
	field.clump_lean = 0.3
	await grown(field)
	await ticks(2)
	assert_eq(pool_of(field), 800, "also one that was being made meanwhile")


## Returns knots of a tile that a ball has rolled over, at a level of quality.
func rolled_over(rate: float, level: GrassQuality.Level) -> PackedVector3Array:
	GrassQuality.set_level(level)
	var field := add_field({contact_rate = rate})
	await grown(field)
	var body := add_held_body(ball(0.2), Vector3(-1, 0.2, 0.2))
	for i in 40:
		body.position.x += 0.03
		await ticks(1)
	var knots := tile_knots(field, field.get_tile_at(Vector3(0, 0, 0.2)))
	body.free()
	field.free()
	return knots


func test_contact_is_finer_at_a_higher_level() -> void:
	var high := await rolled_over(1600.0, GrassQuality.LEVEL_HIGH)
	assert_greater(high.size(), 0)
	assert_eq(await rolled_over(800.0, GrassQuality.LEVEL_ULTRA), high, "twice the rate")
	assert_eq(await rolled_over(3200.0, GrassQuality.LEVEL_LOW), high, "half of it")
	assert_eq(await rolled_over(1100.0, GrassQuality.LEVEL_HIGH), high, "what lies between counts as the next one")
	assert_true(await rolled_over(800.0, GrassQuality.LEVEL_HIGH) != high, "another rate")


func test_what_is_bent_stays_bent() -> void:
	var fields: Array[GrassField] = []
	for i in 2:
		fields.append(add_field({pool_tiles = 256, position = Vector3(100 * i, 0, 0)}))
		add_held_body(ball(0.3), Vector3(100 * i + 0.3, 0.25, 0.2))
	await ticks(20)
	var awake := awake_tiles(fields[0])
	assert_greater(awake.size(), 4)
	assert_less(awake.size(), 64)
	var woken: int = fields[0].get_counters().woken
	for level in [0, 3, 1, 2]:
		GrassQuality.set_level(level)
		for i in 4:
			await ticks(1)
			assert_eq(awake_tiles(fields[0]), awake, "level %d" % level)
	assert_eq(fields[0].get_counters().woken, woken, "none woke again")
	assert_eq(fields[0].get_counters().evicted, 0)
	for tile in awake:
		assert_true(all_finite(fields[0], [tile]))
	assert_greater(fields[0].get_bend_at(Vector3(0.5, 0, 0.2)).length(), 0.03)


func test_of_too_many_tiles_some_come_to_rest() -> void:
	var field := add_field({pool_tiles = 16})
	for place: Vector2 in [Vector2(-1.5, -1.5), Vector2(1.5, 1.5), Vector2(-1.5, 1.5), Vector2(1.5, -1.5)]:
		add_held_body(ball(0.3), Vector3(place.x, 0.25, place.y))
	await ticks(10)
	assert_eq(field.get_awake_tile_count(), 16)
	var evicted: int = field.get_counters().evicted
	GrassQuality.set_level(GrassQuality.LEVEL_LOW)
	await ticks(2)
	assert_eq(field.get_awake_tile_count(), 4)
	assert_eq(awake_tiles(field).size(), 4)
	assert_greater(field.get_counters().evicted - evicted, 11, "and some of the four give way to others")
	GrassQuality.set_level(GrassQuality.LEVEL_HIGH)
	await ticks(4)
	assert_eq(field.get_awake_tile_count(), 16, "the bodies are still there")
	assert_true(all_finite(field, awake_tiles(field)))


## In any order, with bodies that come and go: nothing breaks.
func test_levels_at_random() -> void:
	var random := RandomNumberGenerator.new()
	random.seed = 7
	var field := add_field({size = Vector2(8, 8), pool_tiles = 24, map = full_map()})
	var own := GrassQuality.new()
	var bodies: Array[Node3D] = []
	for i in 3:
		bodies.append(add_held_body(ball(0.3), Vector3(i, 0.25, 0)))
	for round in 60:
		own.pool_tiles = random.randf_range(0.0, 4.0)
		if random.randf() < 0.5:
			GrassQuality.set_custom(own)
		else:
			GrassQuality.set_level(random.randi_range(0, 3) as GrassQuality.Level)
		for body in bodies:
			body.position += Vector3(random.randf_range(-0.3, 0.3), 0, random.randf_range(-0.3, 0.3))
		await ticks(2)
		var now := field.get_counters()
		assert_true(field.get_awake_tile_count() <= now.pool_tiles, "round %d" % round)
		var awake := awake_tiles(field)
		assert_eq(awake.size(), field.get_awake_tile_count())
		if awake and not assert_true(all_finite(field, awake)):
			return
	assert_eq(field.get_counters().makings, 1)


func test_a_saved_scene_does_not_know_of_it() -> void:
	var field := add_field({pool_tiles = 300, lod_far = 70.0, shadow_distance = 33.0})
	await grown(field)
	var saved: Array[PackedByteArray] = []
	for level in [2, 0, 3]:
		GrassQuality.set_level(level)
		await ticks(2)
		var scene := PackedScene.new()
		assert_eq(scene.pack(field), OK)
		assert_eq(ResourceSaver.save(scene, SCENE), OK)
		saved.append(FileAccess.get_file_as_bytes(SCENE))
	assert_greater(saved[0].size(), 0)
	assert_true(saved[1] == saved[0] and saved[2] == saved[0], "the same bytes")
	assert_eq([field.pool_tiles, field.lod_far, field.shadow_distance], [300, 70.0, 33.0])


func test_own_factors() -> void:
	var field := add_field({pool_tiles = 100})
	await grown(field)
	assert_true(GrassQuality.get_custom() == null)
	var own := GrassQuality.from_level(GrassQuality.LEVEL_LOW)
	own.pool_tiles = 0.5
	GrassQuality.set_custom(own)
	assert_eq(GrassQuality.get_level(), GrassQuality.LEVEL_CUSTOM)
	await ticks(2)
	assert_eq(pool_of(field), 50)
	own.pool_tiles = 0.0
	await ticks(2)
	assert_eq(pool_of(field), 0, "a change of the resource is enough")
	assert_true(GrassQuality.get_custom() == own)
	var copy := GrassQuality.from_level(GrassQuality.LEVEL_CUSTOM)
	assert_true(copy != own)
	assert_eq(copy.lod_error, own.lod_error)
	GrassQuality.set_level(GrassQuality.LEVEL_HIGH)
	await ticks(2)
	assert_eq(pool_of(field), 100)
	GrassQuality.set_level(GrassQuality.LEVEL_CUSTOM)
	await ticks(2)
	assert_eq(pool_of(field), 0, "they are still known")


func test_wrong_values_are_refused_by_name() -> void:
	GrassQuality.set_level(GrassQuality.LEVEL_LOW)
	expect_error("the level must be one of the LEVEL_* constants")
	GrassQuality.set_level(9 as GrassQuality.Level)
	GrassQuality.set_level(-1 as GrassQuality.Level)
	assert_true(GrassQuality.from_level(5 as GrassQuality.Level) == null)
	expect_error("set_custom() needs a GrassQuality")
	GrassQuality.set_custom(null)
	assert_eq(GrassQuality.get_level(), GrassQuality.LEVEL_LOW)
	var own := GrassQuality.new()
	own.resource_name = "Menu"
	expect_error("GrassQuality 'Menu': `lod_error` cannot be 100")
	own.lod_error = 100.0
	assert_eq(own.lod_error, 8.0)
	expect_error("`pool_tiles` cannot be nan")
	own.pool_tiles = NAN
	assert_eq(own.pool_tiles, 1.0)
	expect_error("`plant_distance` cannot be 2")
	own.plant_distance = 2.0


func test_the_project_has_a_level() -> void:
	assert_eq(ProjectSettings.get_setting(LEVEL_SETTING), GrassQuality.LEVEL_HIGH)
	assert_eq(GrassQuality.get_level(), GrassQuality.LEVEL_HIGH)
	ProjectSettings.set_setting(LEVEL_SETTING, GrassQuality.LEVEL_MEDIUM)
	GrassQuality.reset_level()
	assert_eq(GrassQuality.get_level(), GrassQuality.LEVEL_MEDIUM)
	ProjectSettings.set_setting(LEVEL_SETTING, 7)
	expect_error("The project setting grass_field/quality/level is 7, but must be 0 (Low) to 4 (Custom)")
	GrassQuality.reset_level()
	assert_eq(GrassQuality.get_level(), GrassQuality.LEVEL_HIGH)
	ProjectSettings.set_setting(LEVEL_SETTING, GrassQuality.LEVEL_CUSTOM)
	expect_error("is Custom, but grass_field/quality/custom ('') is not the file of a GrassQuality")
	GrassQuality.reset_level()
	assert_eq(GrassQuality.get_level(), GrassQuality.LEVEL_HIGH)
	var own := GrassQuality.new()
	own.lod_far = 0.3
	assert_eq(ResourceSaver.save(own, FILE), OK)
	ProjectSettings.set_setting(CUSTOM_SETTING, FILE)
	GrassQuality.reset_level()
	assert_eq(GrassQuality.get_level(), GrassQuality.LEVEL_CUSTOM)
	assert_near(GrassQuality.get_custom().lod_far, 0.3, 1e-6)


func test_a_game_in_a_browser_starts_low() -> void:
	assert_eq(ProjectSettings.get_setting(LEVEL_SETTING + ".web"), GrassQuality.LEVEL_LOW)


func test_the_guide_has_the_factors() -> void:
	var page := FileAccess.get_file_as_string(ProjectSettings.globalize_path("res://").path_join(PAGE))
	if page.is_empty():
		skip("an exported project has no pages")
		return
	for factor in FACTORS:
		var cells: Array[String] = ["`%s`" % factor]
		for level in LEVELS:
			cells.append(String.num(GrassQuality.from_level(level).get(factor), 2).trim_suffix(".0"))
		assert_true(page.contains("| %s |" % " | ".join(cells)), "| %s |" % " | ".join(cells))


func test_who_listens_hears_of_another_level_once() -> void:
	var heard: Array[GrassQuality.Level] = []
	var listen := func() -> void: heard.append(GrassQuality.get_level())
	var now := GrassQuality.get_current()
	now.changed.connect(listen)
	assert_eq(now, GrassQuality.get_current(), "always the same")
	assert_eq(now.lod_far, 1.0)
	GrassQuality.set_level(GrassQuality.LEVEL_HIGH)
	assert_eq(heard.size(), 0, "the same level again")
	GrassQuality.set_level(GrassQuality.LEVEL_LOW)
	assert_eq(now.lod_far, 0.4)
	var own := GrassQuality.from_level(GrassQuality.LEVEL_LOW)
	GrassQuality.set_custom(own)  # the same factors, another level
	own.lod_far = 0.5
	assert_eq(now.lod_far, 0.5)
	GrassQuality.set_level(GrassQuality.LEVEL_MEDIUM)
	own.lod_far = 0.6  # of no level now
	GrassQuality.reset_level()
	own.lod_far = 0.7  # nobody's any more
	assert_eq(
		heard,
		[GrassQuality.LEVEL_LOW, GrassQuality.LEVEL_CUSTOM, GrassQuality.LEVEL_CUSTOM, GrassQuality.LEVEL_MEDIUM, GrassQuality.LEVEL_HIGH]
	)
	expect_error("get_current() shows the factors in force")
	now.lod_far = 2.0
	assert_eq(now.lod_far, 1.0)
	expect_error("set_custom() needs a GrassQuality of your own")
	GrassQuality.set_custom(now)
	assert_eq(GrassQuality.get_level(), GrassQuality.LEVEL_HIGH)
	now.changed.disconnect(listen)
