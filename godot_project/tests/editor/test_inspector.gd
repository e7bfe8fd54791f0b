# SPDX-License-Identifier: MIT
## The inspector at its first width shows whole numbers with their units.
@tool
extends "res://tests/editor/editor_case.gd"

const DRAWN := ["test_numbers_are_not_cut"]  # see runner.gd
const ARROWS := 28.0  # pixels beside a number


## Numbers of the object that are cut, as texts. In an inspector of the test's own, since the editor's keeps resources until its very end.
func cut_of(object: Object) -> PackedStringArray:
	var inspector := EditorInspector.new()
	EditorInterface.get_base_control().add_child(inspector)
	inspector.size = EditorInterface.get_inspector().size
	inspector.edit(object)
	await frames(3)
	for section: Control in inspector.find_children("*", "EditorInspectorSection", true, false):
		section.call("unfold")
	await frames(3)
	var cut := PackedStringArray()
	var seen := 0
	for slider: EditorSpinSlider in inspector.find_children("*", "EditorSpinSlider", true, false):
		var text := "%s%s %s" % [slider.label, slider.value, slider.suffix]
		var size := slider.get_theme_font_size("font_size", "LineEdit")
		var width := slider.get_theme_font("font", "LineEdit").get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, size).x
		if slider.is_visible_in_tree() and width > slider.size.x - ARROWS:
			cut.append("%s of %s: %d of %d pixels" % [text, object.get_class(), slider.size.x - ARROWS, width])
		seen += int(slider.is_visible_in_tree())
	assert_greater(seen, 3, "numbers of %s" % object.get_class())
	inspector.free()
	return cut


func test_numbers_are_not_cut() -> void:
	var size := get_tree().root.size
	get_tree().root.size = Vector2i(1280, 720)  # docks are narrower in a smaller window
	await frames(3)
	field.density = 256.0
	for object: Object in [field, GrassSpecies.new(), GrassPatch.new(), GrassBrush.new(), GrassQuality.new()]:
		assert_eq(await cut_of(object), PackedStringArray())
	await select(field)
	get_tree().root.size = size
	await frames(3)
