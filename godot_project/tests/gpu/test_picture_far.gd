# SPDX-License-Identifier: MIT
## Beyond the last blades the ground has their colour, in any light and without a visible line. Runs in every renderer.
extends "res://tests/view_case.gd"

const SIZE := Vector2i(96, 54)
const FINER := 8  # times as many pixels a side show all blades of what SIZE shows by the ground alone
const FRONT := Vector3(-35, 180, 0)  # rotations of the sun, for a camera that looks along -z
const SIDE := Vector3(-50, 90, 0)
const BACK := Vector3(-25, 0, 0)

var sun: DirectionalLight3D


func before() -> void:
	open_view(SIZE)
	add_light()
	camera.far = 1000.0
	camera.fov = 30.0
	sun = viewport.get_child(1) as DirectionalLight3D


func full_picture(size: Vector2i) -> Image:
	viewport.size = size
	picture_size = size
	return await picture()


## Mean light of the rows from `begin` to before `end`, and of all columns.
func light_of(image: Image, begin: int, end: int) -> Color:
	var sum := Color(0, 0, 0, 0)
	for y in range(begin, end):
		for x in image.get_width():
			sum += image.get_pixel(x, y).srgb_to_linear()
	return sum / ((end - begin) * image.get_width())


## A field that is seen under `elevation` degrees, by a camera so far away that all of it is as large in the picture.
func look_under(elevation: float) -> void:
	var angle := deg_to_rad(elevation)
	camera.fov = minf(30.0, 0.75 * elevation)
	look(8.0 / tan(deg_to_rad(0.5 * camera.fov)) * Vector3(0, sin(angle), cos(angle)), Vector3.ZERO)


## Returns pictures of `size` as they are now, one for each of the sun's rotations: the same blades are drawn in all of them.
func pictures_in(lights: Array[Vector3], size: Vector2i) -> Array[Image]:
	viewport.size = size
	picture_size = size
	sun.rotation_degrees = lights[0]
	var images: Array[Image] = [await picture()]
	for light in lights.slice(1):
		sun.rotation_degrees = light
		images.append(await next_picture())
	await frames(1)  # for the GPU's counts
	return images


## By a picture with so many pixels that every blade is drawn, and one with so few that none is. All of them in Forward+: that other
## renderers show the same colours is for test_picture_light.
func assert_ground_is_like_blades(field: GrassField, name: String, most: float, elevations: Array[float], lights: Array[Vector3]) -> void:
	var shows_all := RenderingServer.get_current_rendering_method() == "forward_plus"
	var chosen := lights if shows_all else lights.slice(0, 1)
	for elevation in elevations if shows_all else elevations.slice(0, 1):
		look_under(elevation)
		var fine := await pictures_in(chosen, FINER * SIZE)
		var drawn_blades: int = field.get_statistics().drawn_blades
		var coarse := await pictures_in(chosen, SIZE)
		assert_less(field.get_statistics().drawn_blades, 0.05 * drawn_blades)
		for i in chosen.size():
			var blades := light_of(fine[i], 0, fine[i].get_height()).linear_to_srgb()
			var ground := light_of(coarse[i], 0, SIZE.y).linear_to_srgb()
			var text := "%s, %d degrees, sun %s: %s as blades, %s as ground" % [name, elevation, chosen[i], blades, ground]
			print("    ", text)
			assert_near(ground.g / blades.g, 1.0, most, text)
			assert_near(ground.r / blades.r, 1.0, most, text)


func test_the_ground_has_the_colour_of_the_blades() -> void:
	var field := add_seen_field({size = Vector2(100, 100), wind_speed = 5.0})
	await grown(field)
	await assert_ground_is_like_blades(field, "meadow", 0.1, [12.0, 25.0, 60.0], [FRONT, SIDE, BACK])


## Each over all of the field: paint, wear, and mown grass.
func test_the_ground_has_what_was_painted() -> void:
	var field := add_seen_field({size = Vector2(100, 100)})
	for tool: Array in [
		["tinted", GrassBrush.TOOL_TINT, {color = Color(0.7, 0.2, 0.6), strength = 0.8}],
		["worn", GrassBrush.TOOL_FLATTEN, {strength = 0.5}],
		["mown", GrassBrush.TOOL_CUT, {cut_height = 0.2}],
	]:
		field.map = full_map()
		field.map.stroke(brush(tool[1], 90.0, tool[2]), Vector2.ZERO, Vector2.ZERO)
		await grown(field)
		await assert_ground_is_like_blades(field, tool[0], 0.15, [12.0, 60.0], [FRONT, BACK])


