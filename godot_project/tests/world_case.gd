# SPDX-License-Identifier: MIT
## A test with a GrassWorld: folder, pattern of a plot, camera, and waiting for plots.
extends "res://tests/field_case.gd"

const FOLDER := "user://test_world"
const PLOT := 128.0
const AHEAD := 160.0

var eye: Camera3D


func before() -> void:
	empty_folder()
	eye = Camera3D.new()
	add_child(eye)
	eye.make_current()


func after() -> void:
	for child in get_children():
		if child is GrassWorld:
			child.free()
	empty_folder()


func empty_folder(folder := FOLDER) -> void:
	if not DirAccess.dir_exists_absolute(folder):
		return
	DirAccess.remove_absolute(folder.path_join(".plot_size"))
	remove_folder(folder)


## Returns a scene with a field of few blades, as a plot's pattern.
func pattern(properties := {}) -> PackedScene:
	var field := GrassField.new()
	field.wind_speed = 0.0
	field.density = 4.0
	field.pool_tiles = 128
	for property: String in properties:
		field.set(property, properties[property])
	var scene := PackedScene.new()
	scene.pack(field)
	field.free()
	return scene


func add_world(properties := {}) -> GrassWorld:
	var world := GrassWorld.new()
	world.name = "World"
	world.plot_size = PLOT
	world.camera_radius = AHEAD
	world.plot_scene = pattern()
	world.folder = FOLDER
	for property: String in properties:
		world.set(property, properties[property])
	add_child(world)
	return world


func go(world: GrassWorld, place: Vector3) -> void:
	eye.global_position = world.to_global(place) + Vector3(0, 2, 0)
	await loaded(world)


func path_of(plot: Vector2i) -> String:
	return FOLDER.path_join("plot_%d_%d.grassmap" % [plot.x, plot.y])


func store(plot: Vector2i, map: GrassMap) -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER)
	assert_eq(ResourceSaver.save(map, path_of(plot)), OK)
