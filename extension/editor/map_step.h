// SPDX-License-Identifier: MIT
// Changes of fields' maps as one step of the editor's history: of a field's own map, or of a plot, which may leave memory meanwhile.
#pragma once

#include "world/grass_world.h"

#include <godot_cpp/classes/editor_undo_redo_manager.hpp>

#include <span>

namespace grass {

struct MapStep {
	godot::Ref<GrassMap> map; // as it is now
	godot::Ref<GrassMapSnapshot> before;
	GrassField *new_of = nullptr; // the field that got this map in the step; null: it had it before
	GrassWorld *world = nullptr; // of whose plot it is the map, or null
	godot::Vector2i plot = {};
};

// The changes are done already. p_context: its scene keeps the step. Each map once.
void add_map_steps(
		godot::EditorUndoRedoManager *p_history, const godot::String &p_name, godot::Object *p_context, std::span<const MapStep> p_steps);

} // namespace grass
