// SPDX-License-Identifier: MIT
// Species and pictures that are dragged onto the toolbar, from the file dock or from another resource in the inspector.
#pragma once

#include "resources/grass_species.h"

#include <godot_cpp/classes/texture2d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace grass {

// p_dragged: as the editor's docks provide it. Empty: something else is dragged.
godot::TypedArray<GrassSpecies> find_dragged_species(const godot::Variant &p_dragged);
// Returns a single picture, for a stamp; null: something else is dragged.
godot::Ref<godot::Texture2D> find_dragged_picture(const godot::Variant &p_dragged);

} // namespace grass
