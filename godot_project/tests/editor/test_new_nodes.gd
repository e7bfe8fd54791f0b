# SPDX-License-Identifier: MIT
## What the editor does for a node that was just added: it has its shape or its curve, and a field on a hill offers to bake.
@tool
extends "res://tests/editor/editor_case.gd"

const FLOOR := Vector2(-5, -1)  # on the tilted floor, 1.3 m high


## As the editor's dialog for a new node does it.
func add_by_dialog(node: Node) -> void:
	var root := EditorInterface.get_edited_scene_root()
	var history := EditorInterface.get_editor_undo_redo()
	history.create_action("Create Node", UndoRedo.MERGE_DISABLE, root)
	history.add_do_method(root, "add_child", node, true)
	history.add_do_method(node, "set_owner", root)
	history.add_do_reference(node)
	history.add_undo_method(root, "remove_child", node)
	history.commit_action()
	await frames(2)


func offer() -> Button:
	return toolbar.get_node("BakeOffer")


func test_new_exclusions_and_paths_can_be_used_at_once() -> void:
	var exclusion := GrassExclusion3D.new()
	await add_by_dialog(exclusion)
	if assert_true(exclusion.shape is BoxShape3D, "born with a shape"):
		assert_eq((exclusion.shape as BoxShape3D).size, Vector3(2, 2, 2))
	var path := GrassPath3D.new()
	await add_by_dialog(path)
	assert_true(path.curve != null and path.curve.point_count == 0, "born with a curve, to which points are added")
	# What somebody took away stays away.
	exclusion.shape = null
	await undo()
	await undo()
	await redo()
	assert_true(exclusion.is_inside_tree() and exclusion.shape == null, "undo brings back what was there")
	var outlined := GrassExclusion3D.new()
	outlined.outline = PackedVector2Array([Vector2(0, 0), Vector2(1, 0), Vector2(0, 1)])
	await add_by_dialog(outlined)
	assert_true(outlined.shape == null, "it has an outline")
	assert_eq(EditorInterface.save_scene(), OK)
	await open(SAVED)
	exclusion = EditorInterface.get_edited_scene_root().find_children("*", "GrassExclusion3D", true, false)[0]
	assert_true(exclusion.shape == null, "nor does a scene that is opened get one")
	var by_script := GrassExclusion3D.new()
	EditorInterface.get_edited_scene_root().add_child(by_script)
	await frames(2)
	assert_true(by_script.shape == null, "nor what a tool keeps for itself")
	by_script.free()


func test_a_field_on_uneven_ground_offers_to_bake() -> void:
	await wait_until(func() -> bool: return offer().is_visible_in_tree(), "it is offered")
	assert_true(offer().text.contains("Bake Ground") and offer().text.contains("m"), offer().text)
	await take("Erase")
	await wait_until(func() -> bool: return not offer().visible, "the brush bakes by itself")
	await click(toolbar.get_node("Erase"))
	await wait_until(func() -> bool: return offer().visible, "it is offered again")
	await click(offer())
	assert_near(field.map.sample(GrassMap.CHANNEL_GROUND, FLOOR), 1.316, 0.1)
	await wait_until(func() -> bool: return not offer().visible, "it is done")
	await undo()
	await wait_until(func() -> bool: return offer().visible, "and undone")
	field.size = Vector2(2, 2)  # between the hills
	await wait_until(func() -> bool: return not offer().visible, "its plane is the ground")


func test_what_is_no_ground_is_passed_by() -> void:
	var crate := StaticBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = BoxShape3D.new()
	(shape.shape as BoxShape3D).size = Vector3(2, 0.5, 2)
	crate.add_child(shape)
	crate.position = Vector3(0, 0.75, 0)
	crate.collision_layer = 1 << 4
	EditorInterface.get_edited_scene_root().add_child(crate)
	await frames(3)
	await take("Erase")
	var eye := camera_transform().origin
	var on_top := Vector3(0, 1, 0)
	var below := eye + (on_top - eye) * eye.y / (eye.y - on_top.y)
	await stroke([on_top])
	var on_crate: float = field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(0, 0)) if field.map else 0.0
	assert_near(on_crate, 1.0, 0.05, "grass is painted on the crate")
	await undo()
	field.ground_mask = 1
	await stroke([on_top])
	if assert_true(field.map != null):
		assert_near(field.map.sample(GrassMap.CHANNEL_GROUND, Vector2(0, 0)), 0.0, 0.01, "no grass on the crate")
		assert_less(density(below.x, below.z), 0.9, "the brush reaches the ground behind it")
	await undo()
	crate.free()
