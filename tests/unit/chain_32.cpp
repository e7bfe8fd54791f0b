// SPDX-License-Identifier: MIT
// The solver with 32 knots, in a namespace of its own: all of it is compiled here once more, for lanes that every processor has.
#include "chain_32.h"

#define GRASS_KNOTS 32
#define grass grass_32

#include "core/bodies/collider.cpp"
#include "core/solver/blade_order.cpp"
#include "core/solver/section.cpp"
#include "core/solver/solver_params.cpp"
#include "core/solver/step_tile.h"

#include "rolled_blades.h"
#include "swinging_blades.h"

namespace grass {

float step_lanes(TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders) {
	return step_tile<Lanes<4>>(r_state, p_steps, p_blend, p_colliders);
}

namespace test {

std::vector<Look> roll_32_through(const Roll &p_roll, const Stepping &p_stepping, double p_looks) {
	return roll_through(p_roll, p_stepping, p_looks);
}

Swing swing_32_chains(SwingKind p_kind, double p_rate) {
	return swing_chains(p_kind, p_rate);
}

} // namespace test

} // namespace grass