func test_the_ground_has_the_mix_of_species() -> void:
	var dark := GrassSpecies.new()
	dark.root_color = Color(0.1, 0.2, 0.3)
	dark.tip_color = Color(0.2, 0.3, 0.5)
	dark.share = 0.3
	var field := add_seen_field({size = Vector2(100, 100), species = [GrassSpecies.new(), dark]})
	await grown(field)
	await assert_ground_is_like_blades(field, "two species", 0.12, [12.0, 60.0], [FRONT, BACK])


## The band of the picture in which blades end, and what lies before and behind it. Without clumps and wind, whose patches are no smaller.
func test_there_is_no_line_where_blades_end() -> void:
	var field := add_seen_field({size = Vector2(200, 200), clump_tint = 0.0, clump_height = 0.0})
	await grown(field)
	camera.fov = 75.0
	look(Vector3(0, 20, 95), Vector3(0, 10, 75))
	for light: Array in [["front", FRONT], ["back", BACK]]:
		sun.rotation_degrees = light[1]
		var image := await full_picture(Vector2i(480, 270))
		save(image, "far_%s" % light[0])
		assert_greater(field.get_statistics().drawn_tiles, 500, "blades near the eye")
		assert_less(field.get_statistics().drawn_tiles, field.get_blade_count() / 64 / 5.0, "none far away")
		var most := 0.0
		var before := light_of(image, 110, 120).get_luminance()
		for y in range(120, 260, 10):
			var here := light_of(image, y, y + 10).get_luminance()
			most = maxf(most, absf(here / before - 1.0))
			before = here
		print("    from ten rows to the next, sun in the %s: %.3f of the light at most" % [light[0], most])
		assert_less(most, 0.08)


func knoll_height(x: float, z: float) -> float:
	return 2.0 * exp(-(x * x + z * z) / 30.0)


## Adds a field of 32 m with a knoll on its map, soil with hardly a blade on it.
func add_knoll(properties := {}) -> GrassField:
	var heights := Image.create_empty(65, 65, false, Image.FORMAT_RF)
	for z in 65:
		for x in 65:
			heights.set_pixel(x, z, Color(knoll_height(0.5 * x - 16.0, 0.5 * z - 16.0), 0, 0))
	var map := GrassMap.new()
	map.base_density = 1.0
	map.set_ground(heights, Rect2(-16.25, -16.25, 32.5, 32.5))
	var field := add_seen_field({size = Vector2(32, 32), density = 1.0, map = map}.merged(properties, true))
	await grown(field)
	return field


## From the side, in a picture of 8 m, whose background shows where there is neither soil nor blade.
func test_soil_follows_baked_hills() -> void:
	await add_knoll()
	camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	camera.size = 8.0
	look(Vector3(0, 1, 40), Vector3(0, 1, 0))
	var image := await full_picture(Vector2i(160, 80))
	save(image, "knoll")
	var below := 0
	var soil := 0
	for x in 160:
		for y in 80:
			var across := (x + 0.5 - 80) * 0.1
			var high := 1.0 - (y + 0.5 - 40) * 0.1
			var is_sky := image.get_pixel(x, y).b > 0.5
			if high > 0.1 and high < knoll_height(across, 0) - 0.15:
				below += 1
				soil += int(not is_sky)
			elif high > knoll_height(across, 0) + 1.0:
				assert_true(is_sky, "nothing stands %s m above the ground at %s" % [high, across])
	assert_greater(below, 500)
	assert_greater(float(soil) / below, 0.99, "the knoll hides what is behind it")


func test_soil_has_a_soft_edge_on_baked_hills() -> void:
	await add_knoll({root_shade = 0.0, soil_color = Color.BLACK, border_fade = 0.1})
	camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	camera.size = 2.0
	look(Vector3(15.5, 20, 0), Vector3(15.5, 0, 0))
	var image := await full_picture(Vector2i(192, 108))
	save(image, "knoll_edge")
	var sky := image.get_pixel(191, 50).b
	assert_greater(share_of(image, func(color: Color) -> bool: return color.b > 0.97 * sky), 0.1, "nothing outside")
	assert_greater(share_of(image, func(color: Color) -> bool: return color.b < 0.3 * sky), 0.1, "soil inside")
	assert_greater(share_of(image, func(color: Color) -> bool: return absf(color.b / sky - 0.65) < 0.25), 0.02, "both between")


