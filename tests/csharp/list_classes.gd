# SPDX-License-Identifier: MIT
## Prints what the library registers with the engine, as JSON, for tools/test/csharp_tests.py.
extends SceneTree


func type_of(info: Dictionary) -> String:
	if info.type == TYPE_NIL:
		return "Variant" if info.usage & PROPERTY_USAGE_NIL_IS_VARIANT else "void"
	if info.type == TYPE_ARRAY:
		return "%s[]" % info.hint_string.get_slice(":", 1 if ":" in info.hint_string else 0) if info.hint_string else "Array"
	if info.type == TYPE_OBJECT:
		return info.class_name if info.class_name else info.hint_string
	return type_string(info.type)


func values(infos: Array) -> Array:
	return infos.map(func(info: Dictionary) -> Array: return [info.name, type_of(info)])


func list(named: String) -> Dictionary:
	var methods := {}
	for method in ClassDB.class_get_method_list(named, true):
		var is_static: bool = method.flags & METHOD_FLAG_STATIC
		methods[method.name] = [is_static, type_of(method.return), values(method.args), method.default_args.size()]
	var properties := {}
	for property in ClassDB.class_get_property_list(named, true):
		if not property.usage & (PROPERTY_USAGE_GROUP | PROPERTY_USAGE_SUBGROUP | PROPERTY_USAGE_CATEGORY):
			var setter := ClassDB.class_get_property_setter(named, property.name)
			properties[property.name] = [type_of(property), ClassDB.class_get_property_getter(named, property.name), setter]
	var signals := {}
	for event in ClassDB.class_get_signal_list(named, true):
		signals[event.name] = values(event.args)
	var constants := {}
	for constant in ClassDB.class_get_integer_constant_list(named, true):
		constants[constant] = ClassDB.class_get_integer_constant(named, constant)
	var base := ClassDB.get_parent_class(named)
	return {"inherits": base, "methods": methods, "properties": properties, "signals": signals, "constants": constants}


func _init() -> void:
	var all := {}
	for named in ClassDB.get_class_list():
		var is_exposed := ClassDB.can_instantiate(named)
		if named.begins_with("Grass") and is_exposed and ClassDB.class_get_api_type(named) == ClassDB.API_EXTENSION:
			all[named] = list(named)
	print("classes: ", JSON.stringify(all))
	quit()
