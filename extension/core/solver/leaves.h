// SPDX-License-Identifier: MIT
// shaders/solver/leaves.inc as C++: small functions of the solver, over any lane type.
#pragma once

#include "core/base/lanes.h"
#include "core/base/layout.h"
#include "core/solver/constants.h"

namespace grass {

#define GRASS_FUNCTION inline constexpr
#define GRASS_LANES template <class T> GRASS_INLINE
#define IN_T const T &
#include "solver/leaves.inc"
#undef IN_T
#undef GRASS_LANES
#undef GRASS_FUNCTION

} // namespace grass
