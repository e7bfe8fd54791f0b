# SPDX-License-Identifier: MIT
## Several cameras of one world each see the right tiles, and the shadows of tiles that none of them sees.
extends "res://tests/view_case.gd"

const SIZE := Vector2i(128, 72)

var other: SubViewport
var other_camera: Camera3D


func before() -> void:
	open_view(SIZE)
	add_light()


## A second viewport of the first one's world, off at first.
func open_other_view() -> void:
	other = SubViewport.new()
	other.size = SIZE
	other.world_3d = viewport.find_world_3d()
	other.render_target_update_mode = SubViewport.UPDATE_DISABLED
	add_child(other)
	other_camera = Camera3D.new()
	other_camera.far = 100.0
	other.add_child(other_camera)


func picture_of(view: SubViewport) -> Image:
	await drawn()
	await RenderingServer.frame_post_draw
	return view.get_texture().get_image()


func test_a_split_screen_shows_grass_on_both_sides() -> void:
	open_other_view()
	var field := add_seen_field({size = Vector2(12, 12)})
	look(Vector3(0, 1.2, -1), Vector3(0, 0.2, -8))  # no tile is in both views, where the other camera might ask for more
	other_camera.look_at_from_position(Vector3(0, 1.2, 1), Vector3(0, 0.2, 8))
	var one := await picture_of(viewport)
	var tiles_one: int = field.get_statistics().drawn_tiles
	viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED
	other.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	var two := await picture_of(other)
	var tiles_two: int = field.get_statistics().drawn_tiles
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	var one_of_both := await picture_of(viewport)
	var two_of_both := await picture_of(other)
	var tiles_both: int = field.get_statistics().drawn_tiles
	var green := [share_of(one, is_green), share_of(two, is_green)]
	var off := [difference(one, one_of_both).y, difference(two, two_of_both).y]
	print(
		(
			"    tiles %d and %d alone, %d together; green %.2f, %.2f; mean difference %.5f, %.5f"
			% [tiles_one, tiles_two, tiles_both, green[0], green[1], off[0], off[1]]
		)
	)
	for i in 2:
		assert_greater(green[i], 0.3, "grass in view %d" % i)
		assert_less(off[i], 0.002, "view %d, alone and beside the other" % i)
	assert_greater(tiles_both, maxi(tiles_one, tiles_two))
	assert_true(tiles_both <= tiles_one + tiles_two)
	field.backend = GrassField.BACKEND_CPU
	await drawn()
	assert_eq(field.get_statistics().drawn_tiles, tiles_both, "the CPU backend chooses the same tiles")


func test_a_camera_far_away_does_not_coarsen_the_near_one() -> void:
	open_other_view()
	var field := add_seen_field()
	look(Vector3(0, 0.8, 2), Vector3(0, 0, 0))
	var alone := await picture_of(viewport)
	var blades: int = field.get_statistics().drawn_blades
	other_camera.look_at_from_position(Vector3(0, 30, 60), Vector3.ZERO)
	other.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	var beside := await picture_of(viewport)
	assert_true(field.get_statistics().drawn_blades >= blades)
	assert_less(difference(alone, beside).y, 0.002)
	other_camera.free()
	await drawn()
	assert_eq(field.get_statistics().drawn_blades, blades, "the other camera is gone")


func test_another_world_s_camera_does_not_count() -> void:
	var field := add_seen_field()
	await drawn()
	var before: Dictionary = field.get_counters()
	open_other_view()
	other.world_3d = World3D.new()
	other.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	await drawn()
	assert_eq(field.get_counters().culls, before.culls)


## A minimap's camera, which leaves the grass out: nothing more is drawn, nor casts a shadow, nor is simulated for it.
func test_a_camera_that_leaves_out_the_field_s_layers_does_not_count() -> void:
	var keys := ["drawn_tiles", "drawn_blades", "drawn_triangles", "shadow_tiles", "culls"]
	var sun: DirectionalLight3D = viewport.find_children("*", "DirectionalLight3D", true, false)[0]
	sun.shadow_enabled = true
	open_other_view()
	var field := add_seen_field({size = Vector2(20, 20), layers = 2, cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_ON})
	camera.cull_mask = 3
	look(Vector3(0, 1.2, 0), Vector3(0, 0.2, -4))
	await drawn()
	var alone := field.get_statistics().merged(field.get_counters())
	assert_greater(alone.drawn_tiles, 0)
	assert_greater(alone.shadow_tiles, 0)
	other_camera.cull_mask = 1
	other_camera.look_at_from_position(Vector3(0, 1.2, 0), Vector3(0, 0.2, 4))  # what the first one does not see
	other.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	await drawn()
	for key: String in keys:
		assert_eq(field.get_statistics().merged(field.get_counters())[key], alone[key], key)
	other_camera.cull_mask = 3
	await drawn()
	assert_greater(field.get_statistics().drawn_tiles, alone.drawn_tiles, "a camera that shows it counts")
	other_camera.cull_mask = 1
	await drawn()
	assert_eq(field.get_statistics().drawn_tiles, alone.drawn_tiles, "and no longer")
	camera.cull_mask = 1
	await drawn()
	assert_eq(field.get_statistics().drawn_tiles, 0, "no camera shows it")
	assert_eq(field.get_counters().shadow_tiles, 0, "no camera shows its shadow")
	var before := field.get_counters()
	await ticks(5)
	var after_ := field.get_counters()
	var visits: int = after_.visited_ticks - before.visited_ticks
	assert_less(visits - (after_.unseen_ticks - before.unseen_ticks), 2, "nothing is simulated that no camera shows")
	field.layers = 1
	await drawn()
	assert_greater(field.get_statistics().drawn_tiles, alone.drawn_tiles, "both show its new layers")


