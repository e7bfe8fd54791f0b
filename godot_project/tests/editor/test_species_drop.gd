# SPDX-License-Identifier: MIT
## Presets dropped on the toolbar's Species tool, on its palette, or on a field in the 3D view.
@tool
extends "res://tests/editor/editor_case.gd"

const DRAWN := ["test_a_preset_that_is_dropped_on_a_field_grows_there", "test_a_picture_that_is_dropped_on_a_tool_is_the_stamp"]  # see runner.gd
const PRESETS := "res://addons/grass_field/presets/"


## Returns what the file dock would have been dragging.
func files(paths: PackedStringArray) -> Dictionary:
	return {type = "files", files = paths}


func over_views() -> int:
	return get_tree().root.find_children("*", "ViewDrop", true, false).size()


## Returns whether a species is what a field grows that names none.
func is_default(species: GrassSpecies) -> bool:
	var fresh := GrassSpecies.new()
	for property in fresh.get_property_list():
		var is_own: bool = property.usage & PROPERTY_USAGE_STORAGE and not property.name.begins_with("resource_")
		if is_own and fresh.get(property.name) != species.get(property.name):
			return false
	return species.resource_path.is_empty() or species.resource_path.contains("::")


func test_a_preset_grows_beside_what_grew_there_and_is_in_the_hand() -> void:
	var palette: ItemList = toolbar.get_node("SpeciesTarget")
	await take("Species")
	assert_eq(range(palette.item_count).map(palette.get_item_text), ["As mixed", "Default Grass", "Drop one here"])
	assert_eq(palette.get_selected_items(), PackedInt32Array([1]))
	assert_false(palette.is_item_selectable(2))
	await drop(files([PRESETS + "wheat.tres"]), "Species")
	if not assert_eq(field.species.size(), 2):
		return
	assert_true(is_default(field.species[0]), "what grew there")
	assert_eq(field.species[1].resource_path, PRESETS + "wheat.tres")
	await frames(2)
	assert_eq(range(palette.item_count).map(palette.get_item_text), ["As mixed", "Default Grass", "Wheat"])
	assert_true((toolbar.get_node("Species") as Button).button_pressed)
	await drop(files([PRESETS + "clover.tres", PRESETS + "wheat.tres", PRESETS + "daisy.tres"]), "SpeciesTarget")
	assert_eq(field.species.size(), 4, "none twice")
	assert_true(palette.is_selected(4) and palette.get_item_text(4) == "Daisy", "the last one is chosen")
	await stroke([Vector3(-1, 0, 0), Vector3(1, 0, 0)])
	assert_eq(field.map.sample(GrassMap.CHANNEL_SPECIES, Vector2(0.25, 0.25)), 4.0, "and planted")
	await undo()
	await undo()
	assert_eq(field.species.size(), 2)
	await undo()
	assert_eq(field.species.size(), 0)
	await redo()
	await redo()
	assert_eq(field.species.size(), 4)


func test_a_field_with_all_species_it_can_have_takes_no_more() -> void:
	var many: Array[GrassSpecies] = []
	for i in 8:
		many.append(GrassSpecies.new())
	field.species = many
	await frames(2)
	await drop(files([PRESETS + "wheat.tres"]), "Species")
	assert_eq(field.species, many)
	assert_true(is_told("at most"), "and says so")


func test_a_species_of_another_scene_is_copied() -> void:
	var foreign := GrassSpecies.new()
	foreign.resource_path = "res://tests/editor/elsewhere.tscn::1"
	await drop({type = "resource", resource = foreign}, "Species")
	if assert_eq(field.species.size(), 2):
		assert_true(field.species[1] != foreign, "it would change with that scene")


func test_what_is_no_species_is_not_taken() -> void:
	await drop(files(["res://tests/editor/hills.tscn"]), "Species")
	assert_eq(field.species.size(), 0)


