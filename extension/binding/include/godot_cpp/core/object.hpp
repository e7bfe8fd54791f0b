// SPDX-License-Identifier: MIT
// Objects: casts, finding one by its number, and the short words of _bind_methods.
#pragma once

#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_hooks.hpp>
#include <godot_cpp/core/object_id.hpp>
#include <godot_cpp/templates/local_vector.hpp>

#define ADD_SIGNAL(m_signal) ::godot::ClassDB::add_signal(get_class_static(), m_signal)
#define ADD_GROUP(m_name, m_prefix) ::godot::ClassDB::add_property_group(get_class_static(), m_name, m_prefix)
#define ADD_PROPERTY(m_property, m_setter, m_getter) ::godot::ClassDB::add_property(get_class_static(), m_property, m_setter, m_getter)
#define ADD_PROPERTYI(m_property, m_setter, m_getter, m_index)                                                                             \
	::godot::ClassDB::add_property(get_class_static(), m_property, m_setter, m_getter, m_index)

namespace godot {

// What a signal or a script-implemented method looks like.
struct MethodInfo {
	StringName name;
	PropertyInfo return_val;
	uint32_t flags = GDEXTENSION_METHOD_FLAGS_DEFAULT;
	int id = 0;
	LocalVector<PropertyInfo> arguments;
	LocalVector<Variant> default_arguments;

	MethodInfo() = default;
	template <typename... Arguments>
	MethodInfo(const StringName &p_name, const Arguments &...p_arguments) : name(p_name), arguments({ p_arguments... }) {}
	template <typename... Arguments>
	MethodInfo(Variant::Type p_result, const StringName &p_name, const Arguments &...p_arguments) :
			name(p_name), arguments({ p_arguments... }) {
		return_val.type = p_result;
	}
	template <typename... Arguments>
	MethodInfo(const PropertyInfo &p_result, const StringName &p_name, const Arguments &...p_arguments) :
			name(p_name), return_val(p_result), arguments({ p_arguments... }) {}
};

class ObjectDB {
public:
	// Null where no object of that number lives.
	static Object *get_instance(uint64_t p_id) {
		return internal::get_object_instance_binding(gdextension_interface::object_get_instance_from_id(p_id));
	}
};

template <typename T> T *Object::cast_to(Object *p_object) {
	return dynamic_cast<T *>(p_object);
}
template <typename T> const T *Object::cast_to(const Object *p_object) {
	return dynamic_cast<const T *>(p_object);
}

namespace internal {

template <typename T> T *object_as(Object *p_object) {
	return dynamic_cast<T *>(p_object);
}
template <typename T> GodotObject *owner_of(const T *p_object) {
	return p_object ? p_object->_owner : nullptr;
}

} // namespace internal

} // namespace godot
