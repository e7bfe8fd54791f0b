# SPDX-License-Identifier: MIT
## The look of a field with a map: grass where it was painted, on hills, cut and tinted; the same on both backends.
extends "res://tests/view_case.gd"

const SIZE := Vector2i(480, 270)


func before() -> void:
	open_view(SIZE)
	add_light()


## Hills, a path that is trampled bare, a mown square, a red patch, and grass combed aside.
func meadow() -> GrassMap:
	var map := full_map()
	var hills := FastNoiseLite.new()
	hills.frequency = 0.06
	var heights := Image.create_empty(32, 32, false, Image.FORMAT_RF)
	for x in 32:
		for z in 32:
			heights.set_pixel(x, z, Color(1.5 * hills.get_noise_2d(x, z), 0, 0))
	map.set_ground(heights, Rect2(-16, -16, 32, 32))
	map.stroke(brush(GrassBrush.TOOL_FLATTEN, 0.8), Vector2(-9, -6), Vector2(9, 2))
	map.stroke(brush(GrassBrush.TOOL_CUT, 1.5, {cut_height = 0.08}), Vector2(-3, 4), Vector2(0, 4))
	map.stroke(brush(GrassBrush.TOOL_TINT, 2.5, {color = Color(0.8, 0.1, 0.1)}), Vector2(4, 5), Vector2(4, 5))
	map.stroke(brush(GrassBrush.TOOL_COMB, 2.0), Vector2(-6, 1), Vector2(-5, 1))
	return map


func test_both_backends_draw_the_map_alike() -> void:
	var field := add_seen_field({map = meadow(), size = Vector2(18, 18)})
	look(Vector3(0, 4.5, 12), Vector3(0, 0, 1))
	var gpu := await picture()
	save(gpu, "map_gpu")
	field.backend = GrassField.BACKEND_CPU
	var cpu := await picture()
	save(cpu, "map_cpu")
	var off := difference(gpu, cpu)
	print("    GPU against CPU backend: mean difference %.5f" % off.y)
	assert_less(off.y, 0.003)
	assert_greater(share_of(gpu, is_red), 0.01, "the tint is seen")


func test_only_painted_tiles_are_drawn() -> void:
	var field := add_seen_field({map = GrassMap.new(), size = Vector2(8, 8), soil_enabled = true})
	look(Vector3(0, 8, 0), Vector3.ZERO)
	var sky := await picture()
	await drawn()
	assert_eq(field.get_statistics().drawn_tiles, 0)
	assert_less(difference(await next_picture(), sky).x, 0.01, "no soil either")
	field.map.stroke(brush(GrassBrush.TOOL_PAINT, 1.5), Vector2(2, 0), Vector2(2, 0))
	await drawn()
	var painted := await next_picture()
	assert_eq(field.get_statistics().drawn_tiles, field.get_blade_count() / 64 - field.get_counters().bare_tiles)
	var right := painted.get_region(Rect2i(SIZE.x / 2, 0, SIZE.x / 2, SIZE.y))
	var left := painted.get_region(Rect2i(0, 0, SIZE.x / 2, SIZE.y))
	var is_grown := func(color: Color) -> bool: return color.b < maxf(color.r, color.g)  # blades or soil, not sky
	assert_greater(share_of(right, is_grown), 0.05)
	assert_eq(share_of(left, is_grown), 0.0)
	var culls: int = field.get_counters().culls
	await drawn()
	assert_eq(field.get_counters().culls, culls, "nothing changed, nothing culled")


func test_a_hill_is_culled_where_it_stands() -> void:
	var map := full_map()
	var heights := Image.create_empty(4, 4, false, Image.FORMAT_RF)
	heights.fill(Color(30, 0, 0))
	map.set_ground(heights, Rect2(-8, -8, 16, 16))
	var field := add_seen_field({map = map, size = Vector2(4, 4)})
	look(Vector3(0, 31.5, 3.5), Vector3(0, 30, 0))
	await drawn()
	assert_greater(field.get_statistics().drawn_tiles, 20)
	assert_greater(share_of(await next_picture(), is_green), 0.1)
	look(Vector3(0, 1.5, 3.5), Vector3(0, 0, 0))
	await drawn()
	assert_eq(field.get_statistics().drawn_tiles, 0)
	assert_less(share_of(await next_picture(), is_green), 0.001)


