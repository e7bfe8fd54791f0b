// SPDX-License-Identifier: MIT
// The colours that a terrain tells, to be shown with a filter.
#pragma once

#include "core/fill/terrain_colors.h"

namespace grass {

// What is told lends its colour to texels beside it where nothing is told, else they would pale it. They still count nothing.
std::vector<TerrainColor> picture_of(const TerrainColors &p_colors);

} // namespace grass
