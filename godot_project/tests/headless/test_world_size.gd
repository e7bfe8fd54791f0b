# SPDX-License-Identifier: MIT
## The cost of 16 x 16 km of painted grass: bytes of a square kilometre on disk, bytes in memory, and work of a frame during a flight.
extends "res://tests/world_case.gd"

const WIDE := 256.0  # metres of a plot
const PLOTS := 4
const DISK := 4e6  # bytes of a square kilometre, at most
const MEMORY := 100.0  # MB
# In a frame. Of the cover four parts of 0.3 MB; without a renderer the textures of a map are made there, too: four of 25 chunks.
const MOST_BYTES := 4e6


## Returns a plot on rolling ground, with strokes of every kind all over it.
func painted_plot(seed_number: int) -> GrassMap:
	var rng := RandomNumberGenerator.new()
	rng.seed = seed_number
	var map := full_map()
	var soft := {hardness = 0.2, strength = 0.5}
	var half := 0.5 * WIDE
	for i in 60:
		var from := Vector2(rng.randf_range(-half, half), rng.randf_range(-half, half))
		var to := from + Vector2(rng.randf_range(-40, 40), rng.randf_range(-40, 40))
		soft.target = rng.randf()
		match i % 5:
			0:
				map.stroke(brush(GrassBrush.TOOL_DENSITY, 10.0, soft), from, to)
			1:
				map.stroke(brush(GrassBrush.TOOL_HEIGHT, 14.0, soft), from, to)
			2:
				var color := Color(rng.randf(), rng.randf(), 0.2)
				map.stroke(brush(GrassBrush.TOOL_TINT, 12.0, soft.merged({color = color})), from, to)
			3:
				map.stroke(brush(GrassBrush.TOOL_COMB, 8.0, soft), from, to)
			4:
				map.stroke(brush(GrassBrush.TOOL_CUT, 1.5, {cut_height = 0.06}), from, to)
	var noise := FastNoiseLite.new()
	noise.seed = seed_number
	var side := int(WIDE) + 1
	var heights := Image.create_empty(side, side, false, Image.FORMAT_RF)
	for y in side:
		for x in side:
			heights.set_pixel(x, y, Color(20.0 * noise.get_noise_2d(x, y), 0, 0))
	map.set_ground(heights, Rect2(-half, -half, WIDE, WIDE))
	return map


func test_painted_ground_on_disk_and_in_memory() -> void:
	var bytes := 0
	for x in PLOTS:
		store(Vector2i(x, 0), painted_plot(x))
		bytes += FileAccess.get_file_as_bytes(path_of(Vector2i(x, 0))).size()
	var per_square_kilometre := bytes / (PLOTS * WIDE * WIDE * 1e-6)
	assert_less(per_square_kilometre, DISK, "bytes on disk")
	for x in range(-2, 12):
		for z: int in [-1, 0, 1]:
			if x < 0 or x >= PLOTS or z != 0:
				DirAccess.copy_absolute(path_of(Vector2i(posmod(x + z, PLOTS), 0)), path_of(Vector2i(x, z)))
	var scene := pattern({density = 256.0, pool_tiles = 256})
	expect_error("`memory_budget` (100 MB) holds grass up to")
	var world := add_world({plot_scene = scene, plot_size = WIDE, memory_budget = MEMORY, camera_radius = 400.0})
	await go(world, Vector3(0, 0, 128))
	await go(world, Vector3(200, 0, 128))
	var before: Dictionary = world.get_statistics()
	var most := 0
	for i in 200:
		eye.position.x = 200.0 + 10.0 * i
		OS.delay_msec(3)  # the thread reads meanwhile
		await frames(1)
		if i % 40 == 39:  # however slow it is
			await loaded(world)
		most = maxi(most, world.get_statistics().memory)
	await loaded(world)
	var now := world.get_statistics()
	assert_less(most, 1e6 * MEMORY)
	assert_greater(now.brought - before.brought, 4)
	assert_eq(now.fields_made, before.fields_made, "in flight")
	assert_less(now.most_moves, 3, "plots that come or leave in a frame")
	assert_less(now.most_parts, 5, "parts of fields that are made in a frame")
	assert_less(now.most_bytes, MOST_BYTES, "handed to the renderer in a frame")
	assert_greater(now.most_bytes, 0)
	assert_greater(now.plots, 3)
	print("world: %.2f MB a km2 on disk, %.1f MB in memory, %d plots" % [1e-6 * per_square_kilometre, 1e-6 * most, now.plots])
