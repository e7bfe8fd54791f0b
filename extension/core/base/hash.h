// SPDX-License-Identifier: MIT
// shaders/base/hash.inc as C++: grass_hash, grass_tile_bits, grass_tile_start, grass_tile_hash.
#pragma once

#include "core/base/layout.h"

namespace grass {

using uint = uint32_t;

#define GRASS_FUNCTION constexpr
#include "base/hash.inc"
#undef GRASS_FUNCTION

static_assert(GRASS_START_COUNT % 4 == 0);
static_assert((GRASS_START_COUNT - 1) * GRASS_START_STRIDE + GRASS_BLADES_PER_TILE <= GRASS_PATCH_BLADES);

} // namespace grass
