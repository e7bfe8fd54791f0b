# SPDX-License-Identifier: MIT
## A GrassWorld of 16 x 16 km: plots load and unload around cameras and bodies, within a budget; changes are still there when a plot loads
## again.
extends "res://tests/world_case.gd"

const STEP := 1.0 / 64.0  # metres a tick: exact everywhere


func painted_map(strokes := 6) -> GrassMap:
	var map := full_map()
	for i in strokes:
		var at := Vector2(-50 + 17 * i, -40 + 13 * i)
		map.stroke(brush(GrassBrush.TOOL_HEIGHT, 6.0, {target = 0.4}), at, at + Vector2(8, 3))
	return map


## Blades have no room where two neighbouring numbers are metres apart.
func test_the_origin_is_not_shifted_out_of_reach() -> void:
	var world := add_world()
	await go(world, Vector3(64, 0, 64))
	for offset: Vector3 in [Vector3(1e30, 0, 0), Vector3(0, 0, -3e38), Vector3(2e7, 0, 0)]:
		expect_error("shift_origin() would put the world")
		world.shift_origin(offset)
		assert_eq(world.position, Vector3.ZERO)
	world.shift_origin(Vector3(9e6, 0, 0))
	assert_eq(world.position, Vector3(9e6, 0, 0))
	world.shift_origin(Vector3(-9e6, 0, 0))
	assert_eq(world.position, Vector3.ZERO)
	world.position.x = 5e7  # by hand
	world.shift_origin(Vector3(-1e7, 0, 0))
	assert_eq(world.position, Vector3(4e7, 0, 0), "nearer is never too far")


func test_plots_come_and_go() -> void:
	var map := painted_map()
	store(Vector2i(3, 0), map)
	var world := add_world()
	var came: Array[Vector2i] = []
	var went: Array[Vector2i] = []
	world.plot_loaded.connect(func(plot: Vector2i, _field: GrassField) -> void: came.append(plot))
	world.plot_leaving.connect(func(plot: Vector2i, _field: GrassField) -> void: went.append(plot))
	await go(world, Vector3(64, 0, 64))
	assert_eq(came[0], Vector2i(0, 0), "the nearest first")
	assert_eq(world.get_fields().size(), came.size())
	for field: GrassField in world.get_fields():
		assert_true(field.visible)
		assert_near(Vector2(field.position.x, field.position.z).distance_to(Vector2(64, 64)), 0.0, AHEAD + PLOT)
	assert_true(world.get_field(Vector2i(3, 0)) == null, "far away")
	await go(world, Vector3(3.5 * PLOT, 0, 64))
	var there := world.get_field_at(Vector3(3.5 * PLOT, 0, 64))
	assert_eq(there.map.data, map.data, "as it was painted")
	assert_true(went.has(Vector2i(-1, 0)))
	assert_true(world.get_field(Vector2i(-1, 0)) == null)
	assert_eq(world.get_statistics().files_written, 0, "nothing changed")
	await go(world, Vector3(8190, 0, -8190))
	assert_true(world.get_field(Vector2i(63, -64)) != null, "the corner")
	assert_true(world.get_field(Vector2i(64, -64)) == null)


func test_in_flight_no_field_is_made_and_a_frame_moves_one_plot() -> void:
	var world := add_world()
	await go(world, Vector3(64, 0, 64))
	await go(world, Vector3(192, 0, 128))
	var before: Dictionary = world.get_statistics()
	for i in 12:
		await go(world, Vector3(192 + 90 * i, 0, 128 + 40 * i))
	var now: Dictionary = world.get_statistics()
	assert_greater(now.brought - before.brought, 20)
	assert_less(now.fields_made - before.fields_made, 6, "fields that left are used again")
	assert_less(now.most_moves, 3, "plots that come or leave in a frame")


func test_the_budget_holds() -> void:
	var world := add_world({plot_scene = pattern({density = 64.0}), camera_radius = 500.0, memory_budget = 30.0})
	expect_error("`memory_budget` (30 MB) holds grass up to")
	for i in 4:
		await go(world, Vector3(64 + 300 * i, 0, 64))
		var now := world.get_statistics()
		assert_less(now.memory, 30e6)
		assert_greater(now.plots, 1)
		assert_less(now.reach, 500.0)
		assert_true(world.get_field_at(Vector3(64 + 300 * i, 0, 64)) != null, "the nearest")


