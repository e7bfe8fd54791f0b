# SPDX-License-Identifier: MIT
## Species on the GPU: the picture shows each blade as what the simulation takes it for, and both backends agree.
extends "res://tests/view_case.gd"

const SIDE := 512  # pixels
const SKY := Color(0.3, 0.4, 0.9)  # of view_case.gd
const PICTURES := "user://pictures/"  # looked at by people


func before() -> void:
	open_view(Vector2i(SIDE, SIDE))
	add_light()
	DirAccess.make_dir_recursive_absolute(PICTURES)


func make(share: float, color: Color, properties := {}) -> GrassSpecies:
	var species := GrassSpecies.new()
	species.patch = GrassPatch.new()
	species.share = share
	species.root_color = color
	species.tip_color = color
	species.dry = 0.0
	for property: String in properties:
		if property in species.patch:
			species.patch.set(property, properties[property])
		else:
			species.set(property, properties[property])
	return species


## Short, wide, upright blades of three colours, far from each other and without clumps, from above.
func add_markers(properties := {}) -> GrassField:
	var shape := {
		length_min = 0.06, length_max = 0.06, width_min = 0.2, width_max = 0.2, weight_drooping = 0.0, weight_wavy = 0.0, stand_size = 3.0
	}
	var field := add_seen_field(
		(
			{
				size = Vector2(16, 16),
				density = 1.0,
				species = [make(0.4, Color.RED, shape), make(0.3, Color.GREEN, shape), make(0.3, Color.BLUE, shape)],
				clump_tint = 0.0,
				clump_height = 0.0,
				clump_lean = 0.0,
				ground = false,
				root_shade = 0.0,
				pixels_min = 4.0,
				lod_far = 1000.0,
			}
			. merged(properties, true)
		)
	)
	camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	camera.size = 16.0
	look(Vector3(0, 5, 0), Vector3.ZERO)
	return field


func channel_of(color: Color) -> int:
	return 0 if color.r > maxf(color.g, color.b) else (1 if color.g > color.b else 2)


## Compares what every blade is drawn as with what it is simulated as; blades that another one may hide are left out.
func check_markers(field: GrassField) -> void:
	await drawn()
	var image := await picture()
	var places: Array[Vector2] = []
	var species: Array[int] = []
	var tiles := field.get_tiles()
	for z in tiles.y:
		for x in tiles.x:
			for blade in BLADES:
				var knots := field.get_knots(Vector2i(x, z), blade)
				var middle := (knots[0] + knots[8]) / 2.0
				places.append(camera.unproject_position(middle))
				species.append(field.get_blade_species(Vector2i(x, z), blade))
	var seen := [0, 0, 0]
	var wrong := 0
	for i in places.size():
		var at := places[i]
		if at.x < 2 or at.y < 2 or at.x > SIDE - 3 or at.y > SIDE - 3:
			continue
		var is_alone := true
		for j in places.size():
			is_alone = is_alone and (i == j or places[j].distance_squared_to(at) > 144.0)
		if is_alone:
			var color := image.get_pixelv(Vector2i(at))
			if Vector3(color.r - SKY.r, color.g - SKY.g, color.b - SKY.b).length() < 0.1:
				continue  # seen edge on, beside its middle
			if channel_of(color) == species[i]:
				seen[species[i]] += 1
			else:
				wrong += 1
	print("    drawn as simulated: %s blades of each species" % [seen])
	assert_eq(wrong, 0)
	for s in 3:
		assert_greater(seen[s], 20)


func test_each_blade_is_drawn_as_what_it_is_simulated_as() -> void:
	await check_markers(add_markers())


func test_painted_blades_are_drawn_as_what_they_are_simulated_as() -> void:
	var field := add_markers({map = full_map()})
	for number in [1, 2, 3]:
		var place := Vector3(-5 + 3.7 * number, 0, -2 + number)
		field.paint(brush(GrassBrush.TOOL_SPECIES, 3.0, {species = number}), place, place)
	await check_markers(field)


