# SPDX-License-Identifier: MIT
## A GrassWorld in the edited scene: its plots stand around the editor's camera, the brush paints across them, and they are written with
## the scene, and not before.
@tool
extends "res://tests/editor/editor_case.gd"

const DRAWN := ["test_a_picture_of_a_stroke_across_plots"]  # see runner.gd
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
	made.radius = 20.0
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


func test_a_stroke_across_plots_is_one_step() -> void:
	assert_true(toolbar.visible, "for a world, too")
	assert_true(world.get_field_at(LEFT) != world.get_field_at(RIGHT), "two plots")
	check(false, "at first")
	assert_false(is_marked_unsaved())
	await erase_across()
	check(true, "painted")
	assert_true(is_marked_unsaved(), "the scene is not saved")
	assert_eq(world.get_statistics().changed, 2)
	await undo()
	check(false, "undone, in one step")
	assert_eq(world.get_statistics().changed, 0, "as it was")
	await redo()
	check(true, "done again")
	await press_and_move()
	await key(KEY_ESCAPE)
	await button(MOUSE_BUTTON_LEFT, false, at(Vector3.ZERO))
	await undo()
	check(false, "escape made no step of its own")


func test_the_edge_that_a_neighbour_shows_is_painted_too() -> void:
	await take("Erase")
	set_number("Strength", 1.0)
	set_number("Hardness", 1.0)
	set_number("Radius", 0.5)
	await stroke([Vector3(0.5, 0, 0.5), Vector3(0.5, 0, 1.0)])  # its rim lies on the border
	assert_less(density_there(Vector3(0.5, 0, 0.75)), 0.1)
	var left := world.get_field_at(Vector3(-1, 0, 0.75))
	var local := left.to_local(Vector3(0.5, 0, 0.75))
	assert_less(left.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(local.x, local.z)), 0.1, "what its last blades blend with")
	assert_eq(density_there(Vector3(-0.75, 0, 0.75)), 1.0)


func test_painted_plots_are_written_with_the_scene_and_not_before() -> void:
	await erase_across()
	await frames(20)
	assert_eq(files().size(), 0, "not before")
	EditorInterface.save_scene()
	assert_eq(files(), PackedStringArray(["plot_-1_0.grassmap", "plot_0_0.grassmap"]), "those that were painted")
	await frames(2)
	assert_false(is_marked_unsaved())
	assert_eq(world.get_statistics().changed, 0)
	await undo()
	assert_true(is_marked_unsaved(), "undone after it was saved")
	EditorInterface.save_scene()
	var written := _map_of(Vector2i(0, 0))
	assert_eq(written.sample(GrassMap.CHANNEL_DENSITY, IN_PLOT), 1.0, "as it was")
	await redo()
	EditorInterface.save_scene()
	await open_world()
	check(true, "read from the files")


func test_painted_plots_are_written_with_a_scene_that_gets_another_name() -> void:
	const COPY := "res://tests/editor/world_copy.tscn"
	await erase_across()
	EditorInterface.save_scene_as(COPY)
	assert_eq(files().size(), 2)
	assert_eq(world.get_statistics().changed, 0)


func test_a_plot_that_leaves_keeps_its_edits_until_the_scene_is_saved() -> void:
	await erase_across()
	await go_away()
	assert_eq(world.get_statistics().files_kept, 2, "not lost")
	assert_eq(files().size(), 0, "and not written")
	await come_back()
	check(true, "it came back")
	await go_away()
	EditorInterface.save_scene()
	assert_eq(files().size(), 2, "saved while they are away")
	assert_eq(world.get_statistics().files_kept, 0)
	await come_back()
	check(true, "from the files")


func test_undo_and_redo_of_plots_that_left() -> void:
	await erase_across()
	await go_away()
	await undo()
	await come_back()
	check(false, "undone while they were away")
	await go_away()
	await redo()
	await come_back()
	check(true, "done again while they were away")
	await undo()
	check(false, "undone after they came back")
	await redo()
	await go_away()
	await undo()
	EditorInterface.save_scene()
	assert_eq(_map_of(Vector2i(0, 0)).sample(GrassMap.CHANNEL_DENSITY, IN_PLOT), 1.0, "and saved so")


func test_plots_that_leave_while_they_are_painted() -> void:
	await take("Erase")
	set_number("Strength", 1.0)
	await move(at(ACROSS[0]))
	await button(MOUSE_BUTTON_LEFT, true, at(ACROSS[0]))
	for place: Vector3 in ACROSS:
		await move(at(place), MOUSE_BUTTON_MASK_LEFT)
	await go_away()
	await button(MOUSE_BUTTON_LEFT, false, at(ACROSS[3]))
	await come_back()
	check(true, "the stroke is done")
	await undo()
	check(false, "and can be undone")


