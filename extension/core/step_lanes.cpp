// SPDX-License-Identifier: MIT
#include "core/step_tile.h"

namespace grass {

#if defined(GRASS_HAS_WIDE)
namespace {

GRASS_WIDE float step_lanes_wide(
		TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders) {
	return step_tile<Lanes>(r_state, p_steps, p_blend, p_colliders);
}

} // namespace
#endif

float step_lanes(TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders) {
#if defined(GRASS_HAS_WIDE)
	if (is_wide()) {
		return step_lanes_wide(r_state, p_steps, p_blend, p_colliders);
	}
#endif
	return step_tile<Lanes>(r_state, p_steps, p_blend, p_colliders);
}

} // namespace grass
