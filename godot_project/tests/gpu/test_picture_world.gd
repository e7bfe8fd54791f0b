# SPDX-License-Identifier: MIT
## A GrassWorld that is drawn: blades stand on both sides of a plot's border, and where a map that a thread prepared says so. Runs in
## every renderer.
extends "res://tests/view_case.gd"

const FOLDER := "user://test_seen_world"
const PICTURES := "user://pictures/"  # looked at by people


func before() -> void:
	open_view(Vector2i(640, 360))
	add_light()
	DirAccess.make_dir_recursive_absolute(PICTURES)
	DirAccess.make_dir_recursive_absolute(FOLDER)
	camera.far = 2000.0


func after() -> void:
	for file in DirAccess.get_files_at(FOLDER):
		DirAccess.remove_absolute(FOLDER.path_join(file))


func add_world() -> GrassWorld:
	var field := GrassField.new()
	field.wind_speed = 0.0
	field.pool_tiles = 128
	var scene := PackedScene.new()
	scene.pack(field)
	field.free()
	var world := GrassWorld.new()
	world.plot_size = 128.0
	world.radius = 60.0
	world.plot_scene = scene
	world.folder = FOLDER
	viewport.add_child(world)
	return world


func loaded(world: GrassWorld) -> void:
	var calm := [0]
	await wait_until(
		func() -> bool:
			var now := world.get_statistics()
			calm[0] = calm[0] + 1 if now.waiting == 0 and now.files_waiting == 0 and now.plots > 0 else 0
			return calm[0] > 4,
		"all plots are loaded"
	)
	await drawn()


func test_plots_are_drawn_as_they_were_painted() -> void:
	var bare := full_map()
	bare.stroke(brush(GrassBrush.TOOL_DENSITY, 64.0, {target = 0.0}), Vector2(-30, -30), Vector2(30, 30))
	ResourceSaver.save(bare, FOLDER.path_join("plot_8_0.grassmap"))
	var world := add_world()
	look(Vector3(64, 6, 30), Vector3(64, 0, 0))
	await loaded(world)
	var here := await picture()
	here.save_png(PICTURES + "world_%s.png" % RenderingServer.get_current_rendering_method())
	assert_greater(share_of(here, is_green), 0.5)
	camera.position.x += 1024.0  # the fields that stood there serve here
	await loaded(world)
	var there := await picture()
	there.save_png(PICTURES + "world_painted_%s.png" % RenderingServer.get_current_rendering_method())
	assert_less(share_of(there, is_green), 0.6 * share_of(here, is_green), "the middle of the plot is bare")
	var fields_made: int = world.get_statistics().fields_made
	camera.position.x -= 1024.0
	await loaded(world)
	assert_less(difference(here, await picture()).y, 0.002, "as before")
	assert_eq(world.get_statistics().fields_made, fields_made)