func test_a_preset_that_is_dropped_on_a_field_grows_there() -> void:
	var right := GrassField.new()
	right.name = "Right"
	right.size = Vector2(4, 4)
	right.position = Vector3(2.5, 0, 0)
	field.size = Vector2(1, 1)
	EditorInterface.get_edited_scene_root().add_child(right)
	right.owner = field.owner
	await select(null)
	assert_false(toolbar.is_visible_in_tree())
	await drop_at(files([PRESETS + "clover.tres"]), at(Vector3(2, 0, 0)))
	if not assert_eq(right.species.size(), 2, "the field under the cursor grows it beside its own"):
		return
	assert_eq(field.species.size(), 0, "no other one")
	assert_eq(over_views(), 0, "nothing is left over the view")
	assert_eq(EditorInterface.get_selection().get_selected_nodes(), [right] as Array[Node])
	assert_true(toolbar.is_visible_in_tree() and (toolbar.get_node("Species") as Button).button_pressed, "in the hand")
	set_number("Strength", 1.0)  # with less, single touches may leave none
	await stroke([Vector3(2, 0, 0), Vector3(2.5, 0, 0)])
	assert_true(right.map != null, "and planted by the next stroke")
	await undo()
	await undo()
	assert_eq(right.species.size(), 0, "one step")
	await drop_at(files([PRESETS + "clover.tres"]), at(Vector3(-3, 0, 0)))
	assert_eq(right.species.size() + field.species.size(), 0, "no field there")
	await select(field)


func test_a_picture_that_is_dropped_on_a_tool_is_the_stamp() -> void:
	var stamp: Button = toolbar.get_node("Shape/Stamp")
	assert_false(stamp.visible)
	await drop(files(["res://tests/editor/right_half.tres"]), "Erase")
	if not assert_true(stamp.visible, "the toolbar shows it"):
		return
	(toolbar.get_node("Erase") as Button).button_pressed = true
	set_number("Strength", 1.0)
	set_number("Radius", 2.0)
	assert_eq((toolbar.get_node("Shape/StampRotation") as EditorSpinSlider).suffix, "°")
	await move(at(Vector3.ZERO))
	field.density = 144.0
	await wait_until(func() -> bool: return not field.get_statistics().waiting, "the field is made")
	add_landscape()
	await shoot("stamp")
	await stroke([Vector3.ZERO])
	assert_near(field.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(1.0, 1.0)), 0.0, 0.01, "white erases")
	assert_near(field.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(-1.0, 1.0)), 1.0, 0.01, "black leaves")
	assert_near(field.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(1.5, 1.5)), 0.0, 0.01, "the corner, too")
	await undo()
	await click(stamp)
	assert_false(stamp.visible, "pressed, it goes")


## The stamp lies the same way on both, though one field is turned.
func test_a_stamp_over_the_border_of_two_fields_is_whole() -> void:
	var right := GrassField.new()
	right.size = Vector2(4, 4)
	right.position = Vector3(4, 0, 0)
	right.rotation_degrees.y = 90.0
	field.size = Vector2(4, 4)
	EditorInterface.get_edited_scene_root().add_child(right)
	right.owner = field.owner
	await frames(2)
	await drop(files(["res://tests/editor/right_half.tres"]), "Erase")
	(toolbar.get_node("Erase") as Button).button_pressed = true
	set_number("Strength", 1.0)
	set_number("Radius", 1.5)
	await stroke([Vector3(2, 0, 0)])
	await click(toolbar.get_node("Shape/Stamp"))
	if not assert_true(right.map != null, "both are painted"):
		return
	for place: Vector3 in [Vector3(2.75, 0, 0.75), Vector3(2.75, 0, -0.75)]:
		var there := right.to_local(place)
		assert_near(right.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(there.x, there.z)), 0.0, 0.01, "white erases")
	assert_near(field.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(1.0, 0.75)), 1.0, 0.01, "black leaves")
	assert_near(field.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(1.0, -0.75)), 1.0, 0.01, "black leaves")
