# SPDX-License-Identifier: MIT
## More tiles in view than there is room for: the field leaves out the same far tiles in every frame, evenly spread, and reports it.
extends "res://tests/view_case.gd"

const ROOM := 256
# 1,024 tiles of 1 m. Without ground blades do not end, however far away.
const MANY := {size = Vector2(32, 32), density = 64.0, drawn_tiles_max = ROOM, soil_enabled = false}
const FAR := Vector3(0, 120, 160)  # from there all tiles are of one segment


func before() -> void:
	open_view(Vector2i(160, 90))
	camera.far = 500.0
	camera.fov = 15.0
	look(FAR, Vector3.ZERO)


func test_what_has_room_is_drawn_and_the_rest_is_counted() -> void:
	expect_error("More tiles are in view than there is room for")
	var on := {cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_ON, shadow_distance = 1000.0}
	var gpu := add_seen_field(MANY.merged({}))
	var cpu := add_seen_field(MANY.merged({backend = GrassField.BACKEND_CPU}, true))
	for shadows: bool in [false, true]:
		for field: GrassField in [gpu, cpu]:
			field.cast_shadow = on.cast_shadow if shadows else GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
			field.shadow_distance = on.shadow_distance
		await drawn()
		var now := gpu.get_statistics().merged(gpu.get_counters())
		var theirs := cpu.get_statistics().merged(cpu.get_counters())
		assert_eq(now.drawn_tiles + now.left_out_tiles, 1024)
		assert_true(now.drawn_tiles <= ROOM and now.drawn_tiles > ROOM - 1024 / 64, "%d fill %d, but for a turn" % [now.drawn_tiles, ROOM])
		assert_eq(now.shadow_tiles + now.left_out_shadow_tiles, 1024 if shadows else 0)
		assert_true(now.shadow_tiles <= ROOM / 4, "%d shadows in %d" % [now.shadow_tiles, ROOM / 4])
		for number: String in ["drawn_tiles", "drawn_blades", "drawn_triangles", "left_out_tiles", "shadow_tiles", "left_out_shadow_tiles"]:
			assert_eq(now[number], theirs[number], "GPU and CPU: " + number)


func test_the_same_tiles_every_time() -> void:
	add_light()
	var field := add_seen_field(MANY)
	var first := await picture()
	assert_greater(share_of(first, is_green), 0.02)
	for i in 4:
		look(FAR + Vector3(0.1 + i, 0, 0), Vector3.ZERO)
		await drawn()
		look(FAR, Vector3.ZERO)
		var culls: int = field.get_counters().culls
		assert_eq(difference(first, await picture()), Vector2.ZERO, "after another view")
		assert_greater(field.get_counters().culls, culls, "chosen again")
	field.free()
	add_seen_field(MANY)
	assert_eq(difference(first, await picture()), Vector2.ZERO, "another field of the same kind")


func test_both_backends_leave_the_same_tiles_out() -> void:
	add_light()
	var field := add_seen_field(MANY)
	var by_gpu := await picture()
	assert_greater(share_of(by_gpu, is_green), 0.02)
	field.backend = GrassField.BACKEND_CPU
	assert_less(difference(by_gpu, await picture()).y, 0.001)


func test_what_is_left_covers_as_much_everywhere() -> void:
	add_light()
	var field := add_seen_field(MANY)
	var crowded := await picture()
	field.drawn_tiles_max = 1024
	var whole := await picture()
	assert_eq(field.get_statistics().left_out_tiles, 0)
	for part in 3:
		var stretch := Rect2i(52 + 19 * part, 30, 19, 32)  # left, middle, right of the field
		var all := share_of(whole.get_region(stretch), is_green)
		assert_greater(all, 0.15)
		assert_near(share_of(crowded.get_region(stretch), is_green) / all, 1.0, 0.35, "stretch %d" % part)


func test_near_tiles_never_lose_their_place() -> void:
	add_light()
	camera.fov = 60.0
	var field := add_seen_field(MANY.merged({size = Vector2(200, 200)}, true))
	var from := Vector3(0, 2, 90)
	look(from, Vector3(0, 0, 86))
	var crowded := await picture()
	assert_greater(field.get_statistics().left_out_tiles, 0)
	field.drawn_tiles_max = 40000
	var whole := await picture()
	assert_eq(field.get_statistics().left_out_tiles, 0)
	var below := Rect2i(0, 45, 160, 45)  # the lower half of the picture: some metres away
	assert_eq(difference(crowded.get_region(below), whole.get_region(below)), Vector2.ZERO)
	assert_greater(share_of(crowded.get_region(below), is_green), 0.1)


func test_fields_with_room_are_drawn_as_ever() -> void:
	var field := add_seen_field(MANY.merged({drawn_tiles_max = 4096}, true))  # also for all shadows
	await drawn()
	assert_eq(field.get_statistics().drawn_tiles, 1024)
	assert_eq(field.get_statistics().left_out_tiles, 0)


## While its shaders are compiled, a field is made, but not shown.
func test_a_field_that_has_more_tiles_before_it_is_shown_has_room_for_them() -> void:
	var hook := ShaderInclude.new()
	hook.code = "void grass_surface(in GrassSurface s, inout vec3 albedo, inout float roughness, inout vec3 emission) {\n\talbedo.b += 0.01;\n}\n"
	var field := add_seen_field(MANY.merged({drawn_tiles_max = 4096, density = 1.0, surface_hook = hook}, true))
	await wait_until(func() -> bool: return field.get_counters().builds == 1, "the field is made")
	if not assert_true(field.get_statistics().waiting, "not shown yet"):
		return
	field.density = MANY.density
	await drawn()
	var now := field.get_statistics().merged(field.get_counters())
	assert_eq(now.builds, 1, "what was made serves")
	assert_eq([field.get_grid_size().x * field.get_grid_size().y, now.drawn_tiles, now.left_out_tiles], [1024, 1024, 0])
