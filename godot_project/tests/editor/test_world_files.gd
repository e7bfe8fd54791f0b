# SPDX-License-Identifier: MIT
## Plots painted in the editor are saved with the scene, and not before, to the folder for which they were painted.
@tool
extends "res://tests/editor/world_case.gd"


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


func test_the_editor_learns_of_files_that_are_new() -> void:
	const IN_PROJECT := "res://tests/editor/plots"
	world.folder = IN_PROJECT
	await loaded()
	await erase_across()
	EditorInterface.save_scene()
	var known := EditorInterface.get_resource_filesystem()
	await wait_until(func() -> bool: return known.get_file_type(IN_PROJECT.path_join("plot_0_0.grassmap")) != "", "it is known")
	for file in files(IN_PROJECT):
		DirAccess.remove_absolute(IN_PROJECT.path_join(file))


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
