# SPDX-License-Identifier: MIT
## No blade shows a colour that it does not have. A triangle smaller than a pixel covers few of its samples; an attribute interpolated at
## the pixel's centre is then extrapolated far beyond the values at its corners.
extends "res://tests/view_case.gd"

const SIZE := Vector2i(720, 720)
const HEIGHT := 60.0  # metres
const PIXELS_A_METRE := 11.7  # of a full HD picture from there


func before() -> void:
	open_view(SIZE)
	add_light()
	camera.fov = rad_to_deg(2.0 * atan(0.5 * SIZE.y / PIXELS_A_METRE / HEIGHT))
	look(Vector3(0, HEIGHT, 0.1), Vector3.ZERO)


func test_from_above_no_pixel_is_brighter_than_a_blade() -> void:
	add_seen_field({size = Vector2(64, 64), density = 256.0})
	await drawn()
	viewport.msaa_3d = Viewport.MSAA_DISABLED
	var picture_of_it := await picture()
	assert_greater(share_of(picture_of_it, is_green), 0.3, "grass")
	var plain := brightest(picture_of_it)
	viewport.msaa_3d = Viewport.MSAA_4X
	var sampled := brightest(await picture())
	print("    brightest without MSAA %.3f, with it %.3f" % [plain, sampled])
	assert_less(sampled, plain + 0.07)  # white, where something is extrapolated


## Some blades are dry all along. Where each is as wide as a pixel, they would dot the ground, which has the colour of all.
func test_from_above_no_dry_blade_is_a_dot() -> void:
	var species := GrassSpecies.new()
	species.patch = GrassPatch.new()
	species.root_color = Color(0.2, 0.35, 0.1)
	species.tip_color = Color(0.2, 0.35, 0.1)
	species.dry_color = Color(0.9, 0.8, 0.5)
	species.dry = 0.6
	add_seen_field({size = Vector2(64, 64), density = 256.0, clump_tint = 0.0, species = [species]})
	var contrast := contrast_of(await picture())
	print("    contrast %.3f" % contrast)
	assert_less(contrast, 0.3)


## Returns the standard deviation of the pixels' light in the middle of a picture, as a share of the mean.
func contrast_of(image: Image) -> float:
	var sum := 0.0
	var squares := 0.0
	for y in range(SIZE.y / 4, SIZE.y * 3 / 4):
		for x in range(SIZE.x / 4, SIZE.x * 3 / 4):
			var light := image.get_pixel(x, y).srgb_to_linear().get_luminance()
			sum += light
			squares += light * light
	var mean_light := sum / (SIZE.x * SIZE.y / 4)
	return sqrt(maxf(squares / (SIZE.x * SIZE.y / 4) - mean_light * mean_light, 0.0)) / mean_light


func brightest(image: Image) -> float:
	var most := 0.0
	for y in image.get_height():
		for x in image.get_width():
			most = maxf(most, image.get_pixel(x, y).get_luminance())
	return most