func test_both_backends_simulate_species_alike() -> void:
	var species: Array[GrassSpecies] = [
		make(0.5, Color.RED, {length_max = 0.4, natural_frequency = 0.8}),
		make(0.5, Color.GREEN, {length_max = 0.8, natural_frequency = 3.0, damping_ratio = 0.2})
	]
	for method: GrassField.SolverMethod in [GrassField.METHOD_DIRECT, GrassField.METHOD_PBD]:
		var gpu := add_field({species = species, method = method})
		var cpu := add_field({species = species, method = method, backend = GrassField.BACKEND_CPU})
		await ticks(2)
		if not (assert_eq(gpu.get_statistics().backend, "GPU") and assert_eq(cpu.get_statistics().backend, "CPU")):
			return
		await compiled(gpu)
		var tile := cpu.get_tile_at(Vector3(0.2, 0, 0.2))
		var rest := tile_knots(cpu, tile)
		assert_eq(farthest(tile_knots(gpu, tile), rest), 0.0, "at rest")
		var body := add_held_body(ball(0.2), Vector3(0.25, 0.9, 0.25))
		while cpu.get_awake_tile_count() == 0 or farthest(tile_knots(cpu, tile), rest) < 0.01:
			body.position.y -= 0.02
			await ticks(1)
			if not assert_greater(body.position.y, -1.0):
				return
		body.free()
		var most := 0.0
		for i in 8:
			most = maxf(most, farthest(tile_knots(gpu, tile), tile_knots(cpu, tile)))
			await ticks(5)
		print("    %s: %s m apart in 40 steps" % ["direct" if method == GrassField.METHOD_DIRECT else "PBD", String.num_scientific(most)])
		assert_less(most, 1e-3)
		gpu.free()
		cpu.free()


func test_an_awake_tile_of_species_is_drawn_as_it_was_asleep() -> void:
	var field := add_seen_field(
		{
			sleep_mode = GrassField.SLEEP_TIMER,
			sleep_delay = 5.0,
			species = [make(0.6, Color(0.3, 0.6, 0.2)), make(0.4, Color(0.7, 0.2, 0.2), {length_min = 0.7, length_max = 0.9})]
		}
	)
	look(Vector3(0, 1.2, 3.2), Vector3(0, 0.2, 0))
	await drawn()
	var asleep := await picture()
	var body := AnimatableBody3D.new()
	body.sync_to_physics = false
	add_shape(body, ball(0.05))
	body.position = Vector3(0, 1.2, 0.5)
	viewport.add_child(body)
	for i in 60:  # down to the tips, then away
		body.position.y -= 0.01
		await ticks(1)
		if field.get_awake_tile_count() > 0:
			break
	body.position.y = 5.0
	await ticks(3)
	if not assert_greater(field.get_awake_tile_count(), 0):
		return
	assert_less(difference(asleep, await picture()).y, 5e-4)


## A flower of one colour: a disc on nothing.
func flower(color: Color) -> ImageTexture:
	var image := Image.create_empty(64, 64, false, Image.FORMAT_RGBA8)
	for y in 64:
		for x in 64:
			image.set_pixel(x, y, color if Vector2(x - 31.5, y - 31.5).length() < 30.0 else Color(color, 0.0))
	return ImageTexture.create_from_image(image)


## Twelve white petals about a yellow middle.
func daisy_card() -> ImageTexture:
	var image := Image.create_empty(128, 128, false, Image.FORMAT_RGBA8)
	for y in 128:
		for x in 128:
			var place := Vector2(x - 63.5, y - 63.5) / 64.0
			var petal := absf(cos(6.0 * place.angle()))
			var color := Color(0.95, 0.95, 0.92, 1.0 if place.length() < 0.55 + 0.4 * petal and petal > 0.3 else 0.0)
			image.set_pixel(x, y, Color(0.95, 0.75, 0.1) if place.length() < 0.3 else color)
	return ImageTexture.create_from_image(image)


func is_violet(color: Color) -> bool:
	return color.r > 1.5 * color.g and color.b > 1.5 * color.g


