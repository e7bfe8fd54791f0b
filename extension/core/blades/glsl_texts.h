// SPDX-License-Identifier: MIT
// Compiles the texts in shaders/blades/ about clumps, rest poses, colours and wind as C++.
#pragma once

#include "core/base/glsl.h"

namespace grass::glsl {

#define GRASS_FUNCTION inline
#include "blades/clump.inc" // before the others, which want it

#include "blades/blade.inc"
#include "blades/color.inc"
#include "blades/sun.inc"
#include "blades/wind.inc"

#include "blades/force.inc"
#undef GRASS_FUNCTION

} // namespace grass::glsl
