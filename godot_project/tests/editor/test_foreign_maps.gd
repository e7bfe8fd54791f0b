# SPDX-License-Identifier: MIT
## What is painted is saved, or the editor asks first: a field whose map is part of another scene gets a map of its own.
@tool
extends "res://tests/editor/owned_case.gd"

const PICTURE := "res://tests/editor/bare.png"
enum Menu { BARE, FULL, CLEAR, FOLLOW, NEIGHBOURS, EXPORT, IMPORT, UNIQUE }


func menu(item: Menu) -> void:
	(toolbar.get_node("Menu") as MenuButton).get_popup().id_pressed.emit(item)


func open_prefab() -> void:
	write_base(true)
	write_level()
	await open(level)


func test_a_prefab_is_painted_only_on_a_map_of_its_own() -> void:
	await open_prefab()
	var other: GrassField = field.get_node("../Other")
	var shared := field.map
	var before_it := shared.data
	await take("Erase")
	await stroke(ERASED)
	if not assert_true(dialog != null and dialog.visible, "the editor asks"):
		return
	assert_true(dialog.dialog_text.contains("base_%d.tscn" % _count), dialog.dialog_text)
	assert_eq(shared.data, before_it, "nothing is painted")
	await press("Make Unique")
	assert_true(field.map != shared and other.map == shared, "the selected one has its own")
	assert_eq(field.map.data, before_it, "with the same grass")
	await stroke(ERASED)
	assert_false(dialog.visible)
	assert_less(sample(field), 0.3)
	assert_near(sample(other), 1.0, 0.01)
	EditorInterface.save_scene()
	assert_less(saved_density(level, "Field"), 0.3, "saved in the level")
	assert_near(saved_density(level, "Other"), 1.0, 0.01)
	assert_near(saved_density(base, "."), 1.0, 0.01)
	await undo()
	assert_eq(field.map.data, before_it)
	await undo()
	assert_true(field.map == shared, "one step")
	await redo()
	await redo()
	assert_less(sample(field), 0.3)
	assert_eq(shared.data, before_it)


func test_an_inherited_field_likewise_and_one_below_editable_children() -> void:
	write_base(false)
	await open(base)  # stays open, with a history of its own
	await take("Erase")
	await stroke([Vector3(0, 0, 0), Vector3(0.1, 0, 0)])
	EditorInterface.save_scene()
	var head := '[gd_scene format=3]\n[ext_resource type="PackedScene" path="%s" id="1"]\n' % base
	write(level, head + '[node name="Inherited" instance=ExtResource("1")]\n')
	await open(level)
	await paint_own("Field")
	level = level.replace("level", "editable")
	head += '[node name="Level" type="Node3D"]\n[node name="Part" parent="." instance=ExtResource("1")]\n[editable path="Part"]\n'
	write(level, head)
	await open_at("Part/Field")
	await paint_own("Part/Field")


func paint_own(path: String) -> void:
	await take("Erase")
	await stroke(ERASED)
	if not assert_true(dialog != null and dialog.visible, "the editor asks"):
		return
	await press("Make Unique")
	await stroke(ERASED)
	EditorInterface.save_all_scenes()
	await frames(4)
	assert_less(saved_density(level, path), 0.3, level)
	assert_near(saved_density(base, "Field"), 1.0, 0.01, base)


func test_a_map_that_each_instance_has_a_copy_of_is_saved_too() -> void:
	write_base(true)
	var text := FileAccess.get_file_as_string(base)
	write(base, text.replace("data = ", "resource_local_to_scene = true\ndata = "))
	write_level()
	await open(level)
	assert_true(field.map.resource_local_to_scene)
	await take("Erase")
	await stroke(ERASED)
	assert_false(dialog.visible, "it is the level's")
	assert_less(sample(field), 0.3)
	EditorInterface.save_scene()
	assert_less(saved_density(level, "Field"), 0.3)
	assert_near(saved_density(level, "Other"), 1.0, 0.01)


## Opens the level, whose field is not where open() looks for it.
func open_at(path: String) -> void:
	EditorInterface.open_scene_from_path(level)
	await frames(4)
	field = EditorInterface.get_edited_scene_root().get_node(path)
	await select(field)


func test_the_scene_that_has_the_map_is_opened() -> void:
	write_base(false)
	write(
		level, '[gd_scene format=3]\n[ext_resource type="PackedScene" path="%s" id="1"]\n[node name="I" instance=ExtResource("1")]\n' % base
	)
	await open(level)
	await take("Erase")
	await stroke(ERASED)
	await press("Open Scene")
	assert_eq(EditorInterface.get_edited_scene_root().scene_file_path, base)
	await open(base)
	await take("Erase")
	await stroke(ERASED)
	assert_false(dialog.visible, "it is its own here")
	assert_less(sample(field), 0.3)
	EditorInterface.save_all_scenes()
	assert_less(saved_density(base, "Field"), 0.3)
	assert_less(saved_density(level, "Field"), 0.3, "the level shows the same")


