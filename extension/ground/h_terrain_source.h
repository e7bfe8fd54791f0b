// SPDX-License-Identifier: MIT
// The HTerrain of another add-on as a TerrainSource.
#pragma once

#include "ground/terrain_source.h"

namespace grass {

// Returns the source, or null if the two lack the methods of HTerrain. p_data: what get_data() of the node returned.
std::unique_ptr<TerrainSource> make_h_terrain_source(godot::Node *p_node, godot::Object *p_data);

} // namespace grass