func test_flowers_stand_on_the_tips_of_their_species_only() -> void:
	var green := make(0.8, Color(0.3, 0.6, 0.2))
	var violet := make(0.2, Color(0.3, 0.6, 0.2), {length_min = 0.6, length_max = 0.7, card_width = 0.06, card_height = 0.06})
	var field := add_seen_field({map = full_map(), species = [green, violet], lod_far = 1000.0})
	look(Vector3(0, 1.2, 3.2), Vector3(0, 0.4, 0))
	await drawn()
	var triangles: int = field.get_statistics().drawn_triangles
	_check_no_flowers(await picture())
	violet.card = flower(Color(0.7, 0.1, 0.7))
	await drawn()
	var gpu := await picture()
	gpu.save_png(PICTURES + "flowers.png")
	print("    %s" % ProjectSettings.globalize_path(PICTURES + "flowers.png"))
	var share := share_of(gpu, is_violet)
	print("    flowers on %.3f of the picture" % share)
	assert_greater(share, 0.01)
	assert_less(share, 0.4)
	assert_greater(field.get_statistics().drawn_triangles, triangles)
	field.backend = GrassField.BACKEND_CPU
	await drawn()
	assert_less(difference(gpu, await picture()).y, 0.003)
	field.backend = GrassField.BACKEND_AUTO
	violet.card.set_image(flower(Color(0.9, 0.1, 0.1)).get_image())
	await drawn()
	var repainted := await picture()
	assert_near(share_of(repainted, is_red), share, 0.01)
	_check_no_flowers(repainted)
	violet.card.set_image(flower(Color(0.7, 0.1, 0.7)).get_image())
	field.map.stroke(brush(GrassBrush.TOOL_CUT, 4.0, {cut_height = 0.2}), Vector2.ZERO, Vector2.ZERO)
	await drawn()
	_check_no_flowers(await picture())
	field.map.clear()
	field.map.base_density = 1.0
	violet.card = null
	await drawn()
	assert_eq(field.get_statistics().drawn_triangles, triangles)


func _check_no_flowers(image: Image) -> void:
	assert_eq(share_of(image, is_violet), 0.0, "no flower")


## How much more violet than green the field is, in linear light.
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
	# Height of the camera, share of the blades that have cards, size of the cards.
	for setting: Vector3 in [Vector3(10, 1.0, 0.06), Vector3(40, 0.1, 0.06), Vector3(5, 1.0, 0.02)]:
		var violet := make(1.0, Color(0.3, 0.6, 0.2), {card_share = setting.y, card_width = setting.z, card_height = setting.z})
		var field := add_seen_field({species = [violet], size = Vector2(30, 30), ground = false})
		look(Vector3(0, setting.x, 40), Vector3.ZERO)
		var gain := {0.25: 0.0, 8.0: 0.0}  # by lod_error
		for card: Texture2D in [null, flower(Color(0.7, 0.1, 0.7))]:
			violet.card = card
			for error: float in gain:
				field.lod_error = error
				await drawn()
				gain[error] = violet_of(await picture()) - gain[error]
		print("    far, as violet as near: %.2f" % [gain[8.0] / gain[0.25]])
		assert_near(gain[8.0] / gain[0.25], 1.0, 0.5)
		field.free()


