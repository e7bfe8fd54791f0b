# SPDX-License-Identifier: MIT
## The picture of a GrassWorld: blades grow on both sides of a plot's border, and where a map that a thread prepared has grass. Runs in
## every renderer.
extends "res://tests/view_case.gd"

const FOLDER := "user://test_seen_world"


func before() -> void:
	open_view(Vector2i(640, 360))
	add_light()
	DirAccess.make_dir_recursive_absolute(FOLDER)
	camera.far = 2000.0


func after() -> void:
	remove_folder(FOLDER)


func add_world(properties := {}) -> GrassWorld:
	var field := GrassField.new()
	field.wind_speed = 0.0
	field.pool_tiles = 128
	for property: String in properties:
		field.set(property, properties[property])
	var scene := PackedScene.new()
	scene.pack(field)
	field.free()
	var world := GrassWorld.new()
	world.plot_size = 128.0
	world.camera_radius = 60.0
	world.plot_scene = scene
	world.folder = FOLDER
	viewport.add_child(world)
	return world


func loaded(world: GrassWorld) -> void:
	await super(world)
	await drawn()


func test_plots_are_drawn_as_they_were_painted() -> void:
	var bare := full_map()
	bare.stroke(brush(GrassBrush.TOOL_DENSITY, 64.0, {target = 0.0}), Vector2(-30, -30), Vector2(30, 30))
	ResourceSaver.save(bare, FOLDER.path_join("plot_8_0.grassmap"))
	var world := add_world()
	look(Vector3(64, 6, 30), Vector3(64, 0, 0))
	await loaded(world)
	var here := await picture()
	save(here, "world")
	assert_greater(share_of(here, is_green), 0.4)
	camera.position.x += 1024.0  # the fields that stood there serve here
	await loaded(world)
	var there := await picture()
	save(there, "world_painted")
	assert_less(share_of(there, is_green), 0.6 * share_of(here, is_green), "the middle of the plot is bare")
	var fields_made: int = world.get_statistics().fields_made
	camera.position.x -= 1024.0
	await loaded(world)
	assert_less(difference(here, await picture()).y, 0.002, "as before")
	assert_eq(world.get_statistics().fields_made, fields_made)


## Mean colours of the ground from x to x + 1, one for each metre of z, from a picture that shows 128 m x 72 m from above.
func strip(image: Image, x: float) -> Array[Color]:
	var found: Array[Color] = []
	var left := int(320 + 5 * (x - 128.0))
	for row in 72:
		var sum := Color(0, 0, 0, 0)
		for j in 5:
			for i in 5:
				sum += image.get_pixel(left + i, row * 5 + j)
		found.append(sum / 25.0)
	return found


func apart(a: Array[Color], b: Array[Color]) -> float:
	var sum := 0.0
	for i in a.size():
		sum += (absf(a[i].r - b[i].r) + absf(a[i].g - b[i].g) + absf(a[i].b - b[i].b)) / 3.0
	return sum / a.size()


## From above, with stands of two colours and large clumps: the border of two plots is no line.
func test_clumps_and_stands_are_not_cut_at_a_border() -> void:
	var green := GrassSpecies.new()
	var red := GrassSpecies.new()
	for color: String in ["root_color", "tip_color", "dry_color"]:
		red.set(color, Color(0.7, 0.15, 0.05))
	for species: GrassSpecies in [green, red]:
		species.stand_strength = 1.0
		species.stand_size = 7.0
	add_world({species = [green, red], clump_size = 9.0, density = 64.0})
	camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	camera.size = 72.0
	look(Vector3(128, 40, 64), Vector3(128, 0, 64))
	await loaded(viewport.get_child(-1))
	var seen := await picture()
	save(seen, "world_border")
	var across := apart(strip(seen, 127.0), strip(seen, 128.0))
	var beside := 0.0
	for x in range(112, 145):
		if absi(x - 128) > 1:
			beside = maxf(beside, apart(strip(seen, x - 1.0), strip(seen, x)))
	var far := apart(strip(seen, 112.0), strip(seen, 143.0))
	print("    a metre across the border %.4f, others %.4f at most, 31 m %.4f" % [across, beside, far])
	assert_less(across, 1.2 * beside, "no more than between any other two metres")
	assert_less(across, 0.7 * far, "there are stands and clumps")
