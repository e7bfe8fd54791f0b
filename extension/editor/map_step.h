// SPDX-License-Identifier: MIT
// Changes of fields' maps as one step of the editor's undo history: of a field's own map, or of a plot, which may leave memory meanwhile.
#pragma once

#include "world/grass_world.h"

#include <godot_cpp/classes/editor_undo_redo_manager.hpp>

#include <functional>
#include <span>

namespace grass {

struct MapStep {
	godot::Ref<GrassMap> map; // with the changes
	godot::Ref<GrassMapSnapshot> before;
	GrassField *new_of = nullptr; // the field that got this map in the step; null: it had the map before
	GrassWorld *world = nullptr; // the world if this is the map of one of its plots, or null
	godot::Vector2i plot = {};
};

// Changes the maps of these fields, and adds that as one step. p_change returns whether it did anything. p_world: the world whose plots
// they are, or null. p_follows: a field without a map that gets one also gets the ground below it.
using MapChange = std::function<bool(GrassField &r_field, GrassMap &r_map)>;
void change_maps(godot::EditorUndoRedoManager *p_history, const godot::String &p_name, std::span<GrassField *const> p_fields,
		GrassWorld *p_world, bool p_follows, const MapChange &p_change);

// Adds changes that are already done. p_context: the step goes into the history of its scene. Each map may occur once.
void add_map_steps(
		godot::EditorUndoRedoManager *p_history, const godot::String &p_name, godot::Object *p_context, std::span<const MapStep> p_steps);

} // namespace grass
