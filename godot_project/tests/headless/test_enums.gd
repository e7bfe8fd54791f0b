# SPDX-License-Identifier: MIT
## An invalid enum value: every setter refuses it, names the property and its class, and keeps the old value.
extends "res://tests/field_case.gd"

const NUMBERS: Array[int] = [-1, 99, 1 << 40, (1 << 40) + 1, -(1 << 40)]


## Returns the properties of `type` that the inspector shows as an enum, and how its setter's message names them.
func enums_of(type: StringName) -> Array[String]:
	var names: Array[String] = []
	for property in ClassDB.class_get_property_list(type, true):
		if property.hint == PROPERTY_HINT_ENUM:
			names.append(property.name)
	return names


func check_refusals(object: Object, owner_name: String, expected: Array[String]) -> void:
	assert_eq(enums_of(object.get_class()), expected)
	for property in expected:
		expect_error("%s: `%s` must be" % [owner_name, property])
		var before: int = object.get(property)
		for number in NUMBERS:
			object.set(property, number)
			assert_eq(object.get(property), before, "%s = %d" % [property, number])
			object.call("set_" + property, number)
			assert_eq(object.get(property), before, "set_%s(%d)" % [property, number])


func test_field_refuses_what_is_no_constant() -> void:
	var field := add_field()
	field.name = "Lawn"
	field.method = GrassField.METHOD_PBD
	check_refusals(field, "GrassField 'Lawn'", ["method", "simulation_detail", "sleep_mode", "backend", "debug_view"])
	assert_eq(field.method, GrassField.METHOD_PBD)


func test_brush_refuses_what_is_no_constant() -> void:
	var brush := GrassBrush.new()
	brush.tool = GrassBrush.TOOL_COMB
	check_refusals(brush, "GrassBrush", ["tool", "falloff", "channel"])
	assert_eq(brush.tool, GrassBrush.TOOL_COMB)


func test_fill_rule_refuses_what_is_no_constant() -> void:
	var rule := GrassFillRule.new()
	rule.mask_channel = GrassFillRule.MASK_BLUE
	check_refusals(rule, "GrassFillRule", ["mask_channel"])
	assert_eq(rule.mask_channel, GrassFillRule.MASK_BLUE)


func test_path_refuses_what_is_no_constant() -> void:
	var path := GrassPath3D.new()
	path.mode = GrassPath3D.MODE_PLANT
	check_refusals(path, "GrassPath3D", ["mode"])
	assert_eq(path.mode, GrassPath3D.MODE_PLANT)
	path.free()


func test_patch_and_map_refuse_what_is_no_constant() -> void:
	var patch := GrassPatch.new()
	var map := GrassMap.new()
	var lengths := [patch.length_min, patch.length_max]
	expect_error("GrassPatch: no such parameter")
	expect_error("GrassMap: no such channel")
	for number in NUMBERS:
		patch.set_param(number as GrassPatch.Param, 0.25)
		assert_eq(patch.get_param(number as GrassPatch.Param), 0.0, "get_param(%d)" % number)
		assert_eq(map.sample(number as GrassMap.Channel, Vector2.ZERO), 0.0, "sample(%d)" % number)
	assert_eq([patch.length_min, patch.length_max], lengths)


## The numbers that share one setter: the inspector calls it with an index, a script may with any.
func test_numbers_by_index_refuse_what_is_no_index() -> void:
	var objects: Array[Object] = [add_field(), GrassBrush.new(), GrassFillRule.new(), GrassSpecies.new()]
	for object in objects:
		expect_error("p_param = ")
		for number in NUMBERS:
			object.call("_set_param", number, 1.0)
			assert_eq(object.call("_get_param", number), 0.0, "%s %d" % [object.get_class(), number])


## The editor's help and completion name the enum, not an integer.
func test_hints_name_the_enums() -> void:
	for entry: Array in [
		["GrassField", "set_method", &"GrassField.SolverMethod"],
		["GrassField", "set_backend", &"GrassField.BackendMode"],
		["GrassField", "set_sleep_mode", &"GrassField.SleepMode"],
		["GrassField", "set_simulation_detail", &"GrassField.SimulationDetail"],
		["GrassField", "set_debug_view", &"GrassField.DebugView"],
		["GrassPath3D", "set_mode", &"GrassPath3D.Mode"],
		["GrassBrush", "set_tool", &"GrassBrush.Tool"],
		["GrassBrush", "set_falloff", &"GrassBrush.FalloffCurve"],
		["GrassFillRule", "set_mask_channel", &"GrassFillRule.MaskChannel"],
		["GrassPatch", "set_param", &"GrassPatch.Param"],
		["GrassMap", "sample", &"GrassMap.Channel"]
	]:
		var methods := ClassDB.class_get_method_list(entry[0], true).filter(func(found: Dictionary) -> bool: return found.name == entry[1])
		if assert_eq(methods.size(), 1, entry[1]):
			assert_eq(StringName(methods[0].args[0].class_name), entry[2], entry[1])
			assert_true(methods[0].args[0].usage & PROPERTY_USAGE_CLASS_IS_ENUM, entry[1])
		var values := ClassDB.class_get_enum_constants(entry[0], String(entry[2]).get_slice(".", 1), true)
		assert_greater(values.size(), 1, String(entry[2]))
