// SPDX-License-Identifier: MIT
// The root of all classes: one C++ object beside each engine object. GDCLASS stands in every class of the extension.
#pragma once

#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/engine_call.hpp>
#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/core/property_info.hpp>
#include <godot_cpp/core/virtual_bind.hpp>
#include <godot_cpp/templates/list.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace godot {

class ClassDB;

namespace internal {

template <typename T> struct ClassHooks;

// What Wrapped must know of the class that memnew makes.
struct ClassIdentity {
	const StringName &(*engine_class)(); // the nearest ancestor that is the engine's own
	const StringName &(*extension_class)(); // null for classes of the engine
	const GDExtensionInstanceBindingCallbacks *callbacks;
};

// Handed to the constructor of Wrapped, which cannot have parameters.
struct Construction {
	const ClassIdentity *identity = nullptr;
	GodotObject *recreated = nullptr; // an object that gets a new C++ half (the library was reloaded)
	GodotObject *wrapped = nullptr; // an object of the engine's that gets a wrapper
};
Construction &next_construction();

} // namespace internal

class Wrapped {
public:
	virtual ~Wrapped() = default;
	Wrapped(const Wrapped &) = delete;
	Wrapped &operator=(const Wrapped &) = delete;

	GodotObject *_owner = nullptr; // the engine's half

protected:
	template <typename> friend struct internal::ClassHooks;

	Wrapped();

	static void _bind_methods() {}
	void _notification(int) {}
	bool _set(const StringName &, const Variant &) { return false; }
	bool _get(const StringName &, Variant &) const { return false; }
	void _get_property_list(List<PropertyInfo> *) const {}
	void _validate_property(PropertyInfo &) const {}
	template <typename T, typename Base> static void register_virtuals() {}

public:
	static constexpr bool _is_singleton = false;
	static constexpr bool _is_extension = false;
};

} // namespace godot

// Stands first in every class of the extension. Binding itself goes through internal::ClassHooks (class_hooks.hpp).
#define GDCLASS(m_class, m_inherits)                                                                                                       \
private:                                                                                                                                   \
	friend class ::godot::ClassDB;                                                                                                         \
	template <typename> friend struct ::godot::internal::ClassHooks;                                                                       \
                                                                                                                                           \
public:                                                                                                                                    \
	using self_type = m_class;                                                                                                             \
	using parent_type = m_inherits;                                                                                                        \
	static constexpr bool _is_extension = true;                                                                                            \
	static const ::godot::StringName &get_class_static() {                                                                                 \
		static const ::godot::StringName name(#m_class);                                                                                   \
		return name;                                                                                                                       \
	}                                                                                                                                      \
	static const ::godot::StringName &get_parent_class_static() {                                                                          \
		return m_inherits::get_class_static();                                                                                             \
	}                                                                                                                                      \
                                                                                                                                           \
private:

// The same for the engine's classes; generated code only.
#define ENGINE_CLASS(m_class, m_name, m_inherits)                                                                                          \
	template <typename> friend struct ::godot::internal::ClassHooks;                                                                       \
                                                                                                                                           \
public:                                                                                                                                    \
	using self_type = m_class;                                                                                                             \
	using parent_type = m_inherits;                                                                                                        \
	using _engine_type = m_class;                                                                                                          \
	static constexpr const char *_engine_class = #m_name;                                                                                  \
	static const ::godot::StringName &get_class_static();
