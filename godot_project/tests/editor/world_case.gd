# SPDX-License-Identifier: MIT
## A GrassWorld in the edited scene, for the tests of worlds in the editor: two plots in view, and a folder for their files.
@tool
extends "res://tests/editor/editor_case.gd"

const FOLDER := "user://test_editor_world"
const OTHER := "user://test_editor_world_other"
const WORLD := "res://tests/editor/world.tscn"
const ACROSS: Array = [Vector3(-1.5, 0, 0.6), Vector3(-0.5, 0, 0.6), Vector3(0.5, 0, 0.6), Vector3(1.5, 0, 0.6)]
const LEFT := Vector3(-1.0, 0, 0.6)  # under the stroke, in plot (-1, 0)
const RIGHT := Vector3(1.0, 0, 0.6)  # and in plot (0, 0)
const IN_PLOT := Vector2(1.0 - 32.0, 0.6)  # the same, from the plot's centre
const FAR := 3000.0  # metres: all plots leave, and others come

var world: GrassWorld


func before() -> void:
	empty_folder()
	var root := Node3D.new()
	root.name = "Root"
	var made := GrassWorld.new()
	made.name = "World"
	made.plot_size = 64.0
	made.camera_radius = 20.0
	made.position = Vector3(0, 0, -32)  # the border of two plots runs through the middle of the view
	made.folder = FOLDER
	made.plot_scene = pattern(4.0)
	root.add_child(made)
	made.owner = root
	var other := GrassField.new()  # the case wants one
	other.name = "Field"
	other.size = Vector2(2, 2)
	other.position = Vector3(0, 0, 400)
	root.add_child(other)
	other.owner = root
	var scene := PackedScene.new()
	scene.pack(root)
	root.free()
	ResourceSaver.save(scene, WORLD)
	await open_world()
	reset_brush()


func after() -> void:
	await super()
	empty_folder()


func open_world() -> void:
	await open(WORLD)
	world = EditorInterface.get_edited_scene_root().get_node("World")
	await loaded()
	await select(world)


## Few blades are quickly drawn.
func pattern(density_of_plots: float) -> PackedScene:
	var plot := GrassField.new()
	plot.name = "Plot"
	plot.density = density_of_plots
	plot.wind_speed = 0.0
	var scene := PackedScene.new()
	scene.pack(plot)
	plot.free()
	return scene


func empty_folder() -> void:
	for folder: String in [FOLDER, OTHER]:
		for file in files(folder):
			DirAccess.remove_absolute(folder.path_join(file))
		DirAccess.remove_absolute(folder.path_join(".plot_size"))


func files(folder := FOLDER) -> PackedStringArray:
	return DirAccess.get_files_at(folder) if DirAccess.dir_exists_absolute(folder) else PackedStringArray()


func loaded() -> void:
	await wait_until(
		func() -> bool:
			var now := world.get_statistics()
			return now.plots > 0 and now.waiting == 0 and now.files_waiting == 0,
		"plots stand"
	)


## Takes all plots out of memory.
func go_away() -> void:
	world.position.x = FAR
	await wait_until(
		func() -> bool: return world.get_field(Vector2i(-1, 0)) == null and world.get_field(Vector2i(0, 0)) == null, "they leave"
	)
	await loaded()


func come_back() -> void:
	world.position.x = 0.0
	await wait_until(
		func() -> bool: return world.get_field(Vector2i(-1, 0)) != null and world.get_field(Vector2i(0, 0)) != null, "they come"
	)
	await loaded()


func density_there(place: Vector3) -> float:
	var plot := world.get_field_at(place)
	var local := plot.to_local(place)
	return plot.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(local.x, local.z))


func check(is_painted: bool, what: String) -> void:
	for place: Vector3 in [LEFT, RIGHT]:
		if is_painted:
			assert_less(density_there(place), 0.3, "%s, at %s" % [what, place])
		else:
			assert_eq(density_there(place), 1.0, "%s, at %s" % [what, place])


func erase_across() -> void:
	await take("Erase")
	set_number("Strength", 1.0)
	await stroke(ACROSS)


## On its tab.
func is_marked_unsaved() -> bool:
	for tabs: TabBar in get_tree().root.find_children("*", "TabBar", true, false):
		for i in tabs.tab_count:
			if tabs.get_tab_title(i) == "world(*)":
				return true
	return false


func _map_of(plot: Vector2i) -> GrassMap:
	var path := FOLDER.path_join("plot_%d_%d.grassmap" % [plot.x, plot.y])
	return ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE)
