// SPDX-License-Identifier: MIT
// Species that are dragged onto the toolbar: from the file dock, or from another resource in the inspector.
#pragma once

#include "nodes/grass_species.h"

#include <godot_cpp/variant/typed_array.hpp>

namespace grass {

// p_dragged: as the editor's docks give it. Empty: something else is dragged.
godot::TypedArray<GrassSpecies> find_dragged_species(const godot::Variant &p_dragged);

} // namespace grass
