// SPDX-License-Identifier: MIT
// Virtual methods of the engine's classes that a class of the extension overrides.
#pragma once

#include <godot_cpp/core/binder_common.hpp>

namespace godot::internal {

void bind_virtual_method(const StringName &p_class, const char *p_method, GDExtensionClassCallVirtual p_call, uint32_t p_hash);

// Binds T's method if T itself overrides Base's: only then does its pointer name another class.
template <typename T, auto METHOD, auto BASE_METHOD> void bind_virtual(const char *p_name, uint32_t p_hash) {
	if constexpr (!std::is_same_v<decltype(METHOD), decltype(BASE_METHOD)>) {
		const GDExtensionClassCallVirtual call = [](GDExtensionClassInstancePtr p_instance, const GDExtensionConstTypePtr *p_arguments,
														 GDExtensionTypePtr r_result) {
			call_with_ptr_args(reinterpret_cast<T *>(p_instance), METHOD, p_arguments, r_result);
		};
		bind_virtual_method(T::get_class_static(), p_name, call, p_hash);
	}
}

} // namespace godot::internal
