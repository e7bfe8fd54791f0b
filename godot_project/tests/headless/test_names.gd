# SPDX-License-Identifier: MIT
## Messages name their subject: a node by its path, a resource by its file or its name.
extends "res://tests/field_case.gd"

const PATH := "user://test_names.tres"


class ShortTerrain:
	extends Node3D

	func get_heights(_at: PackedVector3Array) -> PackedFloat32Array:
		return [1.0, 2.0, 3.0]


func after() -> void:
	if FileAccess.file_exists(PATH):
		DirAccess.remove_absolute(PATH)


func test_every_number_that_cannot_be_is_named() -> void:
	var count := 0
	for type: StringName in ClassDB.get_class_list():
		var is_node := ClassDB.is_parent_class(type, &"Node3D")
		if not String(type).begins_with("Grass") or not is_node and not ClassDB.is_parent_class(type, &"Resource"):
			continue
		var object: Object = ClassDB.instantiate(type)
		var named := "Named%s" % type
		if is_node:
			object.name = named
			add_child(object)
		else:
			object.resource_name = named
		for property in ClassDB.class_get_property_list(type, true):
			if property.hint == PROPERTY_HINT_RANGE and property.type == TYPE_FLOAT:
				var where := "%s '%s" % [type, "" if type == &"GrassField" or not is_node else "%s/" % get_path()]
				expect_error("%s%s': `%s` cannot be" % [where, named, property.name])
				object.set(property.name, NAN)
				count += 1
		if is_node:
			object.free()
	assert_greater(count, 90)


func test_a_resource_of_a_file_has_its_path() -> void:
	expect_error("GrassPatch '%s': `length_max` cannot be 1000.0" % PATH)
	assert_eq(ResourceSaver.save(GrassPatch.new(), PATH), OK)
	var patch: GrassPatch = load(PATH)
	patch.length_max = 1000.0


func test_a_damaged_map_in_a_scene_names_the_file() -> void:
	expect_error("GrassMap: `data`")
	expect_error("GrassMap '%s': `data` " % PATH)
	var file := FileAccess.open(PATH, FileAccess.WRITE)
	file.store_string('[gd_resource type="GrassMap" format=3]\n\n[resource]\ndata = PackedByteArray(1, 2, 3)\n')
	file.close()
	var map: GrassMap = load(PATH)
	await frames(1)
	assert_eq(map.data, PackedByteArray([1, 2, 3]), "and is kept as it was")


func test_too_few_heights_are_counted() -> void:
	expect_error("get_heights() of 'Short' returned PackedFloat32Array of 3, not a PackedFloat32Array of ")
	var terrain := ShortTerrain.new()
	terrain.name = "Short"
	add_child(terrain)
	var field := add_field({terrain = NodePath("../Short")})
	await ticks(3)
	await frames(3)
	assert_true(field.is_inside_tree())


## A class without one has its base's in the editor's lists, which says nothing.
func test_nodes_and_resources_have_icons() -> void:
	var extension := ConfigFile.new()
	assert_eq(extension.load("res://addons/grass_field/grass_field.gdextension"), OK)
	var count := 0
	for type: StringName in ClassDB.get_class_list():
		var is_public := String(type).begins_with("Grass") and ClassDB.can_instantiate(type)
		if is_public and (ClassDB.is_parent_class(type, &"Node") or ClassDB.is_parent_class(type, &"Resource")):
			var icon: String = extension.get_value("icons", type, "")
			assert_true(FileAccess.file_exists("res://addons/grass_field/" + icon) and icon.ends_with(".svg"), "%s: '%s'" % [type, icon])
			count += 1
	assert_greater(count, 10)
