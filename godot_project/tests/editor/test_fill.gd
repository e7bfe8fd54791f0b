# SPDX-License-Identifier: MIT
## Filling by rule in the editor: the inspector's button, undo and redo.
@tool
extends "res://tests/editor/editor_case.gd"


func test_the_button_fills_and_the_history_takes_it_back() -> void:
	await give_rule()
	var fill_now := await find_button("Fill Now")
	if not assert_true(fill_now != null, "the inspector has the button"):
		return
	assert_true(field.map == null)
	await click(fill_now)
	if not assert_true(field.map != null, "the field has got a map"):
		return
	assert_near(cover(), 0.5, 0.1, "half of the ground keeps its grass")
	var filled: PackedByteArray = field.map.data
	await undo()
	assert_true(field.map == null, "no map again")
	await redo()
	assert_eq(field.map.data, filled, "as it was filled")


func test_a_fill_goes_over_the_last_one_and_under_what_is_painted() -> void:
	await give_rule()
	await take("Erase")
	set_number("Strength", 1.0)
	await stroke([Vector3(0, 0, 0), Vector3(0, 0, 0)])
	await take("Erase")  # put down: clicks go to the inspector
	var painted: PackedByteArray = field.map.data
	assert_near(density(0, 0), 0.0, 0.02)
	var fill_now := await find_button("Fill Now")
	if not assert_true(fill_now != null):
		return
	await click(fill_now)
	var first: PackedByteArray = field.map.data
	assert_near(density(0, 0), 0.0, 0.02, "what was erased stays bare")
	field.fill_rule.noise_cover = 0.25
	await click(await find_button("Fill Now"))
	assert_near(cover(), 0.25, 0.1)
	await undo()
	assert_eq(field.map.data, first)
	await undo()
	assert_eq(field.map.data, painted)


func test_the_button_is_there_only_for_a_rule_that_is_not_live() -> void:
	assert_true(await find_button("Fill Now") == null, "no rule")
	await give_rule()
	assert_true(await find_button("Fill Now") != null)
	field.fill_live = true
	assert_true(await find_button("Fill Now") == null, "live")
	assert_near(cover(), 0.5, 0.1, "and full by itself")


func test_a_live_rule_keeps_away_from_a_clearing_that_is_moved() -> void:
	await give_rule()
	field.fill_rule.noise_cover = 1.0
	field.fill_live = true
	var clearing := GrassExclusion3D.new()
	clearing.shape = BoxShape3D.new()
	clearing.shape.size = Vector3(4, 2, 4)
	field.get_parent().add_child(clearing)
	clearing.owner = field.get_parent()
	await filled()
	assert_near(density(0, 0), 0.0, 0.02)
	assert_near(density(6, 6), 1.0, 0.02)
	clearing.position = Vector3(6, 0, 6)
	await filled()
	assert_near(density(0, 0), 1.0, 0.02, "grown again")
	assert_near(density(6, 6), 0.0, 0.02)


func test_what_a_live_rule_has_filled_is_saved_once_it_is_no_longer_live() -> void:
	const FILE := "res://tests/editor/filled.grassmap"
	var empty := GrassMap.new()
	empty.base_density = 1.0
	ResourceSaver.save(empty, FILE)
	field.map = load(FILE)
	await give_rule()
	field.fill_live = true
	await filled()
	EditorInterface.save_scene()
	field.fill_live = false
	EditorInterface.save_scene()
	var saved: GrassMap = ResourceLoader.load(FILE, "", ResourceLoader.CACHE_MODE_IGNORE)
	assert_near(cover(), 0.5, 0.1)
	assert_eq(saved.data, field.map.data)


## A rule that leaves half of the ground bare, filled by hand.
func give_rule() -> void:
	var rule := GrassFillRule.new()
	rule.noise_cover = 0.5
	rule.noise_size = 2.0
	field.fill_live = false
	field.fill_rule = rule
	await frames(2)


func filled() -> void:
	await worked()


## Share of the field that is grown.
func cover() -> float:
	var sum := 0.0
	for x in range(-11, 12):
		for z in range(-11, 12):
			sum += density(x, z)
	return sum / (23 * 23)


## Returns the inspector's button of this name, scrolled into view; null if there is none.
func find_button(text: String) -> Button:
	await frames(20)  # the inspector follows a while after a change
	var inspector := EditorInterface.get_inspector()
	for found: Button in inspector.find_children("*", "Button", true, false):
		if found.text == text:
			for parent in _above(found, inspector):
				parent.call("unfold")
			inspector.ensure_control_visible(found)
			await frames(3)
			return found
	return null


## Returns the sections of the inspector that hold a control: folded ones must open.
func _above(control: Control, inspector: Control) -> Array[Node]:
	var sections: Array[Node] = []
	var node := control.get_parent()
	while node != inspector:
		if node.is_class("EditorInspectorSection"):
			sections.append(node)
		node = node.get_parent()
	return sections
