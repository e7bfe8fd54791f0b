# SPDX-License-Identifier: MIT
## The look of a field, by numbers that a driver's rounding does not change: shares and means, not pixels. Runs in every renderer: Forward+,
## Mobile, Compatibility.
extends "res://tests/view_case.gd"

const SIZE := Vector2i(192, 108)
const UNSEEN := 7e-5  # mean difference of two pictures; blades moved by 4 mm give 8e-4


func before() -> void:
	open_view(SIZE)
	add_light()
	look(Vector3(0, 1.2, 3.2), Vector3(0, 0.2, 0))


func add_ball(place: Vector3, radius := 0.2) -> AnimatableBody3D:
	var body := AnimatableBody3D.new()
	body.sync_to_physics = false
	add_shape(body, ball(radius))
	body.position = place
	viewport.add_child(body)
	return body


func test_compatibility_says_where_it_becomes_imprecise() -> void:
	var is_compatibility := RenderingServer.get_current_rendering_method() == "gl_compatibility"
	if is_compatibility:
		expect_error("The Compatibility renderer distinguishes at most 2048 tiles along a side")
	var field := add_seen_field({size = Vector2(600, 0.5), density = 1024.0})
	await drawn()
	assert_eq(field.get_grid_size(), Vector2i(2400, 2))


## Everything that a standing field keeps its buffers, textures and materials through, one after the other.
func test_a_field_that_changed_looks_as_if_it_had_been_made_so() -> void:
	var short := GrassSpecies.new()
	short.patch = GrassPatch.new()
	short.patch.length_max = 0.3
	short.tip_color = Color.YELLOW
	var map := full_map()
	map.stroke(brush(GrassBrush.TOOL_HEIGHT, 0.8, {target = 0.4}), Vector2(0.8, 0.8), Vector2(0.8, 0.8))
	var body := add_ball(Vector3(0, 0.2, 0.5), 0.3)
	var changed := add_seen_field({seed = 5})
	await drawn()
	var builds: int = changed.get_counters().builds
	var before: Image = null
	for change: Dictionary in [
		{pool_tiles = 200}, {map = map}, {species = [GrassSpecies.new(), short]}, {map = null, pool_tiles = 900}, {species = []}
	]:
		for property: String in change:
			changed.set(property, change[property])
		await grown(changed)
		await ticks(40)
		var image := await picture()
		assert_greater(changed.get_awake_tile_count(), 0, str(change))
		changed.hide()
		var fresh := add_seen_field({seed = 5, pool_tiles = changed.pool_tiles, map = changed.map, species = changed.species})
		await ticks(40)
		var off := difference(await picture(), image)
		print("    after %s: %s" % [change.keys(), off])
		assert_less(off.y, UNSEEN, str(change))
		if before and not change.has("pool_tiles"):
			assert_greater(difference(before, image).y, 10.0 * UNSEEN, "it shows: %s" % change)
		before = image
		fresh.free()
		changed.show()
	assert_eq(changed.get_counters().builds, builds)
	body.free()


func test_grass_covers_the_ground_green() -> void:
	var empty := await picture()
	assert_less(share_of(empty, is_green), 0.001, "nothing green without a field")
	var field := add_seen_field()
	var meadow := await picture()
	var green := share_of(meadow, is_green)
	var changed := share_of_changed(empty, meadow)
	print("    green %.3f, covered %.3f of the picture" % [green, changed])
	assert_greater(green, 0.15, "share of green pixels")
	assert_less(green, 0.9)
	assert_near(changed, green, 0.13, "what is covered is green, or soil between blades")
	var lower := meadow.get_region(Rect2i(SIZE.x / 4, SIZE.y / 2, SIZE.x / 2, SIZE.y / 4))
	assert_greater(share_of(lower, is_green), 0.7, "the field's middle is covered")
	var color := mean(lower)
	assert_true(color.get_luminance() > 0.03 and color.get_luminance() < 0.7, "mean colour %s" % color)
	assert_greater(color.g, 1.3 * color.b)
	field.hide()
	assert_less(difference(await picture(), empty).x, 0.01, "gone when hidden")


func share_of_changed(a: Image, b: Image) -> float:
	var count := 0
	for y in a.get_height():
		for x in a.get_width():
			var one := a.get_pixel(x, y)
			var other := b.get_pixel(x, y)
			count += int(absf(one.r - other.r) + absf(one.g - other.g) + absf(one.b - other.b) > 0.05)
	return float(count) / (a.get_width() * a.get_height())


