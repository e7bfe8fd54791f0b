# SPDX-License-Identifier: MIT
## Cards on the tips of a species: which blades have one, how they bend, and how much of their colour is left far away.
extends "res://tests/species_case.gd"

const UPRIGHT := {weight_upright = 1.0, weight_arched = 0.0, weight_drooping = 0.0, weight_wavy = 0.0}


func test_flowers_stand_on_the_tips_of_their_species_only() -> void:
	var green := make(0.8, Color(0.3, 0.6, 0.2))
	var violet := make(0.2, Color(0.3, 0.6, 0.2), {length_min = 0.6, length_max = 0.7, card_width = 0.06, card_height = 0.06})
	var field := add_seen_field({map = full_map(), species = [green, violet], lod_far = 1000.0})
	look(Vector3(0, 1.2, 3.2), Vector3(0, 0.4, 0))
	await drawn()
	var triangles: int = field.get_statistics().drawn_triangles
	_check_no_flowers(await next_picture())
	violet.card = flower(Color(0.7, 0.1, 0.7))
	await drawn()
	var gpu := await next_picture()
	save(gpu, "flowers")
	var share := share_of(gpu, is_violet)
	print("    flowers on %.3f of the picture" % share)
	assert_greater(share, 0.01)
	assert_less(share, 0.4)
	assert_greater(field.get_statistics().drawn_triangles, triangles)
	field.backend = GrassField.BACKEND_CPU
	await drawn()
	assert_less(difference(gpu, await next_picture()).y, 0.003)
	field.backend = GrassField.BACKEND_AUTO
	violet.card.set_image(flower(Color(0.9, 0.1, 0.1)).get_image())
	var repainted := await picture()
	assert_near(share_of(repainted, is_red), share, 0.01)
	_check_no_flowers(repainted)
	violet.card.set_image(flower(Color(0.7, 0.1, 0.7)).get_image())
	field.map.stroke(brush(GrassBrush.TOOL_CUT, 4.0, {cut_height = 0.2}), Vector2.ZERO, Vector2.ZERO)
	_check_no_flowers(await picture())
	field.map.clear()
	field.map.base_density = 1.0
	violet.card = null
	await drawn()
	assert_eq(field.get_statistics().drawn_triangles, triangles)


func test_flowers_stay_with_their_species_when_these_change_places() -> void:
	var green := make(0.5, Color(0.3, 0.6, 0.2))
	var violet := make(0.5, Color(0.3, 0.6, 0.2), {card_share = 0.3, card_width = 0.06, card_height = 0.06})
	violet.card = flower(Color(0.7, 0.1, 0.7))
	var field := add_seen_field({species = [green, violet]})
	look(Vector3(0, 1.2, 3.2), Vector3(0, 0.4, 0))
	await drawn()
	field.species = [violet, green]
	var changed := await picture()
	field.free()
	add_seen_field({species = [violet, green]})
	assert_less(difference(changed, await picture()).y, 1e-3, "as if it had been made so")
	assert_greater(share_of(changed, is_violet), 0.005)


func _check_no_flowers(image: Image) -> void:
	assert_eq(share_of(image, is_violet), 0.0, "no flower")


## Returns how much more violet than green the field is, in linear light.
func violet_of(image: Image) -> float:
	var sum := 0.0
	for y in image.get_height():
		for x in image.get_width():
			var color := image.get_pixel(x, y)
			if Vector3(color.r - SKY.r, color.g - SKY.g, color.b - SKY.b).length() > 0.1:
				color = color.srgb_to_linear()
				sum += 0.5 * (color.r + color.b) - color.g
	return sum


## Blades of one triangle against blades of many that have cards, from the same place.
func test_far_blades_show_the_colour_of_their_flowers() -> void:
	# Height of the camera, share of the blades that have cards, size of the cards, their flatness.
	for setting: Vector4 in [Vector4(10, 1.0, 0.06, 0), Vector4(40, 0.1, 0.06, 0), Vector4(5, 1.0, 0.02, 0), Vector4(4, 1.0, 0.06, 1)]:
		var violet := make(1.0, Color(0.3, 0.6, 0.2), {card_share = setting.y, card_width = setting.z, card_height = setting.z})
		violet.card_flatness = setting.w
		var field := add_seen_field({species = [violet], size = Vector2(30, 30), soil_enabled = false})
		look(Vector3(0, setting.x, 40), Vector3.ZERO)
		var gain := {0.25: 0.0, 8.0: 0.0}  # by lod_error
		for card: Texture2D in [null, flower(Color(0.7, 0.1, 0.7))]:
			violet.card = card
			for error: float in gain:
				field.lod_error = error
				gain[error] = violet_of(await picture()) - gain[error]
		print("    far, as violet as near: %.2f" % [gain[8.0] / gain[0.25]])
		assert_near(gain[8.0] / gain[0.25], 1.0, 0.5)
		field.free()


