// SPDX-License-Identifier: MIT
// The blades of one awake tile on the CPU, and their step. Written by simulate.cpp and by the step, nowhere else.
#pragma once

#include "core/base/layout.h"
#include "core/bodies/collider.h"

#include <span>

namespace grass {

// One blade beside the other within each knot's component, as the GPU's buffers have them. Metres, blade space. Rest pose
// and roots are made when the tile wakes, knots change every step.
struct alignas(64) TileState {
	float rest[3][GRASS_KNOTS][GRASS_BLADES_PER_TILE];
	float knots[3][GRASS_FREE_KNOTS][GRASS_BLADES_PER_TILE];
	float before[3][GRASS_FREE_KNOTS][GRASS_BLADES_PER_TILE]; // one step earlier
	float twist[GRASS_FREE_KNOTS][GRASS_BLADES_PER_TILE]; // of the joint below each knot, radians
	float root[3][GRASS_BLADES_PER_TILE]; // from the tile's centre
	uint8_t species[GRASS_BLADES_PER_TILE];
};

// One step of all blades of a tile; the energy of the liveliest, [Eq 19]. p_steps: one for all blades, or one for each species.
// The colliders are those of this tile.
using TileStep = float (*)(
		TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders);
float step_lanes(TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders);
float step_scalar_float(TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders);
float step_scalar_double(TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders);

// The versions of step_lanes() that this machine can run, the fastest last. It takes that one; all compute the same bits.
std::span<const TileStep> get_lane_steps();
// Sixteen blades at a time, for AVX-512 only; null where the build has none.
extern const TileStep STEP_LANES_16;

} // namespace grass
