# SPDX-License-Identifier: MIT
## A GrassWorld in the edited scene: its plots load around the editor's camera, and the brush paints across them.
@tool
extends "res://tests/editor/world_case.gd"

const DRAWN := ["test_a_picture_of_a_stroke_across_plots"]  # see runner.gd


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
	world.plot_scene = pattern(density_of_picture(100.0))
	await loaded()
	set_number("Radius", 0.6)
	await erase_across()
	await move(at(Vector3(0, 0, -0.8)))
	await frames(4)
	await shoot("world_painting")


func test_each_plot_has_a_picture() -> void:
	await erase_across()
	var path := "user://world_density.exr"
	var menu := (toolbar.get_node("Menu") as MenuButton).get_popup()
	var dialog: FileDialog = get_tree().root.find_child("GrassPictureDialog", true, false)
	var answer := func(item: int) -> void:
		menu.id_pressed.emit(item)
		dialog.hide()
		dialog.file_selected.emit(path)
	answer.call(5)
	await frames(2)
	var left := world.get_field_at(LEFT)
	var right := world.get_field_at(RIGHT)
	var painted: Array[PackedByteArray] = [left.map.data, right.map.data]
	answer.call(6)
	assert_eq([left.map.data, right.map.data], painted, "the same")
	var image := Image.load_from_file("user://world_density_-1_0.exr")
	assert_eq(image.get_size(), Vector2i(128, 128))
	for plot: Array in [["-1_0", 0.4], ["0_0", 0.7]]:
		image.fill(Color.WHITE * plot[1])
		image.save_exr("user://world_density_%s.exr" % plot[0])
	answer.call(6)
	await frames(2)
	assert_near(density_there(Vector3(-20, 0, -20)), 0.4, 0.003)
	assert_near(right.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(-32.25, 0)), 0.4, 0.003, "the edge that its neighbour shows")
	assert_near(left.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(32.25, 0)), 0.7, 0.003, "and the other way round")
	await undo()
	assert_eq([left.map.data, right.map.data], painted, "undone in one step")
	for file in DirAccess.get_files_at("user://"):
		if file.begins_with("world_density"):
			DirAccess.remove_absolute("user://" + file)
