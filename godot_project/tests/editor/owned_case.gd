# SPDX-License-Identifier: MIT
## A test of fields whose map belongs to another scene.
@tool
extends "res://tests/editor/editor_case.gd"

const ERASED: Array = [Vector3(-1, 0, 1.5), Vector3(1, 0, 1.5)]

static var _count := 0

var dialog: ConfirmationDialog
var base: String  # the scene that holds the map
var level: String  # the scene in which it is painted


func before() -> void:
	await super()
	dialog = get_tree().root.find_child("GrassOwnMap", true, false)
	_count += 1
	base = "res://tests/editor/base_%d.tscn" % _count
	level = "res://tests/editor/level_%d.tscn" % _count


func after() -> void:
	if dialog:
		dialog.hide()
	await super()


func write(path: String, text: String) -> void:
	FileAccess.open(path, FileAccess.WRITE).store_string(text)


## Writes a scene whose root, or a child of it named Field, is a field with grass everywhere, in a map of the scene.
func write_base(is_root: bool, more := "") -> void:
	var map := GrassMap.new()
	map.base_density = 1.0
	var brush := GrassBrush.new()
	brush.tool = GrassBrush.TOOL_CUT
	map.stroke(brush, Vector2.ZERO, Vector2.ZERO)
	var field_of_base := GrassField.new()
	field_of_base.name = "Field"
	field_of_base.size = Vector2(5, 5)
	field_of_base.density = 4.0
	field_of_base.map = map
	var root: Node3D = field_of_base if is_root else Node3D.new()
	if not is_root:
		root.name = "Base"
		root.add_child(field_of_base)
		field_of_base.owner = root
	var packed := PackedScene.new()
	packed.pack(root)
	assert_eq(ResourceSaver.save(packed, base, ResourceSaver.FLAG_REPLACE_SUBRESOURCE_PATHS), OK)
	root.free()
	if more:
		write(base, FileAccess.get_file_as_string(base) + more)


## Writes a scene with two instances of the base, the second one 6 m behind the first.
func write_level() -> void:
	var text := '[gd_scene format=3]\n[ext_resource type="PackedScene" path="%s" id="1"]\n[node name="Level" type="Node3D"]\n' % base
	text += '[node name="Field" parent="." instance=ExtResource("1")]\n'
	text += '[node name="Other" parent="." instance=ExtResource("1")]\n'
	text += "transform = Transform3D(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -6)\n"
	write(level, text)


func press(text: String) -> void:
	for pressed: Button in dialog.find_children("*", "Button", true, false):
		if pressed.text == text and pressed.visible:
			pressed.pressed.emit()
			await frames(4)
			return
	assert_true(false, "the dialog has a button '%s'" % text)


## Returns the field's density at a place of its own, as the file on disk says; -1: it has no map.
func saved_density(path: String, node: String, place := Vector2(0, 1.5)) -> float:
	var packed: PackedScene = ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE_DEEP)
	var root := packed.instantiate()
	var of: GrassField = root.get_node(node)
	var found := of.map.sample(GrassMap.CHANNEL_DENSITY, place) if of.map else -1.0
	root.free()
	return found


func sample(of: GrassField, place := Vector2(0, 1.5)) -> float:
	return of.map.sample(GrassMap.CHANNEL_DENSITY, place) if of.map else -1.0
