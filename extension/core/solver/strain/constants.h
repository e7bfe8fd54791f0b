// SPDX-License-Identifier: MIT
// shaders/strain/constants.inc as C++.
#pragma once

#include "core/base/layout.h"

namespace grass {

#define GRASS_CONSTANT inline constexpr
#include "strain/constants.inc"
#undef GRASS_CONSTANT

} // namespace grass
