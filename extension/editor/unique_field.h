// SPDX-License-Identifier: MIT
// Gives a field its own copies of what it shares with others.
#pragma once

#include "nodes/grass_field.h"

namespace grass {

// One step of the undo history each. The second also copies rule, species and patches that are not files of their own.
void make_map_unique(GrassField &r_field);
void make_unique(GrassField &r_field);

} // namespace grass
