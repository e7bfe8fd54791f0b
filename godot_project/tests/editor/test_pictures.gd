# SPDX-License-Identifier: MIT
## The menu's items for pictures of a field's map. The dialog's answer is given as the dialog reports it.
@tool
extends "res://tests/editor/editor_case.gd"

const FOLDER := "user://editor_pictures/"
const EXPORT := 5  # in the menu
const IMPORT := 6

var dialog: FileDialog


func before() -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER)
	await super()


func after() -> void:
	remove_folder(FOLDER)
	await super()


## Chooses the menu's item, a channel and a file.
func answer(item: int, of: GrassMap.Channel, file: String) -> void:
	(toolbar.get_node("Menu") as MenuButton).get_popup().id_pressed.emit(item)
	dialog = get_tree().root.find_child("GrassPictureDialog", true, false)
	await frames(2)
	assert_true(dialog.visible, "it asks")
	dialog.get_selected_options()["Channel"] = of
	dialog.hide()
	dialog.file_selected.emit(FOLDER + file)
	await frames(2)


func test_a_channel_goes_out_and_comes_in_as_one_step() -> void:
	await take("Erase")
	await stroke([Vector3(-1, 0, 0), Vector3(1, 0, 0)])
	var painted := field.map.data
	await answer(EXPORT, GrassMap.CHANNEL_DENSITY, "density.png")
	var image := Image.load_from_file(FOLDER + "density.png")
	assert_eq(Vector2(image.get_size()), field.size * 2.0, "two texels a metre")
	assert_near(image.get_pixelv(image.get_size() / 2).r, density(0.25, 0.25), 0.003)
	await answer(IMPORT, GrassMap.CHANNEL_DENSITY, "density.png")
	assert_eq(field.map.data, painted, "the same")
	image.fill(Color.BLACK)
	image.save_png(FOLDER + "density.png")
	await answer(IMPORT, GrassMap.CHANNEL_DENSITY, "density.png")
	assert_eq(density(5, 5), 0.0, "bare")
	await undo()
	assert_eq(field.map.data, painted, "undone")
	await redo()
	assert_eq(density(5, 5), 0.0)
	await undo()
	await answer(EXPORT, GrassMap.CHANNEL_HEIGHT, "height.exr")
	image.load(FOLDER + "height.exr")
	assert_eq(Vector2(image.get_size()), field.size, "one a metre")
	assert_eq(image.get_pixel(3, 3).r, 1.0)
	await answer(IMPORT, GrassMap.CHANNEL_DENSITY, "height.exr")  # of another size: refused, in words
	assert_eq(field.map.data, painted)


func test_a_field_without_a_map_gets_one() -> void:
	field.map = null
	var mask := Image.create(int(field.size.x) * 2, int(field.size.y) * 2, false, Image.FORMAT_L8)
	mask.save_png(FOLDER + "mask.png")
	await answer(EXPORT, GrassMap.CHANNEL_DENSITY, "none.png")
	assert_false(FileAccess.file_exists(FOLDER + "none.png"), "nothing to export")
	mask.resize(8, 8)
	mask.save_png(FOLDER + "small.png")
	await answer(IMPORT, GrassMap.CHANNEL_DENSITY, "small.png")
	assert_true(field.map == null, "refused")
	await answer(IMPORT, GrassMap.CHANNEL_DENSITY, "mask.png")
	assert_eq(density(0, 0), 0.0)
	assert_eq(density(5, 5), 0.0)
