# SPDX-License-Identifier: MIT
## Presets that are dropped on the toolbar's Species tool.
@tool
extends "res://tests/editor/editor_case.gd"

const PRESETS := "res://addons/grass_field/presets/"


## Lets go over a part of the toolbar of what the file dock would have been dragging.
func drop(files: PackedStringArray, on: String) -> void:
	var from: Control = toolbar.get_node("Bake")
	var to: Control = toolbar.get_node(on)
	var middle := from.get_global_rect().get_center()
	await move(middle)
	await button(MOUSE_BUTTON_LEFT, true, middle)
	from.force_drag({type = "files", files = files}, Control.new())
	var target := to.get_global_rect().get_center()
	for step in 4:
		await move(middle.lerp(target, 0.25 * (step + 1)), MOUSE_BUTTON_MASK_LEFT)
	await button(MOUSE_BUTTON_LEFT, false, target)
	await frames(2)


func test_a_preset_grows_and_is_in_the_hand() -> void:
	await drop([PRESETS + "wheat.tres"], "Species")
	if not assert_eq(field.species.size(), 1):
		return
	assert_eq(field.species[0].resource_path, PRESETS + "wheat.tres")
	assert_true((toolbar.get_node("Species") as Button).button_pressed)
	await drop([PRESETS + "clover.tres", PRESETS + "wheat.tres", PRESETS + "daisy.tres"], "SpeciesTarget")
	assert_eq(field.species.size(), 3, "none twice")
	var choice: OptionButton = toolbar.get_node("SpeciesTarget")
	assert_eq(choice.get_item_text(choice.selected), "Daisy", "the last one is chosen")
	await stroke([Vector3(-1, 0, 0), Vector3(1, 0, 0)])
	assert_eq(field.map.sample(GrassMap.CHANNEL_SPECIES, Vector2(0.25, 0.25)), 3.0, "and planted")
	await undo()
	await undo()
	assert_eq(field.species.size(), 1)
	await redo()
	assert_eq(field.species.size(), 3)


func test_what_is_no_species_is_not_taken() -> void:
	await drop(["res://tests/editor/hills.tscn"], "Species")
	assert_eq(field.species.size(), 0)
