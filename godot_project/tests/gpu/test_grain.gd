# SPDX-License-Identifier: MIT
## Far grass has no grain: when the camera moves by parts of a pixel, pixels change hardly more than in a picture with 16 samples a pixel,
## and a pixel differs from the one beside it hardly more than there.
extends "res://tests/light_case.gd"

const SMALL := Vector2i(160, 90)
const SHIFTS: Array[Vector2] = [Vector2(0, 0), Vector2(0.5, 0.25), Vector2(0.25, 0.75), Vector2(0.75, 0.5)]  # pixels
## Eye, and what it looks at.
const VIEWS := {above = [Vector3(0, 60, 0.1), Vector3.ZERO], far = [Vector3(0, EYE, 100), Vector3(0, 0.3, -30)]}


## Of a picture that has as many pixels a metre as a full HD picture of 60 degrees: 9.4 from 60 m.
func full_hd() -> float:
	return rad_to_deg(2.0 * atan(tan(deg_to_rad(30.0)) * SMALL.y / 1080.0))


## Mean over the pixels of the variance of each over SHIFTS, in linear light, as a share of the squared mean; and the mean. finer: samples
## of a pixel along a side.
func grain(view: String, finer: int) -> Vector2:
	viewport.size = SMALL * finer
	viewport.msaa_3d = Viewport.MSAA_DISABLED if finer > 1 else Viewport.MSAA_4X
	var pixel := deg_to_rad(camera.fov) / SMALL.y
	var sums := PackedFloat64Array()
	var squares := PackedFloat64Array()
	sums.resize(SMALL.x * SMALL.y)
	squares.resize(SMALL.x * SMALL.y)
	for shift in SHIFTS:
		look(VIEWS[view][0], VIEWS[view][1])
		camera.rotate_object_local(Vector3.UP, shift.x * pixel)
		camera.rotate_object_local(Vector3.RIGHT, shift.y * pixel)
		var image := await picture() if shift == SHIFTS[0] else await next_picture()
		var lights := lights_of(image, finer)
		for i in lights.size():
			sums[i] += lights[i] / SHIFTS.size()
			squares[i] += lights[i] * lights[i] / SHIFTS.size()
	var mean := 0.0
	var variance := 0.0
	for i in sums.size():
		mean += sums[i] / sums.size()
		variance += (squares[i] - sums[i] * sums[i]) / sums.size()
	return Vector2(variance / (mean * mean), mean)


## Luminances of the pixels, each the mean of finer x finer.
func lights_of(image: Image, finer: int) -> PackedFloat64Array:
	var lights := PackedFloat64Array()
	lights.resize(SMALL.x * SMALL.y)
	for y in SMALL.y * finer:
		for x in SMALL.x * finer:
			lights[y / finer * SMALL.x + x / finer] += image.get_pixel(x, y).srgb_to_linear().get_luminance() / (finer * finer)
	return lights


func test_far_grass_has_no_grain() -> void:
	add_even_field()
	set_light("side")
	for view: String in VIEWS:
		camera.fov = full_hd()
		var plain := await grain(view, 1)
		var sampled := await grain(view, 4)
		print("    %s: variance %.5f, of 16 samples %.5f: %.2f times" % [view, plain.x, sampled.x, plain.x / sampled.x])
		print("    as light as %.2f of it" % [plain.y / sampled.y])
		assert_less(plain.x, 1.25 * sampled.x, view)
		assert_near(plain.y / sampled.y, 1.0, 0.05, view)


## Variance of a pixel from the one beside it, as a share of the squared mean; and the mean. finer: as above.
func roughness(finer: int) -> Vector2:
	viewport.size = SMALL * finer
	viewport.msaa_3d = Viewport.MSAA_DISABLED if finer > 1 else Viewport.MSAA_4X
	var lights := lights_of(await picture(), finer)
	var mean := 0.0
	var variance := 0.0
	for i in lights.size():
		mean += lights[i] / lights.size()
		if (i + 1) % SMALL.x > 0:
			variance += 0.5 * (lights[i] - lights[i + 1]) ** 2 / lights.size()
	return Vector2(variance / (mean * mean), mean)


## Compares pictures of what the camera sees now, without and with 16 samples a pixel.
func assert_is_like_sixteen_samples(words: String) -> void:
	var plain := await roughness(1)
	var sampled := await roughness(4)
	var rougher := sqrt(plain.x / sampled.x)
	var forward := RenderingServer.get_current_rendering_method() != "gl_compatibility"
	print("    %s: %.2f times as rough as 16 samples, %.3f of their light" % [words, rougher, plain.y / sampled.y])
	assert_less(rougher, 1.2, words)
	assert_near(plain.y / sampled.y, 1.0, 0.065 if forward else 0.085, words)


## A field whose ground rises evenly along -z, by `rise` metres a metre.
func add_slope(rise: float) -> GrassField:
	var heights := Image.create_empty(161, 161, false, Image.FORMAT_RF)
	for z in 161:
		for x in 161:
			heights.set_pixel(x, z, Color(rise * (40.0 - 0.5 * z), 0, 0))
	var map := GrassMap.new()
	map.base_density = 1.0
	map.set_ground(heights, Rect2(-40.25, -40.25, 80.5, 80.5))
	var field := add_even_field()
	field.size = Vector2(80, 80)
	field.map = map
	return field


## Blades have the colour of the ground between them, for an eye that sees both steeply.
func test_a_slope_far_away_has_no_specks() -> void:
	var field := add_slope(0.6)
	await grown(field)
	for light: String in ["side", "front"]:
		set_light(light)
		for distance: float in [60.0, 120.0]:
			camera.fov = full_hd()
			look(Vector3(0, 3, distance), Vector3.ZERO)
			await assert_is_like_sixteen_samples("sun: %s, %d m" % [light, distance])


func test_grass_from_above_is_as_light_as_all_of_its_blades() -> void:
	add_even_field()
	for light: String in ["sky", "side"]:
		set_light(light)
		for eye: Vector3 in [Vector3(0, 25, 0.1), Vector3(0, 60, 0.1), Vector3(0, 40, 24), Vector3(0, 25, 60)]:
			camera.fov = full_hd()
			look(eye, Vector3.ZERO)
			await assert_is_like_sixteen_samples("sun: %s, from %s" % [light, eye])
