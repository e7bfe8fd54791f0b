# SPDX-License-Identifier: MIT
## A duplicated field is painted apart from the one that it was made of; fields that share a map on purpose go on sharing it.
@tool
extends "res://tests/editor/owned_case.gd"

const MAP_FILE := "res://tests/editor/shared_%d.grassmap"
const AT_COPY: Array = [Vector3(3.2, 0, 0), Vector3(4, 0, 0)]


func before() -> void:
	await super()
	field.size = Vector2(5, 5)
	set_number("Radius", 0.5)
	await take("Erase")
	await stroke([Vector3(-1, 0, -1), Vector3(1, 0, -1)])
	await take("Erase")


## Duplicates the field as a person does, and moves the copy 5 m to the right.
func duplicate_field() -> GrassField:
	var dock: Node = get_tree().root.find_children("*", "SceneTreeDock", true, false)[0]
	(dock.find_children("*", "Tree", true, false)[0] as Control).grab_focus()
	await frames(2)
	await key(KEY_D, KEY_MASK_CTRL)
	await frames(4)
	var fields := EditorInterface.get_edited_scene_root().find_children("*", "GrassField")
	if not assert_eq(fields.size(), 2, "Ctrl+D makes another"):
		return null
	var copy: GrassField = fields[1] if fields[0] == field else fields[0]
	copy.position = Vector3(5, 0, 0)
	await frames(2)
	return copy


func test_a_duplicate_has_a_map_of_its_own() -> void:
	var copy := await duplicate_field()
	if not copy or not assert_true(copy.map != field.map and copy.map != null, "another map"):
		return
	assert_eq(copy.map.data, field.map.data, "with the same paint")
	assert_true(is_told(copy.name), "the editor says so")
	var painted := field.map.data
	await select(copy)
	await take("Erase")
	await stroke(AT_COPY)
	assert_less(sample(copy, Vector2(-1.5, 0)), 0.3)
	assert_eq(field.map.data, painted, "nothing happens 5 m away")
	var stroked := copy.map.data
	await undo()
	await undo()
	assert_false(copy.is_inside_tree(), "the duplicate is one step")
	await redo()
	await redo()
	assert_true(copy.is_inside_tree())
	assert_eq(copy.map.data, stroked)
	assert_true(copy.map != field.map)
	EditorInterface.save_scene()
	assert_near(saved_density(SAVED, "Field", Vector2(-1.5, 0)), 1.0, 0.01)
	assert_less(saved_density(SAVED, copy.name, Vector2(-1.5, 0)), 0.3)


func test_a_field_that_was_deleted_and_comes_back_keeps_its_map() -> void:
	var right := add_sharing()
	await frames(4)
	right.map = field.map
	var root := EditorInterface.get_edited_scene_root()
	root.remove_child(field)
	await frames(3)
	root.add_child(field)
	field.owner = root
	await frames(3)
	assert_true(field.map == right.map)


## Adds a field at the duplicate's place.
func add_sharing() -> GrassField:
	var right := GrassField.new()
	right.name = "Right"
	right.size = Vector2(5, 5)
	right.density = 4.0
	right.position = Vector3(5, 0, 0)
	EditorInterface.get_edited_scene_root().add_child(right)
	right.owner = EditorInterface.get_edited_scene_root()
	return right


func test_fields_that_share_a_map_are_told_of_and_can_be_parted() -> void:
	var right := add_sharing()
	await frames(4)
	right.map = field.map
	field.fill_live = false
	right.fill_live = false
	field.fill_rule = GrassFillRule.new()
	right.fill_rule = field.fill_rule
	EditorInterface.save_scene()
	await open(SAVED)
	right = field.get_node("../Right")
	assert_true(right.map == field.map, "as it was saved")
	await select(right)
	await take("Erase")
	await stroke(AT_COPY)
	assert_less(sample(field, Vector2(-1.5, 0)), 0.3, "both show it")
	assert_true(is_told("Make Unique"), "and the editor says how to part them")
	var shared := field.map
	(toolbar.get_node("Menu") as MenuButton).get_popup().id_pressed.emit(7)
	await frames(2)
	assert_true(right.map != shared and field.map == shared)
	assert_eq(right.map.data, shared.data)
	assert_true(right.fill_rule != field.fill_rule, "and a rule of its own")
	await undo()
	assert_true(right.map == shared, "one step")


func test_a_duplicate_of_a_field_with_a_map_file_shares_it_and_says_so() -> void:
	var path := MAP_FILE % _count
	ResourceSaver.save(field.map, path)
	field.map = load(path)
	var copy := await duplicate_field()
	if not copy:
		return
	assert_true(copy.map == field.map, "a file is shared on purpose")
	assert_true(is_told(path.get_file()), "the editor says so")
