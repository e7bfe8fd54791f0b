// SPDX-License-Identifier: MIT
// The extension's classes as the engine learns of them.
#pragma once

#include <godot_cpp/classes/class_db_singleton.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/core/method_bind.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#define DEFVAL(m_value) (m_value)

namespace godot {

// A method's name and those of its arguments.
struct MethodDefinition {
	StringName name;
	std::vector<StringName> _arguments;
};

template <typename... Names> MethodDefinition D_METHOD(const StringName &p_name, const Names &...p_arguments) {
	return { p_name, { StringName(p_arguments)... } };
}

class ClassDB {
public:
	template <typename T> static void register_class(bool p_virtual = false) { register_as<T>(Kind{ .is_virtual = p_virtual }); }
	template <typename T> static void register_internal_class() { register_as<T>(Kind{ .is_exposed = false }); }

	template <typename F, typename... Defaults>
	static void bind_method(const MethodDefinition &p_definition, F p_function, const Defaults &...p_defaults) {
		using Class = typename internal::FunctionTraits<F>::Class;
		add_method(Class::get_class_static(), new internal::MethodBindOf<Class, F>(p_function), p_definition, { Variant(p_defaults)... });
	}
	template <typename F, typename... Defaults> static void bind_method(const char *p_name, F p_function, const Defaults &...p_defaults) {
		bind_method(D_METHOD(p_name), p_function, p_defaults...);
	}
	template <typename F, typename... Defaults>
	static void bind_static_method(
			const StringName &p_class, const MethodDefinition &p_definition, F p_function, const Defaults &...p_defaults) {
		add_method(p_class, new internal::MethodBindOf<void, F>(p_function), p_definition, { Variant(p_defaults)... });
	}

	static void add_property(const StringName &p_class, const PropertyInfo &p_info, const StringName &p_setter, const StringName &p_getter,
			int p_index = -1);
	static void add_property_group(const StringName &p_class, const String &p_name, const String &p_prefix);
	static void add_signal(const StringName &p_class, const MethodInfo &p_signal);
	static void bind_integer_constant(
			const StringName &p_class, const StringName &p_enum, const StringName &p_name, int64_t p_value, bool p_bitfield = false);

	// Called by the library's entry, level by level.
	static void initialize(GDExtensionInitializationLevel p_level);
	static void deinitialize(GDExtensionInitializationLevel p_level);

private:
	struct Kind {
		bool is_virtual = false; // scripts may inherit it but not make one
		bool is_exposed = true; // scripts see it
	};

	template <typename T> static void register_as(Kind p_kind) {
		static_assert(std::is_same_v<typename T::self_type, T>, "Put GDCLASS(the class, its base) at its top.");
		using Hooks = internal::ClassHooks<T>;
		GDExtensionClassCreationInfo5 info = {};
		info.is_virtual = p_kind.is_virtual;
		info.is_exposed = p_kind.is_exposed;
		info.set_func = &Hooks::set;
		info.get_func = &Hooks::get;
		info.get_property_list_func = Hooks::HAS_LIST ? &Hooks::get_property_list : nullptr;
		info.free_property_list_func = &internal::free_property_list;
		info.validate_property_func = &Hooks::validate_property;
		info.notification_func = &Hooks::notification;
		info.create_instance_func = &Hooks::create;
		info.free_instance_func = &Hooks::free;
		info.recreate_instance_func = &Hooks::recreate;
		add_class(T::get_class_static(), T::get_parent_class_static(), info);
		Hooks::bind();
	}
	static void add_class(const StringName &p_name, const StringName &p_parent, GDExtensionClassCreationInfo5 &p_info);
	static void add_method(const StringName &p_class, internal::MethodBind *p_method, const MethodDefinition &p_definition,
			std::vector<Variant> p_defaults);
};

namespace internal {

// The name under which the engine knows the enum of a constant.
template <typename T> StringName enum_name_of(T) {
	return GetTypeInfo<T>::get_class_info().class_name;
}

} // namespace internal

} // namespace godot

#define GDREGISTER_CLASS(m_class) ::godot::ClassDB::register_class<m_class>();
#define GDREGISTER_INTERNAL_CLASS(m_class) ::godot::ClassDB::register_internal_class<m_class>();

#define BIND_ENUM_CONSTANT(m_constant)                                                                                                     \
	::godot::ClassDB::bind_integer_constant(get_class_static(), ::godot::internal::enum_name_of(m_constant), #m_constant, m_constant);
