// SPDX-License-Identifier: MIT
// Decides whether the editor offers to bake a field's ground: the field is flat, but the ground below and above it is uneven.
#pragma once

#include "nodes/grass_field.h"

namespace grass {

// Returns the text of a button that offers to bake; empty: the field has its ground, or its plane is the ground.
godot::String find_bake_offer(const GrassField &p_field);

} // namespace grass
