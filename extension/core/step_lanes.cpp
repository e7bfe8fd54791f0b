// SPDX-License-Identifier: MIT
#include "core/step_tile.h"

namespace grass {

namespace {

#if defined(__x86_64__) && defined(GRASS_IS_ONE_FUNCTION)
// The same arithmetic, bit for bit, in half as many instructions.
__attribute__((target("avx2"))) float step_lanes_avx2(
		TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders) {
	return step_tile<Lanes>(r_state, p_steps, p_blend, p_colliders);
}
bool has_avx2() {
	return __builtin_cpu_supports("avx2");
}
#else
constexpr auto step_lanes_avx2 = step_scalar_float;
constexpr bool has_avx2() {
	return false;
}
#endif

} // namespace

float step_lanes(TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders) {
	static const bool is_wide = has_avx2();
	return is_wide ? step_lanes_avx2(r_state, p_steps, p_blend, p_colliders) : step_tile<Lanes>(r_state, p_steps, p_blend, p_colliders);
}

} // namespace grass
