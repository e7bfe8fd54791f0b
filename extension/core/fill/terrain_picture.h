// SPDX-License-Identifier: MIT
// The terrain's colours, ready to be sampled with a filter.
#pragma once

#include "core/fill/terrain_colors.h"

namespace grass {

// Texels without a colour copy the colour beside them, since filtering would pale it otherwise. Their weight stays 0.
std::vector<TerrainColor> picture_of(const TerrainColors &p_colors);

} // namespace grass