func test_changes_are_written_and_come_back() -> void:
	var world := add_world()
	await go(world, Vector3(64, 0, 64))
	var place := Vector3(60, 0, 70)
	var deck := box(Vector3(4, 0.4, 4))
	var cut := world.cut(deck, Transform3D(Basis(), place + Vector3(0, 0.3, 0)))
	assert_greater(cut.area, 10.0)
	world.paint(brush(GrassBrush.TOOL_DENSITY, 3.0, {target = 0.0}), Vector3(128, 0, 30), Vector3(128, 0, 34))
	assert_eq(world.get_statistics().changed, 2)
	var cut_height: float = world.get_field_at(place).get_height_at(place)
	await go(world, Vector3(4000, 0, 64))
	world.wait_for_files()
	assert_eq(world.get_statistics().files_written, 2, "the plots on both sides of the border, too")
	await go(world, Vector3(64, 0, 64))
	assert_near(world.get_field_at(place).get_height_at(place), cut_height, 1e-6)
	assert_less(cut_height, 0.2)
	for x: float in [127.6, 128.4]:
		assert_eq(world.get_field_at(Vector3(x, 0, 32)).get_density_at(Vector3(x, 0, 32)), 0.0)
	world.free()
	world = add_world()
	await go(world, Vector3(64, 0, 64))
	assert_near(world.get_field_at(place).get_height_at(place), cut_height, 1e-6, "in the next game")


func test_save_and_leaving_the_tree() -> void:
	var world := add_world()
	await go(world, Vector3(64, 0, 64))
	var disc := brush(GrassBrush.TOOL_DENSITY, 3.0, {target = 0.0})
	world.paint(disc, Vector3(40, 0, 40), Vector3(40, 0, 40))
	assert_eq(world.save(), 1)
	world.wait_for_files()
	assert_true(FileAccess.file_exists(world.get_plot_path(Vector2i(0, 0))))
	assert_eq(world.save(), 0, "once")
	world.paint(disc, Vector3(90, 0, 90), Vector3(90, 0, 90))
	remove_child(world)
	var left: GrassMap = ResourceLoader.load(path_of(Vector2i(0, 0)), "", ResourceLoader.CACHE_MODE_IGNORE)
	assert_eq(left.sample(GrassMap.CHANNEL_DENSITY, Vector2(26, 26)), 0.0, "written when it left")
	add_child(world)
	await go(world, Vector3(64, 0, 64))
	assert_eq(world.get_field_at(Vector3(90, 0, 90)).get_density_at(Vector3(90, 0, 90)), 0.0)


func test_a_broken_file_is_refused_by_its_name() -> void:
	store(Vector2i(0, 0), painted_map())
	var whole := FileAccess.get_file_as_bytes(path_of(Vector2i(0, 0)))
	var broken := whole.slice(0, whole.size() - 7)
	FileAccess.open(path_of(Vector2i(0, 0)), FileAccess.WRITE).store_buffer(broken)
	expect_error("plot_0_0.grassmap")
	var world := add_world()
	await go(world, Vector3(64, 0, 64))
	assert_eq(world.get_statistics().files_refused, 1)
	assert_eq(world.get_field(Vector2i(0, 0)).get_density_at(Vector3(64, 0, 64)), 1.0, "stands with the default")
	await go(world, Vector3(4000, 0, 64))
	assert_eq(FileAccess.get_file_as_bytes(path_of(Vector2i(0, 0))), broken, "left alone")
	await go(world, Vector3(64, 0, 64))
	world.paint(brush(GrassBrush.TOOL_DENSITY, 3.0, {target = 0.0}), Vector3(40, 0, 40), Vector3(40, 0, 40))
	world.save()
	world.wait_for_files()
	assert_eq(FileAccess.get_file_as_bytes(path_of(Vector2i(0, 0)) + ".unread"), broken, "kept beside the new one")
	assert_true(ResourceLoader.load(path_of(Vector2i(0, 0)), "", ResourceLoader.CACHE_MODE_IGNORE) is GrassMap)


func test_grass_around_a_body_far_from_the_camera() -> void:
	var world := add_world()
	var place := Vector3(3000.25, 0.25, 64.25)
	await go(world, Vector3(64, 0, 64))
	var body := add_held_body(ball(0.3), place)
	for i in 20:
		body.position.x += 0.05
		await ticks(1)
	await wait_until(func() -> bool: return world.get_field_at(place) != null, "the body has grass")
	var field := world.get_field_at(place)
	await grown(field)
	for i in 20:
		body.position.x += 0.05
		await ticks(1)
	assert_greater(field.get_awake_tile_count(), 0)
	assert_greater(field.get_counters().pool_slots, 0)
	assert_eq(world.get_field_at(Vector3(64, 0, 64)).get_counters().pool_slots, 0, "nothing moves there")
	body.free()
	await wait_until(func() -> bool: return world.get_field_at(place) == null, "nobody is there any more")


