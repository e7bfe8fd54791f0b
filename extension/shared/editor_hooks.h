// SPDX-License-Identifier: MIT
// The functions that the editor has for nodes. Its plugin sets these functions while it runs; nodes know nothing else about it.
#pragma once

#include <godot_cpp/classes/resource.hpp>

namespace grass {

class GrassField;

struct EditorHooks {
	void (*fill)(GrassField &r_field) = nullptr; // fills the field's map by its rule, as one step of the undo history
	void (*mark_edited)(const godot::Ref<godot::Resource> &p_resource) = nullptr; // so that it is saved with the scene
};

// Empty in games.
inline EditorHooks editor_hooks;

} // namespace grass
