// SPDX-License-Identifier: MIT
// Editor plugins that the library brings: register the class at the EDITOR level, then add it here.
#pragma once

#include <godot_cpp/variant/string_name.hpp>

namespace godot {

class EditorPlugins {
public:
	static void add_plugin_class(const StringName &p_class_name);
	template <typename T> static void add_by_type() { add_plugin_class(T::get_class_static()); }
	// Called by the library's entry: the plugins go before their classes do.
	static void deinitialize(GDExtensionInitializationLevel p_level);
};

} // namespace godot
