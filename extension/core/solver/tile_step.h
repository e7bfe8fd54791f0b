// SPDX-License-Identifier: MIT
// The step of one awake tile on the CPU, for callers.
#pragma once

#include "core/base/layout.h"

#include <span>

namespace grass {

// The most blades that a version of the step takes at a time.
inline constexpr int MOST_LANES = 16;

struct TileCollider;
struct TileState;

// Takes one step of the blades of a tile without TileState::left_out, a multiple of MOST_LANES. Returns the energy of the liveliest blade,
// [Eq 19]. p_steps: one for all blades, or one for each species. p_colliders: those of this tile.
using TileStep = float (*)(
		TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders);
float step_lanes(TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders);
float step_scalar_float(TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders);
float step_scalar_double(TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders);

// Returns the versions of step_lanes() that this machine can run, the fastest last. step_lanes() uses that one; all compute the same bits.
std::span<const TileStep> get_lane_steps();
// Steps sixteen blades at a time, for AVX-512 only; null if the build has none.
extern const TileStep STEP_LANES_16;

} // namespace grass
