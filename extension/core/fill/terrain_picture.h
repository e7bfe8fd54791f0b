// SPDX-License-Identifier: MIT
// The terrain's colours, ready to be sampled with a filter.
#pragma once

#include "core/fill/terrain_colors.h"

namespace grass {

// Makes the picture. Texels without a colour copy a neighbour's, since filtering would pale it otherwise. Their weight stays 0.
std::vector<TerrainColor> picture_of(const TerrainColors &p_colors);

} // namespace grass
