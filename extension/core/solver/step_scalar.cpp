// SPDX-License-Identifier: MIT
// The scalar versions, against which the wide one is measured and tested.
#include "core/solver/step_tile.h"

namespace grass {

float step_scalar_float(TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders) {
	return step_tile<float>(r_state, p_steps, p_blend, p_colliders);
}

float step_scalar_double(TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders) {
	return step_tile<double>(r_state, p_steps, p_blend, p_colliders);
}

} // namespace grass
