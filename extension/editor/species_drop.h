// SPDX-License-Identifier: MIT
// Species and pictures that are dragged onto the toolbar, from the file dock or from another resource in the inspector; and what grew
// before a drop.
#pragma once

#include "nodes/grass_field.h"

#include <godot_cpp/classes/texture2d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace grass {

// Returns the species that are dragged; empty: something else is. p_dragged: as the editor's docks provide it.
godot::TypedArray<GrassSpecies> find_dragged_species(const godot::Variant &p_dragged);
// Returns the species of a field that names none, under the name that the editor gives it.
godot::Ref<GrassSpecies> make_default_species();
// Returns the field's species, in the order of their numbers: at least one.
godot::TypedArray<GrassSpecies> find_grown_species(const GrassField &p_field);
// Returns the single picture that is dragged, for a stamp; null: something else is.
godot::Ref<godot::Texture2D> find_dragged_picture(const godot::Variant &p_dragged);

} // namespace grass
