// SPDX-License-Identifier: MIT
// A change of a field's map as one step of the editor's history.
#pragma once

#include "nodes/grass_field.h"

#include <godot_cpp/classes/editor_undo_redo_manager.hpp>

namespace grass {

struct MapStep {
	godot::Object *context; // its scene keeps the step
	godot::Ref<GrassMap> map; // as it is now
	godot::Ref<GrassMapSnapshot> before;
	GrassField *new_of = nullptr; // the field that got this map in the step; null: it had it before
};

// The change is done already.
void add_map_step(godot::EditorUndoRedoManager *p_history, const godot::String &p_name, const MapStep &p_step);

} // namespace grass
