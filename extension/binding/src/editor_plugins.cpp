// SPDX-License-Identifier: MIT
#include <godot_cpp/classes/editor_plugin_registration.hpp>

#include <godot_cpp/godot.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <algorithm>
#include <vector>

namespace godot {

namespace engine = gdextension_interface;

namespace {

std::vector<StringName> plugin_classes;

} // namespace

void EditorPlugins::add_plugin_class(const StringName &p_class_name) {
	ERR_FAIL_COND_MSG(std::find(plugin_classes.begin(), plugin_classes.end(), p_class_name) != plugin_classes.end(),
			vformat("The editor plugin '%s' is there already.", p_class_name));
	plugin_classes.push_back(p_class_name);
	engine::editor_add_plugin(p_class_name._native_ptr());
}

void EditorPlugins::deinitialize(GDExtensionInitializationLevel p_level) {
	if (p_level != GDEXTENSION_INITIALIZATION_EDITOR) {
		return;
	}
	for (; !plugin_classes.empty(); plugin_classes.pop_back()) {
		engine::editor_remove_plugin(plugin_classes.back()._native_ptr());
	}
	plugin_classes.shrink_to_fit();
}

} // namespace godot