## Sparse blades, each tip of which can be looked up.
func test_flowers_bend_with_their_blades() -> void:
	var violet := make(1.0, Color(0.3, 0.6, 0.2), {card_width = 0.12, card_height = 0.12, length_min = 0.6, length_max = 0.8})
	violet.card = flower(Color(0.7, 0.1, 0.7))
	var field := add_seen_field(
		{
			species = [violet],
			density = 16.0,
			ground = false,
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
	var image := await picture()
	assert_greater(_share_of_flowers(image, rest), 0.97)
	var body := add_held_body(ball(0.5), Vector3(0.2, 0.2, 0.2))
	body.reparent(viewport)  # into its world
	await ticks(30)
	await drawn()
	var bent := _tips(field)
	image = await picture()
	image.save_png(PICTURES + "flowers_bent.png")
	var moved := PackedVector3Array()
	var left := PackedVector3Array()
	for i in rest.size():
		if rest[i].distance_to(bent[i]) > 0.2:
			moved.append(bent[i])
			left.append(rest[i])
	print("    %d of %d flowers moved by 0.2 m and more" % [moved.size(), rest.size()])
	assert_greater(moved.size(), 10)
	assert_greater(_share_of_flowers(image, moved), 0.9)
	var stayed := _share_of_flowers(image, left)
	print("    flowers where they are now %.3f, where they were %.3f" % [_share_of_flowers(image, moved), stayed])
	assert_less(stayed, 0.5)
	body.free()
	violet.card_share = 0.25
	await drawn()
	var some := _share_of_flowers(await picture(), _tips(field))
	print("    flowers on %.3f of the blades, where 0.25 were asked for" % some)
	assert_near(some, 0.25, 0.12)
	assert_eq(await draw_calls(), calls)
	violet.card = null
	await drawn()
	assert_eq(await draw_calls(), calls, "cards are no draw call of their own")


func draw_calls() -> int:
	await drawn()
	return RenderingServer.viewport_get_render_info(
		viewport.get_viewport_rid(),
		RenderingServer.VIEWPORT_RENDER_INFO_TYPE_VISIBLE,
		RenderingServer.VIEWPORT_RENDER_INFO_DRAW_CALLS_IN_FRAME
	)


func _tips(field: GrassField) -> PackedVector3Array:
	var tips := PackedVector3Array()
	var tiles := field.get_tiles()
	for z in tiles.y:
		for x in tiles.x:
			for blade in BLADES:
				tips.append(field.get_knots(Vector2i(x, z), blade)[KNOTS - 1])
	return tips


func _share_of_flowers(image: Image, tips: PackedVector3Array) -> float:
	var flowers := 0
	for tip in tips:
		var at := Vector2i(camera.unproject_position(tip))
		var is_seen := false  # a blade may cross it
		for off: Vector2i in [Vector2i.ZERO, Vector2i(2, 0), Vector2i(-2, 0), Vector2i(0, 2), Vector2i(0, -2)]:
			is_seen = is_seen or is_violet(image.get_pixelv(at + off))
		flowers += int(is_seen)
	return float(flowers) / tips.size()


## For people: a meadow of four species, one with flowers, on which a path of one was painted, on both backends.
func test_a_meadow_of_four_species_looks_alike_on_both_backends() -> void:
	viewport.size = Vector2i(960, 540)
	var fescue := make(0.75, Color.WHITE, {root_color = Color(0.15, 0.25, 0.08), tip_color = Color(0.48, 0.6, 0.22), dry = 0.25})
	var sorrel := make(
		0.15,
		Color.WHITE,
		{
			length_min = 0.7,
			length_max = 0.95,
			width_min = 0.006,
			width_max = 0.01,
			weight_drooping = 0.0,
			weight_wavy = 0.0,
			stand_size = 2.5,
			stand_strength = 0.8,
			natural_frequency = 2.0
		}
	)
	sorrel.gradient = Gradient.new()
	sorrel.gradient.offsets = PackedFloat32Array([0.0, 0.6, 0.75, 1.0])
	sorrel.gradient.colors = PackedColorArray([Color(0.2, 0.3, 0.1), Color(0.4, 0.45, 0.2), Color(0.55, 0.2, 0.12), Color(0.6, 0.25, 0.2)])
	var sedge := make(
		0.1,
		Color.WHITE,
		{
			root_color = Color(0.08, 0.2, 0.14),
			tip_color = Color(0.3, 0.5, 0.42),
			length_min = 0.35,
			length_max = 0.55,
			width_min = 0.015,
			width_max = 0.03,
			stand_size = 4.0,
			stand_strength = 0.9
		}
	)
	var daisy := make(
		0.06,
		Color.WHITE,
		{
			root_color = Color(0.15, 0.25, 0.08),
			tip_color = Color(0.4, 0.5, 0.2),
			length_min = 0.5,
			length_max = 0.65,
			width_max = 0.006,
			width_min = 0.004,
			weight_drooping = 0.0,
			weight_wavy = 0.0,
			stand_size = 1.5,
			stand_strength = 0.5,
			card_width = 0.045,
			card_height = 0.045
		}
	)
	daisy.card = daisy_card()
	var field := add_seen_field({size = Vector2(20, 20), map = full_map(), species = [fescue, sorrel, sedge, daisy]})
	field.paint(brush(GrassBrush.TOOL_SPECIES, 1.0, {species = 3}), Vector3(-8, 0, 2), Vector3(8, 0, -5))
	look(Vector3(0, 2.2, 9), Vector3(0, 0, 0))
	await drawn()
	var gpu := await picture()
	gpu.save_png(PICTURES + "species.png")
	print("    %s" % ProjectSettings.globalize_path(PICTURES + "species.png"))
	field.backend = GrassField.BACKEND_CPU
	await drawn()
	var off := difference(gpu, await picture())
	print("    GPU against CPU backend: mean difference %.5f" % off.y)
	assert_less(off.y, 0.003)