func test_blades_are_drawn_as_they_follow_the_slope() -> void:
	var field := add_seen_field({map = meadow(), follow_slope = 0.0})
	look(Vector3(0, 1.2, 3.2), Vector3(0, 0.2, 0))
	var upright := await picture()
	field.follow_slope = 1.0
	assert_greater(difference(upright, await picture()).y, 0.01)


func test_an_awake_tile_with_a_map_is_drawn_as_it_was_asleep() -> void:
	var field := add_seen_field({map = meadow(), sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 5.0, sparse_height = 0.3})
	field.map.base_density = 0.4
	field.map.set_ground(Image.create_empty(2, 2, false, Image.FORMAT_RF), Rect2(-16, -16, 32, 32))
	await assert_waking_is_not_seen(field)


## Blades as short as mown ones that nobody cut end in green tips.
func test_mown_blades_end_in_a_pale_cut() -> void:
	var pale := func(color: Color) -> bool: return color.g > 0.2 and color.g > color.b
	var blue := GrassSpecies.new()
	blue.root_color = Color(0.02, 0.02, 0.5)
	blue.tip_color = blue.root_color
	blue.dry = 0.0
	var shares := PackedFloat32Array()
	for tool: int in [GrassBrush.TOOL_CUT, GrassBrush.TOOL_HEIGHT]:
		var map := full_map()
		var settings := {cut_height = 0.08, target = 0.2, strength = 1.0, hardness = 1.0}
		map.stroke(brush(tool, 3.0, settings), Vector2.ZERO, Vector2.ZERO)
		var field := add_seen_field({size = Vector2(8, 8), density = 1000.0, map = map, species = [blue], soil_color = blue.root_color})
		await grown(field)
		look(Vector3(0, 0.25, 0.45), Vector3(0, 0.03, 0))
		var image := await picture()
		save(image, "mown_close" if tool == GrassBrush.TOOL_CUT else "short_close")
		shares.append(share_of(image.get_region(Rect2i(0, SIZE.y / 2, SIZE.x, SIZE.y / 2)), pale))
		field.free()
	print("    pale: %.4f of the mown, %.4f of the short" % [shares[0], shares[1]])
	assert_greater(shares[0], 0.0004)
	assert_less(shares[1], 0.2 * shares[0])


## The map's textures grow with the 33rd chunk. Compatibility uploads them on the thread of the frames, an array a frame; elsewhere another
## thread does. What was drawn stays until all of them are there.
func test_textures_grow_beside_the_frames() -> void:
	const LAYERS := 64  # that there is room for then
	const LARGEST := 4 * 128 * 128  # bytes of a layer in the largest array
	const LAYER := 4 * (128 * 128 + 3 * 64 * 64)  # in all arrays
	var map := full_map()
	var dot := brush(GrassBrush.TOOL_HEIGHT, 4.0, {target = 0.5})
	for n in 32:
		var place := 64.0 * Vector2(n % 8 - 4 + 0.5, n / 8 - 4 + 0.5)
		map.stroke(dot, place, place)
	var field := add_seen_field({size = 64.0 * 10 * Vector2.ONE, density = 1.0, map = map})
	look(Vector3(32, 6, -20), Vector3(32, 0, -32))  # a dot
	await drawn()
	var before: int = field.get_counters().map_bytes
	var memory: int = field.get_statistics().memory
	var picture_before := await next_picture()
	map.stroke(dot, Vector2(32, 224), Vector2(32, 224))
	var most := 0
	var last := before
	var is_there := false
	for frame in 600:
		await RenderingServer.frame_post_draw
		is_there = field.get_statistics().memory > memory + 16 * LAYER
		most = maxi(most, field.get_counters().map_bytes - last)
		last = field.get_counters().map_bytes
		if frame % 8 == 0 or is_there:
			assert_less(difference(viewport.get_texture().get_image(), picture_before).x, 0.01, "as before, frame %d" % frame)
		if is_there:
			break
	var all := last - before
	print("    %d bytes uploaded by frames, %d in one of them at most" % [all, most])
	assert_true(is_there, "there is room")
	assert_less(most, LAYERS * LARGEST + 2 * LAYER, "bytes in a frame")
	if not RenderingServer.get_rendering_device():
		assert_greater(all, LAYERS * LAYER - 1, "all of it is counted")
	else:
		assert_less(all, 4 * LAYER, "the new chunk's alone")
