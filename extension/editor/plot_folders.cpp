// SPDX-License-Identifier: MIT
#include "editor/plot_folders.h"

#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/classes/packed_scene.hpp>
#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/classes/scene_state.hpp>

using namespace godot;

namespace grass {

namespace {

// Returns whether a scene may have a folder, by its text: loading a scene loads everything that it uses. Imported scenes have no worlds.
bool may_have_folder(const String &p_scene) {
	const String extension = p_scene.get_extension();
	return extension == "scn" || (extension == "tscn" && FileAccess::get_file_as_string(p_scene).contains("folder = \""));
}

} // namespace

PackedStringArray find_plot_folders(const String &p_scene) {
	PackedStringArray folders;
	if (!may_have_folder(p_scene)) {
		return folders;
	}
	const Ref<PackedScene> scene = ResourceLoader::get_singleton()->load(p_scene, "PackedScene");
	const Ref<SceneState> state = scene.is_valid() ? scene->get_state() : Ref<SceneState>();
	for (int32_t node = 0; state.is_valid() && node < state->get_node_count(); node++) {
		const StringName type = state->get_node_type(node);
		if (type != StringName("GrassWorld") && !type.is_empty()) { // empty: a node of another scene, with values of its own here
			continue;
		}
		for (int32_t i = 0; i < state->get_node_property_count(node); i++) {
			const String folder = state->get_node_property_name(node, i) == StringName("folder")
					? String(state->get_node_property_value(node, i))
					: String();
			if (folder.begins_with("res://") && !folders.has(folder)) {
				folders.push_back(folder);
			}
		}
	}
	return folders;
}

} // namespace grass
