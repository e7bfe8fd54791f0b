// SPDX-License-Identifier: MIT
// The effect of the map on the grass at one place. shaders/map/growth.inc as C++.
#pragma once

#include "core/blades/clump.h"
#include "core/map/ground_grid.h"
#include "core/map/map_channels.h"

namespace grass {

namespace glsl {
#define GRASS_FUNCTION inline
#include "map/growth.inc"
#undef GRASS_FUNCTION
} // namespace glsl
using Growth = glsl::GrassGrowth;

static_assert(MAP_CHUNK_SIZE == GRASS_CHUNK_SIZE && float(MAP_UNCUT) == float(GRASS_UNCUT));
static_assert(info_of(MAP_LEDGE).side == GRASS_LEDGE_TEXELS && info_of(MAP_LEDGE).initial[0] == GRASS_LEDGE_NONE);
static_assert(info_of(MAP_DENSITY).side == GRASS_FINE_TEXELS && info_of(MAP_HEIGHT).side == GRASS_COARSE_TEXELS);

static_assert(int(GroundSplit::BLENDED) == GRASS_GROUND_BLENDED && int(GroundSplit::ACROSS) == GRASS_GROUND_ACROSS);
static_assert(int(GroundSplit::BESIDE) == GRASS_GROUND_BESIDE);

// How far blades follow the ground's slope. 0: they grow upright, like grass; 1: at a right angle to the ground, like hair.
inline constexpr Tunable FOLLOW_SLOPE{ "follow_slope", "", 0.0, 1.0, 0.01, 0.25 };

// The height of grass where the map has the least of it, as a share: less than 1 lets paths and the borders of stands slope down.
inline constexpr Tunable SPARSE_HEIGHT{ "sparse_height", "", 0.1, 1.0, 0.01, 1.0 };

// Returns how far following the slope can move the tip of a blade of 1 m, on ground of up to 60 degrees, in metres.
inline float slope_lean(float p_follow) {
	const float tilt = glsl::grass_ground_tilt(glsl::vec2(0.8660254f, 0.0f), p_follow).x; // tangent of half the angle
	return 2.0f * tilt / std::sqrt(1.0f + tilt * tilt);
}

} // namespace grass
