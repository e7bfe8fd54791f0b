// SPDX-License-Identifier: MIT
#include "core/solver/step_tile.h"

#include <vector>

namespace grass {

namespace {

float step_lanes_4(TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders) {
	return step_tile<Lanes<4>>(r_state, p_steps, p_blend, p_colliders);
}

#if defined(GRASS_HAS_WIDE)
GRASS_WIDE float step_lanes_8(
		TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders) {
	return step_tile<Lanes<8>>(r_state, p_steps, p_blend, p_colliders);
}
#endif

std::vector<TileStep> find_lane_steps() {
	std::vector<TileStep> steps{ step_lanes_4 };
#if defined(GRASS_HAS_WIDE)
	if (__builtin_cpu_supports("avx2")) {
		steps.push_back(step_lanes_8);
	}
	const bool has_avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
			__builtin_cpu_supports("avx512bw");
	if (STEP_LANES_16 && has_avx512) {
		steps.push_back(STEP_LANES_16);
	}
#endif
	return steps;
}

} // namespace

std::span<const TileStep> get_lane_steps() {
	static const std::vector<TileStep> steps = find_lane_steps();
	return steps;
}

float step_lanes(TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders) {
	return get_lane_steps().back()(r_state, p_steps, p_blend, p_colliders);
}

} // namespace grass
