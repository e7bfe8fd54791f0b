# SPDX-License-Identifier: MIT
## What a newcomer meets first: inherited properties in the inspector, and the state of a field in its parent's _ready().
extends "res://tests/field_case.gd"

const HIDDEN: Array[String] = [
	"material_override",
	"material_overlay",
	"extra_cull_margin",
	"custom_aabb",
	"lod_bias",
	"ignore_occlusion_culling",
	"gi_lightmap_texel_scale",
	"gi_lightmap_scale",
	"visibility_range_begin",
	"visibility_range_begin_margin",
	"visibility_range_end",
	"visibility_range_end_margin",
	"visibility_range_fade_mode",
	"sorting_offset",
	"sorting_use_aabb_center",
]
const WITH_EFFECT: Array[String] = ["transparency", "cast_shadow", "layers", "gi_mode"]


class Meadow:
	extends Node3D
	var blades := -1
	var tiles := Vector2i(-1, -1)

	func _ready() -> void:
		var field: GrassField = get_child(0)
		blades = field.get_blade_count()
		tiles = field.get_grid_size()


## name -> usage, as this field's inspector has it.
func usages_of(field: GrassField) -> Dictionary[String, int]:
	var usages: Dictionary[String, int] = {}
	for property in field.get_property_list():
		usages[property.name] = property.usage
	return usages


func test_inherited_properties_work_or_are_hidden() -> void:
	var usages := usages_of(add_field())
	var inherited: Array[String] = []
	for type: String in ["GeometryInstance3D", "VisualInstance3D"]:
		for property in ClassDB.class_get_property_list(type, true):
			if property.usage & PROPERTY_USAGE_EDITOR:
				inherited.append(property.name)
	assert_greater(inherited.size(), 15)
	for property in inherited:
		assert_true(property in HIDDEN or property in WITH_EFFECT, "%s of this engine: does it do anything on a field?" % property)
		assert_eq(bool(usages[property] & PROPERTY_USAGE_EDITOR), property in WITH_EFFECT, property)
	assert_false(bool(usages.visibility_parent & PROPERTY_USAGE_EDITOR), "goes by visibility ranges")
	for property: String in ["visible", "position", "size", "density", "map"]:
		assert_true(bool(usages[property] & PROPERTY_USAGE_EDITOR), property)


func test_hidden_properties_are_kept() -> void:
	var field := add_field()
	var usages := usages_of(field)
	var values := {
		material_override = StandardMaterial3D.new(),
		material_overlay = StandardMaterial3D.new(),
		extra_cull_margin = 3.0,
		custom_aabb = AABB(Vector3.ONE, Vector3.ONE),
		lod_bias = 2.0,
		ignore_occlusion_culling = true,
		visibility_range_end = 3.0,
		sorting_offset = 1.0,
	}
	for property: String in values:
		assert_true(bool(usages[property] & PROPERTY_USAGE_STORAGE), property + " is saved")
		field.set(property, values[property])
		assert_eq(field.get(property), values[property], property)
	await ticks(3)
	assert_greater(field.get_blade_count(), 0)


func test_the_class_reference_names_what_has_no_effect() -> void:
	var text := FileAccess.get_file_as_string("res://../extension/doc_classes/GrassField.xml")
	for property in HIDDEN:
		assert_true(
			text.contains("[member %s.%s]" % ["VisualInstance3D" if property.begins_with("sorting") else "GeometryInstance3D", property]),
			property
		)


func test_a_parent_knows_its_field_in_ready() -> void:
	var meadow := Meadow.new()
	var field := GrassField.new()
	field.size = Vector2(16, 8)
	field.density = 64.0
	meadow.add_child(field)
	add_child(meadow)
	assert_eq(meadow.tiles, Vector2i(16, 8))
	assert_eq(meadow.blades, 16 * 8 * 64)
	await ticks(3)
	assert_eq(field.get_blade_count(), meadow.blades, "and nothing else later")


func test_limits_the_wrong_way_round_are_said() -> void:
	var patch := GrassPatch.new()
	patch.length_min = 1.0
	patch.length_max = 0.5
	expect_error("The patch of species 0 has `length_min` above `length_max`, so all blades are `length_min` long.")
	add_field({species = kind({patch = patch})})
	await ticks(2)
	var thin := GrassPatch.new()
	thin.width_min = 0.03
	thin.width_max = 0.01
	var reed := GrassSpecies.new()
	reed.patch = thin
	var species: Array[GrassSpecies] = [GrassSpecies.new(), reed]
	expect_error("The patch of species 1 has `width_min` above `width_max`")
	add_field({species = species})
	await ticks(2)
	var rule := GrassFillRule.new()
	rule.slope_min = 40.0
	rule.slope_max = 20.0
	expect_error("`fill_rule` has `slope_min` above `slope_max`")
	add_field({fill_rule = rule})
	await ticks(2)
