// SPDX-License-Identifier: MIT
// Species and pictures that are dragged onto the toolbar, from the file dock or from another resource in the inspector; and what grew
// before a drop.
#pragma once

#include "nodes/grass_field.h"

#include <godot_cpp/classes/texture2d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace grass {

// p_dragged: as the editor's docks provide it. Empty: something else is dragged.
godot::TypedArray<GrassSpecies> find_dragged_species(const godot::Variant &p_dragged);
// Returns what a field grows that names no species, under the name by which the editor calls it.
godot::Ref<GrassSpecies> make_default_species();
// Returns the field's species, in the order of their numbers: at least one.
godot::TypedArray<GrassSpecies> find_grown_species(const GrassField &p_field);
// Returns a single picture, for a stamp; null: something else is dragged.
godot::Ref<godot::Texture2D> find_dragged_picture(const godot::Variant &p_dragged);

} // namespace grass
