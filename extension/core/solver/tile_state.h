// SPDX-License-Identifier: MIT
// The blades of one awake tile on the CPU. Only simulate.cpp and the step write it.
#pragma once

#include "core/base/layout.h"
#include "core/bodies/collider.h"
#include "core/solver/tile_step.h"

namespace grass {

// The effect of forces on the blades of a tile in a step, [Eq W6]: acceleration, m/s^2, and drag, 1/s. Lives for one step.
struct alignas(64) AirLoad {
	float load[3][GRASS_BLADES_PER_TILE];
	float drag[GRASS_BLADES_PER_TILE];
};

// One blade beside the other within each knot's component, as the GPU's buffers have them. Metres, blade space. Rest pose
// and roots are made when the tile wakes, knots change every step.
struct alignas(64) TileState {
	float rest[3][GRASS_KNOTS][GRASS_BLADES_PER_TILE];
	float knots[3][GRASS_FREE_KNOTS][GRASS_BLADES_PER_TILE];
	float before[3][GRASS_FREE_KNOTS][GRASS_BLADES_PER_TILE]; // one step earlier
	float twist[GRASS_FREE_KNOTS][GRASS_BLADES_PER_TILE]; // of the joint below each knot, radians
	float width[2][GRASS_BLADES_PER_TILE]; // x and z of where a blade's width points at the root
	float root[3][GRASS_BLADES_PER_TILE]; // from the tile's centre
	uint8_t species[GRASS_BLADES_PER_TILE];
	const AirLoad *air; // of this step; null where no force moves the tile
};

} // namespace grass