func test_a_sun_whose_shadows_leave_out_the_field_throws_none() -> void:
	var sun: DirectionalLight3D = viewport.find_children("*", "DirectionalLight3D", true, false)[0]
	sun.shadow_enabled = true
	sun.look_at_from_position(Vector3.ZERO, Vector3(0, -0.2, 1))
	var field := add_seen_field({size = Vector2(6, 6), shadow_margin = 0.0, cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_ON})
	look(Vector3(0, 1.4, 4.5), Vector3(0, 0, 5.0))  # all that it sees of the grass is shadow
	await drawn()
	assert_greater(field.get_counters().shadow_tiles, 0)
	sun.shadow_caster_mask = 2
	await drawn()
	assert_eq(field.get_counters().shadow_tiles, 0)


func test_an_orthogonal_camera_thins_by_its_pixels() -> void:
	var field := add_seen_field()
	camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	look(Vector3(0, 20, 0), Vector3.ZERO)
	camera.size = 0.5
	await drawn()
	var near: Dictionary = field.get_statistics()
	camera.size = 6.0
	await drawn()
	var far: Dictionary = field.get_statistics()
	assert_greater(float(near.drawn_blades) / near.drawn_tiles, 30.0, "blades a tile, 7 mm a pixel")
	assert_less(float(far.drawn_blades) / far.drawn_tiles, 12.0, "blades a tile, 83 mm a pixel")
	camera.size = 0.5
	look(Vector3(0, 95, 0), Vector3.ZERO)
	await drawn()
	var high: Dictionary = field.get_statistics()
	assert_near(float(high.drawn_blades) / high.drawn_tiles, float(near.drawn_blades) / near.drawn_tiles, 0.5, "however far it stands")


## The sun stands low behind the camera, which stands at the field's end and looks away from it: all that it sees of the
## grass is shadow.
func test_tiles_behind_the_camera_cast_their_shadows() -> void:
	var floor_ := MeshInstance3D.new()
	floor_.mesh = PlaneMesh.new()
	floor_.mesh.size = Vector2(20, 20)
	floor_.position.y = -0.01
	viewport.add_child(floor_)
	var sun: DirectionalLight3D = viewport.find_children("*", "DirectionalLight3D", true, false)[0]
	sun.shadow_enabled = true
	sun.directional_shadow_max_distance = 20.0
	sun.look_at_from_position(Vector3.ZERO, Vector3(0, -0.2, 1))
	look(Vector3(0, 1.4, 4.5), Vector3(0, 0, 5.0))
	var field := add_seen_field({size = Vector2(6, 6), shadow_margin = 0.0})
	var lit := await picture_of(viewport)
	field.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_ON
	var shaded := await picture_of(viewport)
	var few: int = field.get_counters().shadow_tiles
	assert_eq(field.get_statistics().drawn_tiles, 0, "no tile is seen")
	field.shadow_margin = 50.0
	var all := await picture_of(viewport)
	var many: int = field.get_counters().shadow_tiles
	print(
		(
			"    shadows darken by %.4f; %d tiles cast them, %d more change %.5f"
			% [difference(lit, shaded).y, few, many - few, difference(shaded, all).y]
		)
	)
	assert_greater(difference(lit, shaded).y, 0.001, "shadows are seen")
	assert_less(difference(shaded, all).y, 1e-4, "none is missing")
	assert_less(few, many, "tiles whose shadow cannot be seen cast none")
	sun.shadow_enabled = false
	field.shadow_margin = 0.0
	await drawn()
	assert_eq(field.get_counters().shadow_tiles, 0, "without a light that casts shadows")


func test_no_shadow_beyond_its_distance() -> void:
	var field := add_seen_field({cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_ON, size = Vector2(20, 20), shadow_distance = 5.0})
	look(Vector3(0, 1.5, 9), Vector3(0, 0, 0))
	await drawn()
	var near: Dictionary = field.get_statistics().merged(field.get_counters())
	field.shadow_distance = 1000.0
	await drawn()
	var far: Dictionary = field.get_statistics().merged(field.get_counters())
	assert_greater(near.shadow_tiles, 5)
	assert_less(near.shadow_tiles * 2, far.shadow_tiles)
	assert_less(far.shadow_triangles * 1.5, far.drawn_triangles, "shadows are coarser than the picture")
	field.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	await drawn()
	assert_eq(field.get_counters().shadow_tiles, 0)
	assert_eq(field.get_statistics().drawn_tiles, far.drawn_tiles)