## A terrain that is red on one side and blue on the other.
func test_far_grass_and_roots_have_the_colour_of_the_terrain() -> void:
	var colors := Image.create_empty(2, 1, false, Image.FORMAT_RGBA8)
	colors.set_pixel(0, 0, Color(0.7, 0.1, 0.1))
	colors.set_pixel(1, 0, Color(0.1, 0.1, 0.7))
	var field := add_seen_field({size = Vector2(60, 60), density = 64.0, terrain_blend = 1.0})
	await grown(field)
	var makings: int = field.get_counters().makings
	field.terrain_texture = ImageTexture.create_from_image(colors)
	await grown(field)
	assert_eq(field.get_counters().makings, makings + 1, "shaders for a terrain are others")
	sun.rotation_degrees = SIDE
	for at: float in [-16.0, 16.0]:
		look(Vector3(at, 20, 40), Vector3(at, 0, 4))
		camera.fov = 15.0
		var far := light_of(await full_picture(SIZE), 0, SIZE.y)
		look(Vector3(at, 1.0, 2), Vector3(at, 0, 0.5))
		camera.fov = 60.0
		var near := light_of(await full_picture(4 * SIZE), 0, 4 * SIZE.y)
		print("    terrain at %s: %s far, %s near" % [at, far, near])
		assert_greater(far.r / far.b if at < 0.0 else far.b / far.r, 5.0, "far grass is the terrain's")
		assert_greater(near.r / near.b if at < 0.0 else near.b / near.r, 1.5, "near grass in part")
		assert_greater(
			near.g / near.b if at < 0.0 else near.g / near.r, 1.2 * (far.g / far.b if at < 0.0 else far.g / far.r), "tips stay green"
		)
	field.terrain_blend = 0.0
	var plain := light_of(await full_picture(4 * SIZE), 0, 4 * SIZE.y)
	assert_greater(plain.g, 1.1 * plain.b)
	assert_eq(field.get_counters().makings, makings + 1, "the share is a uniform")


## Read from a terrain in place of a picture: red on one side, nothing told on the other.
func test_roots_and_far_grass_have_the_colours_that_a_terrain_tells() -> void:
	var terrain: Node3D = preload("res://tests/terrains/plain_terrain.gd").new()
	terrain.name = "Terrain"
	terrain.hills.painted = Rect2(-40, -40, 40, 80)
	viewport.add_child(terrain)
	var field := add_seen_field({size = Vector2(60, 60), density = 64.0, terrain_blend = 1.0})
	field.terrain = NodePath("../Terrain")
	await terrain_read(field)
	var reds: Array[float] = []
	for x: float in [-12.0, 12.0]:
		reds.append(await redness(x))
	assert_greater(reds[0], 2.0, "the terrain's colour")
	assert_less(reds[1], 1.2, "its own where the terrain tells none")
	terrain.hills.painted = Rect2(0, -40, 40, 80)
	terrain.terrain_changed.emit(AABB(Vector3(-40, 0, -40), Vector3(80, 40, 80)))
	await terrain_read(field)
	assert_less(await redness(-12.0), 1.2, "a change is followed")
	assert_greater(await redness(12.0), 2.0, "on both sides")
	var blue := Image.create_empty(4, 4, false, Image.FORMAT_RGB8)
	blue.fill(Color(0.1, 0.1, 0.9))
	field.terrain_texture = ImageTexture.create_from_image(blue)
	assert_less(await redness(12.0), 0.6, "a picture of the user's stands before what the terrain tells")
	field.terrain_texture = null
	assert_greater(await redness(12.0), 2.0, "and makes way for it")


func terrain_read(field: GrassField) -> void:
	await frames(2)
	await wait_until(
		func() -> bool:
			var now := field.get_statistics().merged(field.get_counters())
			return now.terrain_waiting == 0 and now.map_waiting == 0 and not now.waiting,
		"the terrain is read"
	)
	await drawn()


## Red over green or blue, whichever is more, of the grass far below the camera at x.
func redness(x: float) -> float:
	look(Vector3(x, 80, 0.1), Vector3(x, 12, 0))
	camera.far = 500.0
	camera.fov = 12.0
	var seen := mean(await picture())
	return seen.r / maxf(maxf(seen.g, seen.b), 0.01)
