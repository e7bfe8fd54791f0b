// SPDX-License-Identifier: MIT
// For the generated sources only: makes the engine's classes known to the binding.
#pragma once

#include <godot_cpp/core/class_hooks.hpp>

namespace godot::internal {

void register_engine_class(const StringName &p_name, const GDExtensionInstanceBindingCallbacks *p_callbacks);
template <typename T> void register_engine_class() {
	register_engine_class(T::get_class_static(), &engine_callbacks<T>);
}
void register_engine_classes(); // generated: all of them

} // namespace godot::internal

#define ENGINE_CLASS_DEFINE(m_class)                                                                                                       \
	const StringName &m_class::get_class_static() {                                                                                        \
		static const StringName name(_engine_class);                                                                                       \
		return name;                                                                                                                       \
	}
