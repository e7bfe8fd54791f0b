# SPDX-License-Identifier: MIT
## What the editor shows to a newcomer: warnings beside the node, species by name, an error for an export without a library.
@tool
extends "res://tests/editor/editor_case.gd"

const DRAWN := [
	"test_species_are_chosen_by_picture_and_name",
	"test_presets_have_pictures",
	"test_a_new_map_that_grows_nothing_is_said",
	"test_an_export_without_its_library_is_an_error"
]  # see runner.gd
const EXTENSION := "res://addons/grass_field/grass_field.gdextension"
const BARE := "`map` has no paint"

var _updates := 0
var _pictures: Dictionary[String, Texture2D] = {}


## The editor's list of nodes is made anew some time after a warning came or went.
func assert_warned(expected: bool, message: String) -> void:
	for i in 400:
		if (await warning()).contains(BARE) == expected:
			return
	fail(message)


## Returns the tooltip of the yellow triangle beside the field in the scene tree; "" without one.
func warning() -> String:
	await frames(1)
	for tree: Tree in EditorInterface.get_base_control().find_children("*", "Tree", true, false):
		var item := _item_of(tree.get_root()) if tree.get_parent().is_class("SceneTreeEditor") and tree.is_visible_in_tree() else null
		if item:
			for i in item.get_button_count(0):
				if item.get_button_tooltip_text(0, i).contains("warning"):
					return item.get_button_tooltip_text(0, i).replace("\n", " ")
			return ""
	fail("the field is not in the scene tree's list")
	return ""


func _item_of(item: TreeItem) -> TreeItem:
	if item == null or item.get_text(0) == "Field":
		return item
	for child in item.get_children():
		var found := _item_of(child)
		if found:
			return found
	return null


func _count_update(node: Node) -> void:
	_updates += int(node == field)


func test_a_new_map_that_grows_nothing_is_said() -> void:
	await assert_warned(false, "no map: grass everywhere")
	field.map = GrassMap.new()
	await assert_warned(true, "an empty one")
	await shoot("bare_map")
	field.map.base_density = 1.0
	await assert_warned(false, "full")
	field.map.base_density = 0.0
	await assert_warned(true, "empty again")
	field.fill_rule = GrassFillRule.new()
	await assert_warned(false, "the rule fills it")
	field.fill_rule = null
	field.map = GrassMap.new()
	await assert_warned(true, "empty again")

	get_tree().node_configuration_warning_changed.connect(_count_update)
	await take("Paint")
	await stroke([Vector3(-1, 0, 0), Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(1, 0, -1)])
	await assert_warned(false, "painted")
	assert_greater(plugin.get_statistics().steps, 4)
	assert_eq(_updates, 1, "the editor looks once, however long the stroke")
	await stroke([Vector3(-1, 0, -1), Vector3(0, 0, -1)])
	assert_eq(_updates, 1)
	await undo()
	await undo()
	await assert_warned(true, "undone")
	get_tree().node_configuration_warning_changed.disconnect(_count_update)


func palette() -> ItemList:
	return toolbar.get_node("SpeciesTarget")


## Returns the name in the palette that is chosen.
func chosen() -> String:
	return palette().get_item_text(palette().get_selected_items()[0]) if palette().is_anything_selected() else ""


func names() -> Array:
	return range(palette().item_count).map(palette().get_item_text)


## Clicks on a picture in the palette.
func pick(index: int) -> void:
	var middle := palette().global_position + palette().get_item_rect(index).get_center()
	await move(middle)
	await button(MOUSE_BUTTON_LEFT, true, middle)
	await button(MOUSE_BUTTON_LEFT, false, middle)


## Three to choose from.
func mix_species() -> void:
	var clover := GrassSpecies.new()
	clover.resource_name = "Clover"
	clover.tip_color = Color.DARK_GREEN
	var straw := GrassSpecies.new()
	straw.tip_color = Color.GOLD
	straw.root_color = Color.SADDLE_BROWN
	ResourceSaver.save(straw, "res://tests/editor/dry_straw.tres")
	var of_file: GrassSpecies = load("res://tests/editor/dry_straw.tres")
	var poppy := GrassSpecies.new()
	var image := Image.create_empty(32, 32, false, Image.FORMAT_RGBA8)
	image.fill_rect(Rect2i(6, 6, 20, 20), Color.RED)
	poppy.card = ImageTexture.create_from_image(image)
	poppy.card_share = 0.5
	var species: Array[GrassSpecies] = [clover, of_file, poppy]
	field.species = species
	await frames(3)