## A flat blade vanishes where it is seen from its edge. A flower on it would hang in the air.
func test_stalks_of_flowers_are_seen_from_every_side() -> void:
	var wide := {width_min = 0.06, width_max = 0.06, length_min = 0.6, length_max = 0.8, card_width = 0.02, card_height = 0.02}
	var red := make(1.0, Color(0.7, 0.1, 0.1), wide.merged(UPRIGHT))
	red.card = flower(Color(0.7, 0.1, 0.7))
	var field := add_seen_field({species = [red], density = 16.0, soil_enabled = false, lod_error = 0.25, pixels_min = 0.0})
	look(Vector3(0, 3.8, 2.3), Vector3.ZERO)
	var image := await picture()
	save(image, "stalks")
	var seen := 0
	var all := 0
	for middle in _knots(field, KNOTS / 2):
		seen += int(is_red(image.get_pixelv(Vector2i(camera.unproject_position(middle)))))
		all += 1
	print("    %d of %d stalks are seen" % [seen, all])
	assert_greater(float(seen) / all, 0.92)


## A flower that lies has green leaves below it, which are seen from the ground only.
func test_flowers_have_a_back() -> void:
	var lies := {card_width = 0.12, card_height = 0.12, card_flatness = 1.0}
	var red := make(1.0, Color(0.7, 0.1, 0.1), lies.merged(UPRIGHT))
	red.card = flower(Color(0.7, 0.1, 0.7))
	add_seen_field({species = [red], density = 64.0, soil_enabled = false, lod_far = 1000.0})
	var green: Array[float] = []
	for height: float in [5.0, 0.02]:
		look(Vector3(0, height, 0.01), Vector3(0, 0.5, 0))
		var image := await picture()
		save(image, "flowers_from_%.2f_m" % height)
		green.append(share_of(image, is_green))
	print("    green from above %.4f, from below %.4f" % [green[0], green[1]])
	assert_less(green[0], 0.1 * green[1])
	assert_greater(green[1], 0.001)


## Sparse blades, each tip of which can be looked up.
func test_flowers_bend_with_their_blades() -> void:
	var violet := make(1.0, Color(0.3, 0.6, 0.2), {card_width = 0.12, card_height = 0.12, length_min = 0.6, length_max = 0.8})
	violet.card = flower(Color(0.7, 0.1, 0.7))
	var field := add_seen_field(
		{
			species = [violet],
			density = 16.0,
			soil_enabled = false,
			lod_far = 1000.0,
			pixels_min = 0.0,
			sleep_mode = GrassField.SLEEP_TIMER,
			sleep_delay = 30.0
		}
	)
	var calls := await draw_calls()
	look(Vector3(0, 5, 3), Vector3.ZERO)
	await drawn()
	var rest := _tips(field)
	var image := await next_picture()
	assert_greater(_share_of_flowers(image, rest), 0.97)
	var body := add_held_body(ball(0.5), Vector3(0.2, 0.2, 0.2))
	body.reparent(viewport)  # into its world
	await ticks(30)
	await drawn()
	var bent := _tips(field)
	image = await next_picture()
	save(image, "flowers_bent")
	var moved := PackedVector3Array()
	var left := PackedVector3Array()
	for i in rest.size():
		if rest[i].distance_to(bent[i]) > 0.2:
			moved.append(bent[i])
			left.append(rest[i])
	print("    %d of %d flowers moved by 0.2 m and more" % [moved.size(), rest.size()])
	assert_greater(moved.size(), 10)
	assert_greater(_share_of_flowers(image, moved), 0.8)  # of thirteen; who looks along a blade sees its card short
	var stayed := _share_of_flowers(image, left)
	print("    flowers where they are now %.3f, where they were %.3f" % [_share_of_flowers(image, moved), stayed])
	assert_less(stayed, 0.5)
	body.free()
	violet.card_share = 0.25
	field.clump_tint = 0.0  # by which they stand in groups
	var some := _share_of_flowers(await picture(), _tips(field))
	print("    flowers on %.3f of the blades, where 0.25 were asked for" % some)
	assert_near(some, 0.25, 0.12)
	assert_eq(await draw_calls(), calls)
	violet.card = null
	await drawn()
	# Levels are drawn together by how many vertices they have, and cards are some of these.
	assert_near(await draw_calls(), calls, 1, "cards are no draw call of their own")


func draw_calls() -> int:
	await drawn()
	return RenderingServer.viewport_get_render_info(
		viewport.get_viewport_rid(),
		RenderingServer.VIEWPORT_RENDER_INFO_TYPE_VISIBLE,
		RenderingServer.VIEWPORT_RENDER_INFO_DRAW_CALLS_IN_FRAME
	)


func _tips(field: GrassField) -> PackedVector3Array:
	return _knots(field, KNOTS - 1)


## Returns the places of one knot of all blades.
func _knots(field: GrassField, knot: int) -> PackedVector3Array:
	var places := PackedVector3Array()
	var tiles := field.get_grid_size()
	for z in tiles.y:
		for x in tiles.x:
			for blade in BLADES:
				places.append(field.get_knots(Vector2i(x, z), blade)[knot])
	return places


func _share_of_flowers(image: Image, tips: PackedVector3Array) -> float:
	var flowers := 0
	for tip in tips:
		var at := Vector2i(camera.unproject_position(tip))
		var is_seen := false  # a blade may cross it
		for off: Vector2i in [Vector2i.ZERO, Vector2i(2, 0), Vector2i(-2, 0), Vector2i(0, 2), Vector2i(0, -2)]:
			is_seen = is_seen or is_violet(image.get_pixelv(at + off))
		flowers += int(is_seen)
	return float(flowers) / tips.size()
