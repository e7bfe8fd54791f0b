# SPDX-License-Identifier: MIT
## The renderer's memory: how much a field takes, and that it frees all of it.
extends "res://tests/view_case.gd"

const MEMORY: Array[Performance.Monitor] = [
	Performance.RENDER_VIDEO_MEM_USED, Performance.RENDER_TEXTURE_MEM_USED, Performance.RENDER_BUFFER_MEM_USED
]


func used() -> Array[float]:
	var values: Array[float] = []
	for monitor in MEMORY:
		values.append(Performance.get_monitor(monitor))
	return values


func test_out_and_in_leaves_nothing() -> void:
	var field := add_seen_field({size = Vector2(1, 1), pool_tiles = 64})
	var body := AnimatableBody3D.new()
	add_shape(body, ball(0.2))
	viewport.add_child(body)
	var at_first: Array[float] = []
	var objects := 0.0
	for i in 60:
		viewport.remove_child(field)
		if i % 3 == 0:
			await frames(1)
		viewport.add_child(field)
		await frames(1 if i % 2 else 3)
		if i == 9:
			await frames(5)
			at_first = used()
			objects = Performance.get_monitor(Performance.OBJECT_COUNT)
	await frames(5)
	var at_last := used()
	for i in MEMORY.size():
		assert_less(at_last[i] - at_first[i], 1e5, "bytes of %s" % ["video memory", "textures", "buffers"][i])
	assert_less(Performance.get_monitor(Performance.OBJECT_COUNT) - objects, 4.0, "objects")
	assert_greater(field.get_awake_tile_count(), 0)
	assert_greater(field.get_statistics().drawn_tiles, 0)


func test_a_field_takes_what_it_says_and_gives_it_back() -> void:
	await frames(5)
	var without := used()
	var field := add_seen_field({size = Vector2(8, 8), pool_tiles = 1024})
	await frames(5)
	var taken := used()[0] - without[0]
	var told := field.get_memory_usage()
	print(
		(
			"    a field of %d blades: %.1f MiB by itself, %.1f MiB by the renderer"
			% [field.get_blade_count(), told / 1048576.0, taken / 1048576.0]
		)
	)
	assert_near(told, taken, 0.25 * taken)
	field.free()
	await frames(8)
	assert_less(used()[0] - without[0], 2e5, "bytes left")


func test_rebuilds_leave_nothing() -> void:
	var field := add_seen_field({size = Vector2(1, 1), pool_tiles = 64})
	var at_first := 0.0
	for round in 2:
		for i in 12:
			field.seed = i
			field.pool_tiles = 64 + 64 * (i % 2)
			field.map = full_map() if i % 3 == 0 else null
			field.species = [GrassSpecies.new(), GrassSpecies.new()] if i % 4 == 0 else []
			await frames(3)
			if i % 2:
				await grown(field)
		field.pool_tiles = 64
		field.map = null
		field.species = []
		await grown(field)
		await frames(8)
		if round == 0:
			at_first = used()[0]  # what the renderer keeps for its own uploads has grown by now
	assert_less(used()[0] - at_first, 1e5, "bytes")


## A texture that goes leaves its place to the next one that anybody makes: whoever still asks for the old one then gets an error.
func test_a_field_asks_for_no_texture_that_is_gone() -> void:
	var done := [false]
	var thread := Thread.new()  # as the editor's previews do
	thread.start(
		func() -> void:
			var image := Image.create_empty(64, 64, false, Image.FORMAT_RGBA8)
			var kept: Array[Texture2D] = []
			while not done[0]:
				kept.append(ImageTexture.create_from_image(image))
				OS.delay_usec(200)
				if kept.size() > 500:
					kept.clear()
	)
	for mapped: bool in [false, true]:
		for i in 20:
			var field := add_seen_field({size = Vector2(2, 2), pool_tiles = 64, wind_speed = 3.0, map = GrassMap.new() if mapped else null})
			await frames(2)
			assert_greater(field.get_counters().instance_updates, 0, "it was drawn, and no error was reported")
			field.free()
	done[0] = true
	thread.wait_to_finish()
