# SPDX-License-Identifier: MIT
## A GrassWorld in the edited scene: its plots stand around the editor's camera, and nothing is written unless a tool says so.
@tool
extends "res://tests/editor/editor_case.gd"

const FOLDER := "user://test_editor_world"
const WORLD := "res://tests/editor/world.tscn"

var world: GrassWorld


func before() -> void:
	var root := Node3D.new()
	root.name = "Root"
	var made := GrassWorld.new()
	made.name = "World"
	made.plot_size = 64.0
	made.radius = 40.0
	made.folder = FOLDER
	root.add_child(made)
	made.owner = root
	var field := GrassField.new()  # the case wants one
	field.name = "Field"
	root.add_child(field)
	field.owner = root
	var scene := PackedScene.new()
	scene.pack(root)
	root.free()
	ResourceSaver.save(scene, WORLD)
	await open(WORLD)
	world = EditorInterface.get_edited_scene_root().get_node("World")
	await wait_until(func() -> bool: return not world.get_fields().is_empty() and world.get_statistics().waiting == 0, "plots stand")


func after() -> void:
	await super()
	for file in files():
		DirAccess.remove_absolute(FOLDER.path_join(file))


func files() -> PackedStringArray:
	return DirAccess.get_files_at(FOLDER) if DirAccess.dir_exists_absolute(FOLDER) else PackedStringArray()


func test_nothing_is_written_by_itself() -> void:
	var field: GrassField = world.get_fields()[0]
	var place := field.global_position
	var clear := GrassBrush.new()
	clear.tool = GrassBrush.TOOL_DENSITY
	clear.target = 0.0
	clear.strength = 1.0
	assert_ne(world.paint(clear, place, place), 0.0)
	assert_true(field.owner == null, "no plot is saved within the scene")
	EditorInterface.save_scene()
	await frames(3)
	assert_eq(files().size(), 0, "the scene is saved, the map is not")
	world.position.x += 3000.0  # all plots leave, and others come
	await wait_until(func() -> bool: return world.get_statistics().files_kept == 1, "the painted plot has left, and is not lost")
	assert_eq(files().size(), 0)
	assert_eq(world.save(), 1)
	world.wait_for_files()
	assert_eq(files().size(), 1)
