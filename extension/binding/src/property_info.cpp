// SPDX-License-Identifier: MIT
#include <godot_cpp/core/class_hooks.hpp>
#include <godot_cpp/core/object.hpp>

namespace godot {

PropertyInfo::PropertyInfo(Variant::Type p_type, const StringName &p_name, PropertyHint p_hint, const String &p_hint_string,
		uint32_t p_usage, const StringName &p_class_name) :
		type(p_type),
		name(p_name),
		class_name(p_hint == PROPERTY_HINT_RESOURCE_TYPE ? StringName(p_hint_string) : p_class_name),
		hint(p_hint),
		hint_string(p_hint_string),
		usage(p_usage) {}

PropertyInfo::PropertyInfo(const GDExtensionPropertyInfo *p_info) :
		type(static_cast<Variant::Type>(p_info->type)),
		name(*static_cast<const StringName *>(p_info->name)),
		class_name(*static_cast<const StringName *>(p_info->class_name)),
		hint(p_info->hint),
		hint_string(*static_cast<const String *>(p_info->hint_string)),
		usage(p_info->usage) {}

PropertyInfo::operator Dictionary() const {
	Dictionary dictionary;
	dictionary["name"] = name;
	dictionary["class_name"] = class_name;
	dictionary["type"] = type;
	dictionary["hint"] = hint;
	dictionary["hint_string"] = hint_string;
	dictionary["usage"] = usage;
	return dictionary;
}

void PropertyInfo::_update(GDExtensionPropertyInfo *r_info) const {
	r_info->type = static_cast<GDExtensionVariantType>(type);
	r_info->hint = hint;
	r_info->usage = usage;
	*static_cast<StringName *>(r_info->name) = name;
	*static_cast<StringName *>(r_info->class_name) = class_name;
	*static_cast<String *>(r_info->hint_string) = hint_string;
}

GDExtensionPropertyInfo PropertyInfo::_to_gdextension() const {
	return { static_cast<GDExtensionVariantType>(type), name._native_ptr(), class_name._native_ptr(), hint, hint_string._native_ptr(),
		usage };
}

namespace internal {

StringName engine_enum_name(const char *p_qualified) {
	String text = p_qualified;
	const PackedStringArray parts = text.split("::");
	const int64_t count = parts.size();
	return count < 2 ? text : parts[count - 2] + String(".") + parts[count - 1];
}

// The engine gets an array of C structures that point into copies kept behind it.
const GDExtensionPropertyInfo *make_property_list(const List<PropertyInfo> &p_list, uint32_t *r_count) {
	const uint32_t count = static_cast<uint32_t>(p_list.size());
	*r_count = count;
	if (count == 0) {
		return nullptr;
	}
	PropertyInfo *kept = new PropertyInfo[count];
	GDExtensionPropertyInfo *list = new GDExtensionPropertyInfo[count + 1]; // the last one remembers the copies
	uint32_t index = 0;
	for (const PropertyInfo &info : p_list) {
		kept[index] = info;
		list[index] = kept[index]._to_gdextension();
		index++;
	}
	list[count].name = kept;
	return list;
}

void free_property_list(GDExtensionClassInstancePtr, const GDExtensionPropertyInfo *p_list, uint32_t p_count) {
	if (p_list) {
		delete[] static_cast<PropertyInfo *>(p_list[p_count].name);
		delete[] p_list;
	}
}

} // namespace internal

} // namespace godot