func test_the_renderer_decides_who_simulates() -> void:
	var field := add_seen_field()
	await drawn()
	var has_device := RenderingServer.get_rendering_device() != null
	assert_eq(has_device, RenderingServer.get_current_rendering_method() != "gl_compatibility")
	assert_eq(field.get_statistics().backend, "GPU" if has_device else "CPU")
	assert_greater(field.get_statistics().drawn_tiles, 0)


func test_both_backends_draw_the_same() -> void:
	var gpu := add_seen_field()
	var one := await picture()
	assert_greater(share_of(one, is_green), 0.1, "grass")
	gpu.backend = GrassField.BACKEND_CPU
	var off := difference(one, await picture())
	print("    GPU against CPU backend: mean difference %.5f" % off.y)
	assert_less(off.y, 0.003)


func test_wind_moves_and_stillness_does_not() -> void:
	var field := add_seen_field()
	var still := await picture()
	assert_less(difference(still, await picture()).x, 0.01, "without wind")
	field.wind_speed = 8.0
	field.gust_strength = 1.0
	await frames(10)
	var blown := await picture()
	await frames(20)
	assert_greater(difference(blown, await picture()).y, 0.004, "in wind")


func test_a_ball_leaves_a_mark_that_goes_away() -> void:
	var field := add_seen_field({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 0.5, settle_time = 0.3})
	look(Vector3(0, 3, 0), Vector3.ZERO)
	var before_it := await picture()
	var body := add_ball(Vector3(0, 0.3, 0), 0.6)
	await ticks(30)
	var pressed := difference(before_it, await picture())
	body.free()
	print("    the dent: mean difference %.4f" % pressed.y)
	assert_greater(pressed.y, 0.001, "a dent")  # 0.0017 in a picture with 256 samples a pixel, in which every blade is seen
	await ticks(80)
	assert_eq(field.get_awake_tile_count(), 0)
	assert_less(difference(before_it, await picture()).x, 0.01, "the same picture as before")


## A body above the tips wakes tiles and bends none: nobody may see it.
func test_waking_and_sleeping_are_not_seen() -> void:
	var field := add_seen_field({sleep_mode = GrassField.SLEEP_TIMER, sleep_delay = 0.2, settle_time = 0.2})
	await drawn()
	var tip := 0.0
	for x in 8:
		for z in 8:
			for knot in tile_knots(field, Vector2i(x, z)):
				tip = maxf(tip, knot.y)
	var asleep := await picture()
	var body := add_ball(Vector3(0, tip + 0.11, 0.5), 0.1)
	await ticks(5)
	if not assert_greater(field.get_awake_tile_count(), 0, "tiles are awake"):
		return
	var awake := difference(asleep, await picture())
	body.free()
	await ticks(24)
	var settled := difference(asleep, await picture())
	await ticks(30)
	assert_eq(field.get_awake_tile_count(), 0)
	print("    asleep against awake: mean %.6f, most %.3f; settling: mean %.6f" % [awake.y, awake.x, settled.y])
	assert_less(awake.y, UNSEEN, "awake")
	assert_less(settled.y, UNSEEN, "settling")
	assert_less(difference(asleep, await picture()).x, 0.01, "asleep again")


func test_awake_tiles_are_shown_red() -> void:
	var field := add_seen_field({debug_view = GrassField.DEBUG_VIEW_AWAKE_TILES})
	look(Vector3(0, 6, 0), Vector3.ZERO)
	add_ball(Vector3(1.5, 0.2, 0), 0.15)
	await ticks(10)
	var shown := await picture()
	var red := share_of(shown, is_red)
	var left := shown.get_region(Rect2i(0, 0, SIZE.x / 2, SIZE.y))
	print("    red %.3f of the picture, %.4f of the half without the ball" % [red, share_of(left, is_red)])
	assert_greater(red, 0.004)
	assert_less(red, 0.2)
	assert_less(share_of(left, is_red), 0.001, "nothing is awake there")
	field.debug_view = GrassField.DEBUG_VIEW_OFF
	assert_less(share_of(await picture(), is_red), 0.001, "switched off")
	field.debug_view = GrassField.DEBUG_VIEW_LOD
	assert_greater(difference(shown, await picture()).y, 0.003, "levels of detail are coloured otherwise")


