# SPDX-License-Identifier: MIT
## The toolbar: everything stays in its place, keys take the tools, texts read as they should.
@tool
extends "res://tests/editor/editor_case.gd"

const DRAWN := ["test_nothing_moves_whichever_tool_is_taken"]  # see runner.gd
const TOOLS := ["Paint", "Erase", "Smooth", "Density", "Height", "Species", "Tint", "Comb", "Cut", "Flatten"]
const KEYS := [KEY_P, KEY_B, KEY_U, KEY_N, KEY_H, KEY_I, KEY_C, KEY_L, KEY_G, KEY_J]
const DIGITS := [KEY_0, KEY_1, KEY_2, KEY_3, KEY_4, KEY_5, KEY_6, KEY_7, KEY_8, KEY_9]
const PRESETS := "res://addons/grass_field/presets/"
const STAY := ["Radius", "Strength", "Limits", "Why", "Bake", "Menu"]
const WIDEST := 700.0  # pixels: at 1,280 the docks leave 706


func places() -> Dictionary:
	var found := {view = view().get_global_rect(), toolbar = toolbar.get_global_rect()}
	for name: String in STAY + TOOLS:
		found[name] = (toolbar.get_node(name) as Control).get_global_rect()
	return found


func chosen() -> String:
	var pressed: BaseButton = toolbar.get_node("Paint").button_group.get_pressed_button()
	return pressed.name if pressed else &""


func test_nothing_moves_whichever_tool_is_taken() -> void:
	var scale := EditorInterface.get_editor_scale()
	await frames(3)
	var before := places()
	assert_less((before.toolbar as Rect2).size.x, WIDEST * scale)
	for tool_name: String in TOOLS:
		await take(tool_name)
		await frames(3)
		assert_eq(places(), before, tool_name)
		for control: Control in toolbar.get_children():
			var is_within: bool = control.top_level or toolbar.get_global_rect().encloses(control.get_global_rect())
			assert_true(not control.visible or is_within, "%s with %s" % [control.name, tool_name])
		if tool_name in ["Species", "Tint"]:
			await shoot("toolbar_%s" % tool_name.to_lower())
	field.species = [
		load(PRESETS + "ox_eye_daisy.tres"), load(PRESETS + "fern.tres"), load(PRESETS + "small_shrub.tres"), load(PRESETS + "clover.tres")
	]
	await take("Species")
	await frames(5)
	assert_eq(places(), before, "with a palette")
	await shoot("toolbar_plants")
	field.species = []


func test_a_stamp_takes_the_place_of_the_hardness() -> void:
	await take("Erase")
	await frames(3)
	var before := places()
	var hardness := (toolbar.get_node("Shape/Hardness") as Control).get_global_rect()
	var stamp: Resource = load("res://tests/editor/right_half.tres")
	await drop({type = "resource", resource = stamp}, "Erase")
	await frames(3)
	assert_true((toolbar.get_node("Shape/Stamp") as Control).visible)
	assert_eq(places(), before)
	assert_near((toolbar.get_node("Shape/StampRandom") as Control).get_global_rect().end.x, hardness.end.x, 0.5)
	await click(toolbar.get_node("Shape/Stamp"))
	await frames(2)
	assert_eq(places(), before)


func test_keys_take_tools() -> void:
	await move(at(Vector3.ZERO))
	for i in TOOLS.size():
		await key(KEYS[i])
		assert_eq(chosen(), TOOLS[i])
	await key(KEYS[9])
	assert_eq(chosen(), "", "the same key again puts it down")
	await key(KEY_SLASH)
	assert_eq(chosen(), "Why")
	await key(KEY_ESCAPE)
	assert_eq(chosen(), "")
	var radius: LineEdit = LineEdit.new()
	EditorInterface.get_base_control().add_child(radius)
	radius.grab_focus()
	await key(KEYS[0])
	assert_eq(chosen(), "", "what is typed elsewhere is text")
	radius.free()
	await select(null)
	await key(KEYS[0])
	assert_eq(chosen(), "", "nor without a field")


func test_a_key_during_a_stroke_ends_it() -> void:
	await take("Erase")
	await press_and_move()
	await key(KEYS[0])
	assert_false(plugin.get_statistics().active)
	assert_eq(chosen(), "Paint")
	await button(MOUSE_BUTTON_LEFT, false, at(Vector3.ZERO))
	await undo()
	assert_true(field.map == null, "one step")


func test_no_key_of_a_tool_has_another_use_in_the_3d_view() -> void:
	var settings := EditorInterface.get_editor_settings()
	var ours := 0
	for name: String in TOOLS + ["Why"]:
		var path := "grass_field/%s" % name.to_snake_case()
		if not assert_true(settings.has_shortcut(path), "%s is in the editor's settings" % path):
			continue
		ours += 1
		assert_false((settings.get_shortcut(path).events[0] as InputEventKey).keycode in DIGITS, "digits turn the view's camera")
		for other in settings.get_shortcut_list():
			var is_near := other.begins_with("spatial_editor/") or other.begins_with("editor/") or other.begins_with("grass_field/")
			if other == path or not is_near:
				continue
			for event: InputEvent in settings.get_shortcut(other).events:
				assert_false(settings.get_shortcut(path).matches_event(event), "%s and %s" % [path, other])
	assert_eq(ours, TOOLS.size() + 1)
	for name: String in TOOLS:
		var shown: String = (toolbar.get_node(name) as Button).shortcut.get_as_text()
		assert_eq(shown, OS.get_keycode_string(KEYS[TOOLS.find(name)]), "the tooltip names it")
		assert_true((toolbar.get_node(name) as Button).shortcut_in_tooltip)


func test_texts_are_utf8() -> void:
	var menu := (toolbar.get_node("Menu") as MenuButton).get_popup()
	var texts := PackedStringArray()
	for i in menu.item_count:
		texts.append(menu.get_item_text(i))
	assert_true("Export Picture…" in texts and "Import Picture…" in texts, str(texts))


func test_limits_that_limit_nothing_read_any() -> void:
	var limits: Button = toolbar.get_node("Limits")
	for slider: String in ["SlopeMin", "SlopeMax", "HeightMin", "HeightMax"]:
		assert_true(limits.find_child(slider, true, false).is_any(), slider)
	set_limit("HeightMin", -2.0)
	set_limit("SlopeMax", 45.0)
	assert_false(limits.find_child("HeightMin", true, false).is_any())
	assert_false(limits.find_child("SlopeMax", true, false).is_any())
