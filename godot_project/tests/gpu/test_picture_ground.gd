# SPDX-License-Identifier: MIT
## The ground between blades: soil, moss and dead blades near the eye, the same colour without them far away, textures of the user's.
extends "res://tests/view_case.gd"

const SIZE := Vector2i(192, 108)
const HIGH := 150.0  # metres, of the camera

var sun: DirectionalLight3D


func before() -> void:
	open_view(SIZE)
	add_light()
	camera.far = 200.0
	camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	sun = viewport.get_child(1) as DirectionalLight3D


## Hardly a blade stands on it.
func add_ground(properties := {}) -> GrassField:
	var field := add_seen_field({size = Vector2(60, 60), density = 1.0, clump_tint = 0.0}.merged(properties))
	await grown(field)
	return field


## From so high that all of it is seen from above.
func look_at_ground(x: float) -> void:
	look(Vector3(x, HIGH, 0), Vector3(x, 0, 0))
	camera.near = HIGH - 0.02


## A picture of a place that is `metres` high, from above; of what lies on the ground only, since blades are beyond the camera's near plane.
func ground_picture(metres: float) -> Image:
	camera.size = metres
	look_at_ground(0.0)
	return await picture()


func light(image: Image) -> Color:
	var sum := Color(0, 0, 0, 0)
	for y in image.get_height():
		for x in image.get_width():
			sum += image.get_pixel(x, y).srgb_to_linear()
	return sum / (image.get_width() * image.get_height())


## Returns how much the light of pixels differs, as a share of their mean.
func contrast(image: Image) -> float:
	var mean_light := light(image).get_luminance()
	var sum := 0.0
	for y in image.get_height():
		for x in image.get_width():
			sum += (image.get_pixel(x, y).srgb_to_linear().get_luminance() - mean_light) ** 2.0
	return sqrt(sum / (image.get_width() * image.get_height())) / mean_light


func test_sparse_grass_stands_on_soil_and_litter_not_on_a_green_carpet() -> void:
	await add_ground()
	var bare := light(await ground_picture(2.0))
	print("    sparse: %s" % bare)
	assert_greater(bare.r, bare.g, "earth is not green")


## Returns the mean light and the greatest contrast of four pictures, the first from `height` metres, each next one `step` higher.
func near_ground(height: float, step: float) -> Dictionary:
	var mean := Color(0, 0, 0, 0)
	var most := 0.0
	for n in 4:
		var image := await ground_picture(height + step * n)
		most = maxf(most, contrast(image))
		mean += 0.25 * light(image)
	return {light = mean, contrast = most}


## The mean of the ground is the same however many pixels show it, so that nothing shimmers and no line is seen.
func test_ground_has_the_same_mean_near_and_far() -> void:
	await add_ground()
	var seen := await near_ground(0.5, 0.2)
	var near: Color = seen.light
	var most: float = seen.contrast
	save(await ground_picture(0.5), "ground_near")
	var far_picture := await ground_picture(30.0)
	save(far_picture, "ground_far")
	var far := light(far_picture)
	print("    near %s with a contrast of %.2f, far %s with %.2f" % [near, most, far, contrast(far_picture)])
	assert_greater(most, 0.3, "strands and shade near the eye")
	assert_less(contrast(far_picture), 0.1, "no pixel differs from those beside it far away")
	for channel in 3:
		assert_near(far[channel] / near[channel], 1.0, 0.12, "channel %d" % channel)


func test_a_path_is_earth_where_the_field_has_bare_soil() -> void:
	var field := await add_ground({map = full_map()})
	field.paint(brush(GrassBrush.TOOL_ERASE, 16.0), Vector3(-9, 0, 0), Vector3(9, 0, 0))
	camera.size = 2.0
	var floor_below := light(await ground_picture(2.0))
	field.bare_soil = 1.0
	var seen := await near_ground(0.6, 0.3)
	var near: Color = seen.light
	var most: float = seen.contrast
	save(await ground_picture(1.0), "path_near")
	var far := light(await ground_picture(14.0))
	print("    floor %s, path near %s with a contrast of %.2f, far %s" % [floor_below, near, most, far])
	assert_greater(floor_below.b, 2.0 * floor_below.r, "without it nothing covers the blue below the field")
	assert_greater(near.r, 1.2 * near.b, "earth is brown")
	assert_greater(most, 0.2, "crumbs and stones near the eye")
	for channel in 3:
		assert_near(far[channel] / near[channel], 1.0, 0.12, "channel %d" % channel)


func test_soil_shows_the_textures_of_the_user() -> void:
	var field := await add_ground()
	var plain := light(await ground_picture(2.0))
	var blue := Image.create_empty(4, 4, true, Image.FORMAT_RGB8)
	blue.fill(Color(0.1, 0.1, 0.9))
	field.soil_albedo = ImageTexture.create_from_image(blue)
	var colored := light(await ground_picture(2.0))
	assert_greater(colored.b, 3.0 * plain.b, "the colour")
	var aslant := Image.create_empty(4, 4, true, Image.FORMAT_RGB8)
	aslant.fill(Color(0.5 + 0.35, 0.5, 0.85))  # its x turns to +x
	field.soil_normal = ImageTexture.create_from_image(aslant)
	sun.rotation_degrees = Vector3(-30, 90, 0)  # light from +x
	var towards := light(await ground_picture(2.0))
	sun.rotation_degrees = Vector3(-30, -90, 0)
	var away := light(await ground_picture(2.0))
	print("    plain %s, blue %s, turned to the sun %s, away %s" % [plain, colored, towards, away])
	assert_greater(towards.b, 1.5 * away.b, "the normal")
	field.soil_normal = null
	sun.rotation_degrees = Vector3(-85, -90, 0)  # an eye above sees its light mirrored
	var dull := await ground_picture(2.0)
	var smooth := Image.create_empty(4, 4, true, Image.FORMAT_RGB8)
	smooth.fill(Color(0.1, 0.1, 0.1))
	field.soil_roughness = ImageTexture.create_from_image(smooth)
	assert_greater(difference(dull, await ground_picture(2.0)).y, 0.002, "the roughness")
	field.soil_albedo = null
	field.soil_roughness = null
	sun.rotation_degrees = Vector3(-50, 30, 0)
	assert_near(light(await ground_picture(2.0)).g / plain.g, 1.0, 0.01, "none of them")


func test_textures_of_soil_repeat_every_soil_scale_metres() -> void:
	var halves := Image.create_empty(64, 64, false, Image.FORMAT_RGB8)
	for x in 64:
		for y in 64:
			halves.set_pixel(x, y, Color(0.9, 0.1, 0.1) if x < 32 else Color(0.1, 0.1, 0.9))
	var field := await add_ground({soil_scale = 8.0, soil_albedo = ImageTexture.create_from_image(halves)})
	var reds: Array[bool] = []
	for scale: float in [8.0, 4.0]:
		field.soil_scale = scale
		camera.size = 0.5
		for x: float in [1.0, 3.0]:
			look_at_ground(x)
			var here := light(await picture())
			reds.append(here.r > here.b)
	assert_eq(reds, [true, true, true, false] as Array[bool])
