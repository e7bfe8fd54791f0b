// SPDX-License-Identifier: MIT
// What the engine and its editor know of a property, an argument or a result.
#pragma once

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace godot {

struct PropertyInfo {
	Variant::Type type = Variant::NIL;
	StringName name;
	StringName class_name; // for objects, enums and bit fields
	uint32_t hint = PROPERTY_HINT_NONE;
	String hint_string;
	uint32_t usage = PROPERTY_USAGE_DEFAULT;

	PropertyInfo() = default;
	PropertyInfo(Variant::Type p_type, const StringName &p_name, PropertyHint p_hint = PROPERTY_HINT_NONE,
			const String &p_hint_string = String(), uint32_t p_usage = PROPERTY_USAGE_DEFAULT,
			const StringName &p_class_name = StringName());
	PropertyInfo(GDExtensionVariantType p_type, const StringName &p_name, PropertyHint p_hint = PROPERTY_HINT_NONE,
			const String &p_hint_string = String(), uint32_t p_usage = PROPERTY_USAGE_DEFAULT,
			const StringName &p_class_name = StringName()) :
			PropertyInfo(static_cast<Variant::Type>(p_type), p_name, p_hint, p_hint_string, p_usage, p_class_name) {}
	PropertyInfo(const GDExtensionPropertyInfo *p_info);

	operator Dictionary() const;
	// Writes into a structure of the engine's.
	void _update(GDExtensionPropertyInfo *r_info) const;
	// A structure for the engine that points into this one.
	GDExtensionPropertyInfo _to_gdextension() const;
};

} // namespace godot