func test_the_origin_is_shifted() -> void:
	var world := add_world({plot_scene = pattern({density = 64.0})})
	var place := Vector3(64.25, 0.25, 64.25)
	var body := add_held_body(ball(0.3), place)
	await go(world, Vector3(64, 0, 64))
	var field := world.get_field_at(place)
	for i in 20:
		body.position.x += STEP
		await ticks(1)
	await grown(field)
	for i in 30:
		body.position.x += STEP
		await ticks(1)
	var tile := field.get_tile_at(body.position)
	assert_true(field.is_tile_awake(tile))
	await ticks(150)  # until it rests beside the body
	var plots := world.get_fields()
	var before: Dictionary = world.get_statistics()
	var moved: Array[float] = []
	for offset: Vector3 in [Vector3.ZERO, Vector3(-2048, 0, 1024), Vector3(2048, 0, -1024)]:
		var knots := Transform3D(Basis(), -body.position) * tile_knots(field, tile)
		world.shift_origin(offset)
		body.position += offset
		eye.position += offset
		await ticks(4)
		assert_eq(world.get_fields(), plots, "the same plots")
		assert_true(world.get_field_at(body.position) == field)
		assert_true(field.is_tile_awake(tile))
		moved.append(farthest(Transform3D(Basis(), -body.position) * tile_knots(field, tile), knots))
	assert_less(moved[1], moved[0] + 2e-4, "no more than without a shift")
	assert_less(moved[2], moved[0] + 2e-4, "and back")
	assert_eq(world.get_statistics().brought, before.brought)
	assert_eq(world.get_plot_at(body.position), Vector2i(0, 0))


func test_without_a_folder_changes_are_kept_and_told_of() -> void:
	expect_error("`folder` and `save_folder` are empty")
	var world := add_world({folder = ""})
	await go(world, Vector3(64, 0, 64))
	world.paint(brush(GrassBrush.TOOL_DENSITY, 3.0, {target = 0.0}), Vector3(40, 0, 40), Vector3(40, 0, 40))
	await go(world, Vector3(4000, 0, 64))
	assert_eq(world.get_statistics().files_kept, 1)
	await go(world, Vector3(64, 0, 64))
	assert_eq(world.get_field(Vector2i(0, 0)).get_density_at(Vector3(40, 0, 40)), 0.0)


func test_wrong_properties() -> void:
	expect_error("`plot_size` cannot be 5")
	expect_error("`camera_radius` cannot be -3")
	expect_error("is not a GrassField")
	expect_error("tiles that do not fit `plot_size`")
	var wrong := PackedScene.new()
	var node := Node3D.new()
	wrong.pack(node)
	node.free()
	var world := add_world({plot_size = 5.0, camera_radius = -3.0, plot_scene = wrong})
	assert_eq(world.plot_size, 64.0)
	assert_eq(world.camera_radius, 0.0)
	await go(world, Vector3(10, 0, 10))
	assert_eq(world.get_fields().size(), 1)
	world.camera_radius = 1.0
	world.plot_scene = pattern({density = 200.0})
	await go(world, Vector3(10, 0, 10))
	world.get_field_at(Vector3(10, 0, 10)).free()
	await go(world, Vector3(10, 0, 10))
	assert_true(world.get_field_at(Vector3(10, 0, 10)) != null, "a field that a script freed comes again")


func test_clumps_and_stands_continue_across_borders() -> void:
	var tall := GrassSpecies.new()
	tall.stand_strength = 1.0
	tall.stand_size = 12.0
	var short := GrassSpecies.new()
	short.stand_strength = 1.0
	short.stand_size = 9.0
	short.patch = GrassPatch.new()
	short.patch.length_min = 0.1
	short.patch.length_max = 0.12
	var world := add_world({plot_scene = pattern({clump_size = 8.0, clump_height = 1.0, species = [tall, short]})})
	await go(world, Vector3(128, 0, 64))
	var left := world.get_field(Vector2i(0, 0))
	var right := world.get_field(Vector2i(1, 0))
	var most := 0.0
	var heights: Array[float] = []
	for z in range(4, 124):
		var here := left.get_height_at(Vector3(127.999, 0, z + 0.3))
		most = maxf(most, absf(here - right.get_height_at(Vector3(128.001, 0, z + 0.3))))
		heights.append(here)
	assert_less(most, 0.01, "metres, between the last of one plot and the first of the next")
	assert_greater(heights.max() - heights.min(), 0.2, "there are clumps and stands")
	var other: Array[float] = []
	for z in range(4, 124):
		other.append(right.get_height_at(Vector3(255.999, 0, z + 0.3)))
	assert_ne(heights, other, "and they are not the same in each plot")


func test_noise_of_a_rule_continues_across_borders() -> void:
	var rule := GrassFillRule.new()
	rule.noise_cover = 0.5
	rule.noise_size = 12.0
	rule.noise_fade = 0.0
	var world := add_world({plot_scene = pattern({fill_rule = rule})})
	await go(world, Vector3(128, 0, 64))
	var left := world.get_field(Vector2i(0, 0))
	var right := world.get_field(Vector2i(1, 0))
	await wait_until(func() -> bool: return left.get_counters().fill_waiting + right.get_counters().fill_waiting == 0, "rules have run")
	await frames(4)
	var same := 0
	var grown := 0
	for z in range(4, 124):
		var here := left.get_density_at(Vector3(127.7, 0, z + 0.25)) > 0.5
		grown += 1 if here else 0
		same += 1 if here == (right.get_density_at(Vector3(128.3, 0, z + 0.25)) > 0.5) else 0
	assert_greater(same, 112, "of 120 places on both sides of the border")
	assert_greater(grown, 20)
	assert_less(grown, 100)