func test_a_field_that_the_scene_does_not_save_is_not_painted() -> void:
	write_base(false)
	var head := '[gd_scene format=3]\n[ext_resource type="PackedScene" path="%s" id="1"]\n' % base
	write(level, head + '[node name="Level" type="Node3D"]\n[node name="Part" parent="." instance=ExtResource("1")]\n')
	await open_at("Part/Field")
	await take("Erase")
	await stroke(ERASED)
	if not assert_true(dialog != null and dialog.visible, "the editor asks"):
		return
	assert_true(dialog.dialog_text.contains("Editable Children"), dialog.dialog_text)
	assert_false(dialog.get_ok_button().visible, "a map of its own would not be saved")
	assert_near(sample(field), 1.0, 0.01)
	dialog.hide()
	var species := field.species.duplicate()
	toolbar.emit_signal("species_dropped", [load("res://addons/grass_field/presets/clover.tres")])
	assert_eq(field.species, species, "nor does it take species")
	assert_true(dialog.visible)


func test_whatever_changes_the_map_asks_first() -> void:
	write_base(true)
	var bare := Image.create_empty(10, 10, false, Image.FORMAT_L8)
	bare.save_png(PICTURE)
	for what: Array in [
		["Bare", func() -> void: menu(Menu.BARE), func() -> bool: return sample(field) == 0.0],
		["Full", func() -> void: menu(Menu.FULL), func() -> bool: return true],
		["Clear", func() -> void: menu(Menu.CLEAR), func() -> bool: return field.map.sample(GrassMap.CHANNEL_CUT, Vector2.ZERO) > 1.0],
		["Bake", func() -> void: toolbar.emit_signal("bake_pressed"), func() -> bool: return true],
		["Import", import_picture, func() -> bool: return sample(field) == 0.0],
		["Fill Now", fill_now, func() -> bool: return sample(field) == 0.0],
	]:
		level = "res://tests/editor/level_%d_%s.tscn" % [_count, what[0]]
		write_level()
		await open(level)
		var shared := field.map
		var before_it := shared.data
		await (what[1] as Callable).call()
		await frames(2)
		if not assert_true(dialog != null and dialog.visible, "%s asks" % what[0]):
			continue
		assert_eq(shared.data, before_it, "%s waits" % what[0])
		await press("Make Unique")
		await frames(2)
		assert_eq(shared.data, before_it, "%s leaves the base as it is" % what[0])
		assert_true(field.map != shared, "%s: a map of its own" % what[0])
		assert_true((what[2] as Callable).call(), "%s goes on: %s" % [what[0], sample(field)])
		EditorInterface.save_scene()


func test_what_was_refused_is_not_done_after_another_question() -> void:
	await open_prefab()
	menu(Menu.BARE)
	await frames(2)
	assert_true(dialog.visible)
	dialog.hide()
	await take("Erase")
	await stroke(ERASED)
	await press("Make Unique")
	assert_near(sample(field), 1.0, 0.01)


func fill_now() -> void:
	field.fill_live = false
	field.fill_rule = GrassFillRule.new()
	field.fill_rule.noise_cover = 0.0
	await frames(2)
	field.fill_now.call()


func import_picture() -> void:
	menu(Menu.IMPORT)
	var pictures: FileDialog = get_tree().root.find_child("GrassPictureDialog", true, false)
	pictures.hide()
	pictures.file_selected.emit(PICTURE)


func test_ground_below_an_instance_does_not_go_into_the_base() -> void:
	var solid := '[sub_resource type="BoxShape3D" id="box"]\nsize = Vector3(40, 1, 40)\n'
	write_base(true)
	write_level()
	var text := FileAccess.get_file_as_string(level).replace('[node name="Level"', solid + '[node name="Level"')
	text += '[node name="Floor" type="StaticBody3D" parent="."]\n[node name="Shape" type="CollisionShape3D" parent="Floor"]\n'
	write(level, text + 'transform = Transform3D(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, -0.5, 0)\nshape = SubResource("box")\n')
	await open(level)
	await settled()
	var before_it := field.map.data
	field.position.y = 1.0
	await settled()
	assert_eq(field.map.data, before_it, "the base's map keeps its ground")
	assert_true(is_told("base_%d.tscn" % _count), "and the editor says why")
	field.position.y = 0.0
