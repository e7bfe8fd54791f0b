# SPDX-License-Identifier: MIT
## Grass that is not the same everywhere: tussocks, hues, lower borders; leaves that are not flat plates.
extends "res://tests/species_case.gd"


func light_of(image: Image) -> Color:
	var sum := Color(0, 0, 0, 0)
	for y in image.get_height():
		for x in image.get_width():
			sum += image.get_pixel(x, y).srgb_to_linear()
	return sum / (image.get_width() * image.get_height())


func spread(values: Array[float]) -> float:
	var middle: float = values.reduce(func(sum: float, value: float) -> float: return sum + value, 0.0) / values.size()
	return sqrt(values.reduce(func(sum: float, value: float) -> float: return sum + (value - middle) ** 2.0, 0.0) / values.size())


## Returns how much the share of blue in green differs from block to block of a picture.
func spread_of_hues(image: Image) -> float:
	var hues: Array[float] = []
	for y in 8:
		for x in 8:
			var light := light_of(image.get_region(Rect2i(x * SIDE / 8, y * SIDE / 8, SIDE / 8, SIDE / 8)))
			hues.append(light.b / light.g)
	return spread(hues) / (hues.reduce(func(sum: float, value: float) -> float: return sum + value, 0.0) / hues.size())


func test_hues_differ_from_clump_to_clump_and_not_in_the_mean() -> void:
	var species := make(1.0, Color(0.3, 0.5, 0.2))
	var field := add_seen_field({size = Vector2(24, 24), species = [species], clump_size = 2.0, clump_tint = 0.0})
	camera.fov = 40.0
	for height: float in [25.0, 250.0]:  # blades, and ground that represents them
		camera.far = 2.0 * height
		camera.fov = rad_to_deg(2.0 * atan(8.0 / height))
		look(Vector3(0, height, 0.1), Vector3.ZERO)
		species.hue_variation = 0.0
		await grown(field)
		var even := await picture()
		species.hue_variation = 1.0
		await grown(field)
		var varied := await picture()
		save(varied, "hues_%d" % height)
		print("    %d m: hues spread by %.3f, %.3f without" % [height, spread_of_hues(varied), spread_of_hues(even)])
		assert_greater(spread_of_hues(varied), 1.5 * spread_of_hues(even) + 0.05)
		for channel in 3:
			assert_near(light_of(varied)[channel] / light_of(even)[channel], 1.0, 0.08, "channel %d of the mean" % channel)


## Returns how much the share of the picture in which nothing grows differs from block to block, of about half a tussock.
func spread_of_gaps(image: Image) -> float:
	var shares: Array[float] = []
	for y in range(0, SIDE, 16):
		for x in range(0, SIDE, 16):
			shares.append(share_of(image.get_region(Rect2i(x, y, 16, 16)), func(color: Color) -> bool: return color.b > color.g))
	return spread(shares)


func test_ground_is_seen_between_tussocks() -> void:
	var species := make(1.0, Color(0.3, 0.5, 0.2))
	var field := add_seen_field({size = Vector2(6, 6), density = 200.0, species = [species], soil_enabled = false})
	camera.fov = 30.0
	look(Vector3(0, 8, 0.01), Vector3.ZERO)
	var gaps: Array[float] = []
	for share: float in [0.0, 1.0]:
		species.tussock_share = share
		await grown(field)
		var image := await picture()
		save(image, "tussocks_%d" % share)
		gaps.append(spread_of_gaps(image))
	print("    gaps differ by %s" % [gaps])
	assert_greater(gaps[1], 1.12 * gaps[0])


func test_an_awake_tile_with_tussocks_is_drawn_as_it_was_asleep() -> void:
	var first := make(0.5, Color(0.3, 0.5, 0.2), {tussock_share = 0.7})
	var second := make(0.5, Color(0.5, 0.5, 0.2), {tussock_share = 1.0, tussock_blades = 32})
	var field := add_seen_field({size = Vector2(8, 8), species = [first, second], sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 5.0})
	await assert_waking_is_not_seen(field)


## Its leaves lie in the shadows of the stalks around, which are finer than a shadow map; in the mean they are as light with it as without.
func test_leaves_in_a_low_sun_have_no_dots() -> void:
	var leafy := make(1.0, Color(0.3, 0.5, 0.2), {length_min = 0.1, length_max = 0.2, width_min = 0.003, width_max = 0.003})
	leafy.leaf = flower(Color(0.8, 0.8, 0.8))
	leafy.leaf_size = 0.06
	var field := add_seen_field({size = Vector2(4, 4), density = 700.0, species = [leafy], soil_enabled = false})
	field.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_ON
	var sun := viewport.get_child(1) as DirectionalLight3D
	sun.rotation_degrees = Vector3(-8, 40, 0)
	camera.fov = 30.0
	look(Vector3(0, 2.0, 2.0), Vector3.ZERO)
	await grown(field)
	var without := await picture()
	sun.shadow_enabled = true
	await drawn()
	var with := await picture()
	save(with, "leaves_low_sun")
	var off := difference(without, with)
	print("    shadows change pixels by %.5f" % off.y)
	# 0.00037; 0.00051 if leaves look their shadows up where they are, as they do in Compatibility.
	assert_less(off.y, 0.0006 if RenderingServer.get_current_rendering_method() == "gl_compatibility" else 0.00044)
	assert_near(light_of(with).g / light_of(without).g, 1.0, 0.06)


## Light is not the same all over a leaf.
func test_leaves_are_folded() -> void:
	var leafy := make(1.0, Color(0.3, 0.5, 0.2), {length_min = 0.1, length_max = 0.1, width_min = 0.001, width_max = 0.001})
	leafy.patch.weight_arched = 0.0
	leafy.patch.weight_drooping = 0.0
	leafy.patch.weight_wavy = 0.0
	leafy.leaf = flower(Color(0.8, 0.8, 0.8))
	leafy.leaf_size = 0.2
	var even := {clump_tint = 0.0, clump_lean = 0.0, soil_enabled = false, border_fade = 0.0}
	var field := add_seen_field({size = Vector2(1, 1), density = 20.0, species = [leafy]}.merged(even))
	camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	camera.size = 1.0
	look(Vector3(0, 3, 0), Vector3.ZERO)
	await grown(field)
	var image := await picture()
	save(image, "folded")
	# From one pixel to the one beside it on the same leaf light changes little by little, where a flat leaf has one light.
	var shaded := 0
	var inside := 0
	for y in range(0, SIDE, 2):
		for x in range(0, SIDE - 6, 2):
			var here := image.get_pixel(x, y)
			var beside := image.get_pixel(x + 6, y)
			if here.g > here.b and beside.g > beside.b:
				inside += 1
				shaded += int(absf(here.g - beside.g) > 0.003)
	print("    %d of %d pixels inside of leaves differ from those beside them" % [shaded, inside])
	assert_greater(inside, 1000)
	assert_greater(float(shaded) / inside, 0.25)
