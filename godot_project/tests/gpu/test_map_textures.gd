# SPDX-License-Identifier: MIT
## What a frame uploads of a map while the map grows: one chunk more than the textures have room for must not upload all of it.
extends "res://tests/field_case.gd"

const CHUNK := 64.0
const LAYER := 119000  # bytes of a chunk in the textures
const SIDE := 16  # 256 chunks fill the textures
const FRAMES := 3000  # at most until there is room for more


func paint_chunk(map: GrassMap, x: int, z: int) -> void:
	var place := Vector2(x + 0.5, z + 0.5) * CHUNK
	map.stroke(brush(GrassBrush.TOOL_HEIGHT, 4.0, {target = 0.5}), place, place)


func test_one_more_chunk_uploads_about_one_chunk_a_frame() -> void:
	var map := full_map()
	for z in SIDE:
		for x in SIDE:
			paint_chunk(map, x - SIDE / 2, z - SIDE / 2)
	var field := add_field({size = CHUNK * (SIDE + 2) * Vector2.ONE, density = 1.0, map = map})
	await seen()
	await grown(field)
	assert_eq(map.get_chunks().size(), SIDE * SIDE)
	var before: int = field.get_counters().map_bytes
	var memory: int = field.get_statistics().memory
	paint_chunk(map, SIDE / 2, 0)
	var most := 0
	var last := before
	for frame in FRAMES:
		await frames(1)
		most = maxi(most, field.get_counters().map_bytes - last)
		last = field.get_counters().map_bytes
		if field.get_statistics().memory > memory + SIDE * SIDE * LAYER / 2:
			break
	assert_greater(field.get_statistics().memory, memory + SIDE * SIDE * LAYER / 2, "there is room")
	assert_less(most, 3 * LAYER, "bytes in a frame")
	paint_chunk(map, SIDE / 2, 1)
	await frames(3)
	assert_greater(field.get_counters().map_bytes - before, LAYER / 2, "the new chunk's own")
	assert_less(field.get_counters().map_bytes - before, 8 * LAYER, "and in all")
	assert_near(field.map.sample(GrassMap.CHANNEL_HEIGHT, Vector2(SIDE / 2 + 0.5, 0.5) * CHUNK), 0.5, 0.01)
