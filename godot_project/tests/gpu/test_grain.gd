# SPDX-License-Identifier: MIT
## Far grass has no grain: when the camera moves by parts of a pixel, pixels change hardly more than in a picture with 16 samples a pixel.
extends "res://tests/light_case.gd"

const SMALL := Vector2i(160, 90)
const SHIFTS: Array[Vector2] = [Vector2(0, 0), Vector2(0.5, 0.25), Vector2(0.25, 0.75), Vector2(0.75, 0.5)]  # pixels
## Eye, and what it looks at.
const VIEWS := {above = [Vector3(0, 60, 0.1), Vector3.ZERO], far = [Vector3(0, EYE, 100), Vector3(0, 0.3, -30)]}


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
		# As many pixels a metre as in a full HD picture of 60 degrees: 9.4 from 60 m.
		camera.fov = rad_to_deg(2.0 * atan(tan(deg_to_rad(30.0)) * SMALL.y / 1080.0))
		var plain := await grain(view, 1)
		var sampled := await grain(view, 4)
		print("    %s: variance %.5f, of 16 samples %.5f: %.2f times" % [view, plain.x, sampled.x, plain.x / sampled.x])
		print("    as light as %.2f of it" % [plain.y / sampled.y])
		assert_less(plain.x, 1.25 * sampled.x, view)
		assert_near(plain.y / sampled.y, 1.0, 0.05, view)
