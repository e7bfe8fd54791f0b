// SPDX-License-Identifier: MIT
// shaders/solver/constants.inc as C++: the constants of the solver.
#pragma once

namespace grass {

#define GRASS_CONSTANT inline constexpr
#include "solver/constants.inc"
#undef GRASS_CONSTANT

} // namespace grass
