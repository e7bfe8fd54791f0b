// SPDX-License-Identifier: MIT
// The plain versions, against which the wide one is measured and tested.
#include "core/step_tile.h"

namespace grass {

float step_scalar_float(TileState &r_state, const GrassStep &p_step, float p_blend, std::span<const TileCollider> p_colliders) {
	return step_tile<float>(r_state, p_step, p_blend, p_colliders);
}

float step_scalar_double(TileState &r_state, const GrassStep &p_step, float p_blend, std::span<const TileCollider> p_colliders) {
	return step_tile<double>(r_state, p_step, p_blend, p_colliders);
}

} // namespace grass