func test_species_are_chosen_by_picture_and_name() -> void:
	await take("Erase")
	await mix_species()
	await take("Species")
	await frames(3)
	assert_eq(names(), ["As mixed", "Clover", "Dry Straw", "Species 3"])
	assert_eq(chosen(), "Clover", "the first species, not the mixture")
	await stroke([Vector3(-1, 0, 0), Vector3(0, 0, 0), Vector3(1, 0, 0)])
	assert_eq(channel(GrassMap.CHANNEL_SPECIES), 1.0, "something useful at once")

	await pick(3)
	assert_eq(chosen(), "Species 3")
	await stroke([Vector3(-1, 0, 0), Vector3(0, 0, 0), Vector3(1, 0, 0)])
	assert_eq(channel(GrassMap.CHANNEL_SPECIES), 3.0, "picked by a click")
	await shoot("species_palette")
	await move(at(Vector3.ZERO))
	await key(KEY_BRACKETLEFT, KEY_MASK_CTRL | KEY_MASK_SHIFT)
	assert_eq(chosen(), "Dry Straw", "by key")

	(field.species[1] as GrassSpecies).resource_name = "Hay"
	await frames(2)
	assert_eq(chosen(), "Hay", "a new name shows at once")
	var straw := mean_color(palette().get_item_icon(2).get_image())
	var clover := mean_color(palette().get_item_icon(1).get_image())
	assert_greater(straw.r, straw.b + 0.2, "golden")
	assert_greater(clover.g, clover.r, "green")
	var flower := mean_color(palette().get_item_icon(3).get_image())
	assert_greater(flower.r, mean_color(palette().get_item_icon(1).get_image()).r + 0.1, "a red flower")
	var before := palette().get_item_icon(2).get_image().get_data()
	(field.species[1] as GrassSpecies).tip_color = Color.BLUE
	await frames(2)
	assert_ne(palette().get_item_icon(2).get_image().get_data(), before, "a new colour shows, too")
	field.species = field.species.slice(0, 1)
	await frames(2)
	assert_eq(chosen(), "Clover", "the one that is left")
	field.species = []
	await frames(2)
	assert_eq(names(), ["As mixed", "Default Grass", "Drop one here"])
	assert_eq(chosen(), "Default Grass")
	assert_true(palette().tooltip_text.contains("Drop a GrassSpecies here"), "says what to do")


## Of what is drawn in a picture.
func mean_color(picture: Image) -> Color:
	var sum := Color(0, 0, 0, 0)
	for y in picture.get_height():
		for x in picture.get_width():
			var color := picture.get_pixel(x, y)
			sum += Color(color.r, color.g, color.b, 1.0) * color.a
	return sum / maxf(sum.a, 1e-6)


## Returns what an export to a platform of this class says of the field, by its messages.
func export_errors(platform: EditorExportPlatform, options: Dictionary) -> PackedStringArray:
	var preset := platform.create_preset()
	for option: String in options:
		preset.set(option, options[option])
	platform.clear_messages()
	platform.export_pack(preset, true, ProjectSettings.globalize_path("user://first_minute.pck"))
	var errors := PackedStringArray()
	for i in platform.get_message_count():
		if platform.get_message_category(i) == "GrassField":
			assert_eq(platform.get_message_type(i), EditorExportPlatform.EXPORT_MESSAGE_ERROR)
			errors.append(platform.get_message_text(i))
	return errors


func test_an_export_without_its_library_is_an_error() -> void:
	var lists := FileAccess.get_file_as_string(EXTENSION)
	var linux := EditorExportPlatformLinuxBSD.new()
	assert_eq(export_errors(linux, {"binary_format/architecture": "x86_64"}), PackedStringArray(), "it is there")

	expect_error("GrassField: grass_field.gdextension names no library for linux loongarch64 (debug)")
	var errors := export_errors(linux, {"binary_format/architecture": "loongarch64"})
	if assert_eq(errors.size(), 1):
		assert_true(errors[0].contains("./grass build platform=linux arch=loongarch64 target=debug"), errors[0])

	var file := FileAccess.open(EXTENSION, FileAccess.WRITE)
	file.store_string(lists.replace("libgrass_field.windows.template_debug.x86_64.dll", "nowhere.dll"))
	file.close()
	expect_error("GrassField: res://addons/grass_field/bin/nowhere.dll is missing, the library for windows x86_64 (debug)")
	errors = export_errors(EditorExportPlatformWindows.new(), {"binary_format/architecture": "x86_64"})
	assert_eq(errors.size(), 1)
	file = FileAccess.open(EXTENSION, FileAccess.WRITE)
	file.store_string(lists)
	file.close()


func _picture_came(_path: String, picture: Texture2D, _small: Texture2D, preset: String) -> void:
	_pictures[preset] = picture


func test_presets_have_pictures() -> void:
	var paths := PackedStringArray()
	for file in DirAccess.get_files_at("res://addons/grass_field/presets"):
		if file.ends_with(".tres"):
			paths.append("res://addons/grass_field/presets/" + file)
	for path in paths:
		# Of a resource that is being edited the editor keeps no picture on disk.
		EditorInterface.get_resource_previewer().queue_edited_resource_preview(load(path), self, "_picture_came", path)
	for i in 2000:
		await frames(1)
		if _pictures.size() == paths.size():
			break
	assert_eq(_pictures.size(), paths.size())
	var sheet := Image.create_empty(4 * 128, 4 * 128, false, Image.FORMAT_RGBA8)
	for i in paths.size():
		var picture: Texture2D = _pictures.get(paths[i])
		if not assert_true(picture != null, paths[i]):
			continue
		var image := picture.get_image()
		image.resize(128, 128)
		image.convert(Image.FORMAT_RGBA8)
		var seen := 0
		for y in range(0, 128, 4):
			for x in range(0, 128, 4):
				seen += int(image.get_pixel(x, y).a > 0.5)
		assert_greater(seen, 30, paths[i])  # of 1,024: one thin plant has the fewest
		sheet.blit_rect(image, Rect2i(0, 0, 128, 128), 128 * Vector2i(i % 4, i / 4))
	sheet.save_png(ProjectSettings.globalize_path("res://").path_join("../presets.png"))