func test_another_scene_in_between_loses_nothing() -> void:
	await erase_across()
	DirAccess.copy_absolute(SCENE, SAVED)
	await open(SAVED)
	assert_eq(files().size(), 0)
	await open_scene_again(WORLD)
	check(true, "after another scene")
	await undo()
	check(false, "its history, too")


## As a click on its tab does.
func open_scene_again(path: String) -> void:
	EditorInterface.open_scene_from_path(path)
	await frames(4)
	world = EditorInterface.get_edited_scene_root().get_node("World")
	await loaded()
	await select(world)


func test_without_a_folder_the_user_is_told() -> void:
	world.folder = ""
	await loaded()
	await erase_across()
	EditorInterface.save_scene()
	await frames(2)
	assert_true(find_toast("Set the world's `folder`"))
	check(true, "still there")
	world.folder = FOLDER
	await loaded()
	check(false, "it belongs to no folder")
	await answer("Bring Over")
	check(true, "also with a folder")
	EditorInterface.save_scene()
	assert_eq(files().size(), 2)


## What the user answers to the question what becomes of plots that are not saved.
func answer(words: String) -> void:
	var dialog: ConfirmationDialog = get_tree().root.find_child("GrassKeptPlots", true, false)
	await wait_until(func() -> bool: return dialog.visible, "the editor asks")
	for pressed: Button in dialog.find_children("*", "Button", true, false):
		if pressed.text == words:
			pressed.pressed.emit()
	await frames(2)
	assert_false(dialog.visible, words)
	await loaded()


func test_edits_are_saved_to_the_folder_that_they_were_painted_for() -> void:
	await erase_across()
	world.folder = OTHER
	await loaded()
	await answer("Keep")
	check(false, "another folder's")
	EditorInterface.save_scene()
	assert_eq(files().size(), 2, "where they belong")
	assert_eq(files(OTHER).size(), 0)
	world.folder = FOLDER
	await loaded()
	check(true, "there again")
	await undo()
	world.folder = OTHER
	await loaded()
	await answer("Discard")
	assert_false(world.get_statistics().files_kept > 0)
	world.folder = FOLDER
	await loaded()
	check(true, "as it was saved")


func find_toast(text: String) -> bool:
	for label: Label in get_tree().root.find_children("*", "Label", true, false):
		if label.text.contains(text):
			return true
	return false


func test_ground_is_baked_into_plots() -> void:
	var floor := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = BoxShape3D.new()
	shape.shape.size = Vector3(20, 1, 20)
	floor.add_child(shape)
	EditorInterface.get_edited_scene_root().add_child(floor)  # its top lies at 0.5 m
	floor.owner = EditorInterface.get_edited_scene_root()
	await frames(3)
	await click(toolbar.get_node("Bake"))
	for place: Vector3 in [LEFT, RIGHT]:
		var plot := world.get_field_at(place)
		var local := plot.to_local(place)
		assert_near(plot.map.sample(GrassMap.CHANNEL_GROUND, Vector2(local.x, local.z)), 0.5, 0.01)
	await undo()
	assert_eq(world.get_statistics().changed, 0, "one step for all plots")
	world.position.x += 64.0  # fields serve other plots; they are no fields of the scene that were moved
	await loaded()
	await frames(60)
	assert_eq(world.get_statistics().changed, 0, "no ground is read by itself")


func test_asking_and_what_is_not_offered() -> void:
	await click(toolbar.get_node("Why"))
	await move(at(RIGHT))
	var answer: Control = get_tree().root.find_child("GrassAnswer", true, false)
	assert_true(answer.visible)
	await erase_across()
	await click(toolbar.get_node("Why"))
	await move(at(RIGHT + Vector3(0.1, 0, 0)))
	assert_true((answer.get_child(0) as Label).text.contains("painted"), (answer.get_child(0) as Label).text)
	var menu := (toolbar.get_node("Menu") as MenuButton).get_popup()
	assert_true(menu.is_item_disabled(menu.get_item_index(0)), "a world in memory is a part of it only")
	await select(field)
	assert_false(menu.is_item_disabled(menu.get_item_index(0)))


func test_a_picture_of_a_stroke_across_plots() -> void:
	world.plot_scene = pattern(100.0)
	await loaded()
	set_number("Radius", 0.6)
	await erase_across()
	await move(at(Vector3(0, 0, -0.8)))
	await frames(4)
	await shoot("world_painting")


func _map_of(plot: Vector2i) -> GrassMap:
	var path := FOLDER.path_join("plot_%d_%d.grassmap" % [plot.x, plot.y])
	return ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE)