func test_density_and_cost_are_heat_maps() -> void:
	var map := full_map()
	map.stroke(brush(GrassBrush.TOOL_DENSITY, 3.0, {target = 0.3, strength = 1.0, hardness = 1.0}), Vector2(-3, 0), Vector2(-3, 0))
	var field := add_seen_field({map = map, size = Vector2(12, 12), soil_enabled = false})
	look(Vector3(0, 7, 0), Vector3.ZERO)
	field.debug_view = GrassField.DEBUG_VIEW_DENSITY
	var density := await picture()
	density.save_png("user://heat_density.png")  # looked at by people
	var thin := density.get_region(Rect2i(SIZE.x / 4, SIZE.y / 3, SIZE.x / 8, SIZE.y / 3))
	var full := density.get_region(Rect2i(SIZE.x * 5 / 8, SIZE.y / 3, SIZE.x / 8, SIZE.y / 3))
	print("    where a third stands red %.3f, where all does %.3f" % [share_of(thin, is_red), share_of(full, is_red)])
	assert_less(share_of(thin, is_red), 0.01)
	assert_greater(share_of(full, is_red), 0.3)
	field.debug_view = GrassField.DEBUG_VIEW_COST
	look(Vector3(0, 0.8, 6.5), Vector3(0, 0, 3))
	var cost := await picture()
	cost.save_png("user://heat_cost.png")
	var near := mean(cost.get_region(Rect2i(0, SIZE.y * 3 / 4, SIZE.x, SIZE.y / 4)))
	look(Vector3(0, 40, 0), Vector3.ZERO)
	var far := mean((await picture()).get_region(Rect2i(SIZE.x * 7 / 16, SIZE.y * 7 / 16, SIZE.x / 8, SIZE.y / 8)))
	print("    cost: %s near, %s far" % [near, far])
	assert_greater(near.r - near.b, far.r - far.b + 0.1)


## Blue or, where the CPU leaves out fewer blades, turquoise.
func is_cold(color: Color) -> bool:
	return color.b > 1.3 * color.r


func test_simulated_blades_are_a_heat_map() -> void:
	var field := add_seen_field({debug_view = GrassField.DEBUG_VIEW_SIMULATED, simulation_detail = GrassField.SIMULATION_WHOLE})
	look(Vector3(0, 6, 0), Vector3.ZERO)
	add_ball(Vector3(1.5, 0.2, 0), 0.15)
	await ticks(10)
	var whole := await picture()
	var left := whole.get_region(Rect2i(0, 0, SIZE.x / 2, SIZE.y))
	field.simulation_detail = GrassField.SIMULATION_SEEN
	await ticks(10)
	var seen := await picture()
	whole.save_png("user://heat_simulated.png")  # looked at by people
	print(
		(
			"    red %.4f, then %.4f; more blue or turquoise %.4f"
			% [share_of(whole, is_red), share_of(seen, is_red), share_of(seen, is_cold) - share_of(whole, is_cold)]
		)
	)
	assert_greater(share_of(whole, is_red), 0.004)
	assert_less(share_of(left, is_red), 0.001, "nothing is awake there")
	assert_less(share_of(seen, is_red), 0.001, "few are simulated, or a quarter on the CPU")
	assert_greater(share_of(seen, is_cold) - share_of(whole, is_cold), 0.004, "beside the sky")


func test_grass_casts_shadows() -> void:
	var floor_ := MeshInstance3D.new()
	floor_.mesh = PlaneMesh.new()
	floor_.mesh.size = Vector2(12, 12)
	floor_.position.y = -0.01
	viewport.add_child(floor_)
	var sun: DirectionalLight3D = viewport.find_children("*", "DirectionalLight3D", true, false)[0]
	sun.shadow_enabled = true
	sun.look_at_from_position(Vector3.ZERO, Vector3(1, -0.5, 0))  # low, so that shadows fall beside the field
	look(Vector3(3.2, 2, 0), Vector3(2.9, 0, 0))
	var field := add_seen_field()
	await drawn()
	var beside := Rect2i(SIZE.x / 4, SIZE.y / 4, SIZE.x / 2, SIZE.y / 5)
	var lit := mean((await next_picture()).get_region(beside)).get_luminance()
	field.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_ON
	var shaded := mean((await picture()).get_region(beside)).get_luminance()
	print("    beside the field: %.3f lit, %.3f in its shadow" % [lit, shaded])
	assert_less(shaded, 0.985 * lit)


func test_colors_reach_the_picture() -> void:
	var field := add_seen_field({species = kind({dry = 0.0}), clump_tint = 0.0})
	var green := mean(await picture())
	field.species[0].tip_color = Color(0.9, 0.05, 0.05)
	field.species[0].root_color = Color(0.5, 0.02, 0.02)
	var red := mean(await picture())
	assert_greater(red.r, green.r + 0.05)
	assert_less(red.g, green.g)
