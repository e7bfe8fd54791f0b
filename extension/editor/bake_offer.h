// SPDX-License-Identifier: MIT
// Whether a field's ground is to be baked: it stands on its plane, but what is below and above it is uneven.
#pragma once

#include "nodes/grass_field.h"

namespace grass {

// Returns the text of a button that offers to bake; empty: the field has its ground, or its plane is the ground.
godot::String find_bake_offer(const GrassField &p_field);

} // namespace grass
