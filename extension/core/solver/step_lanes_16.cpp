// SPDX-License-Identifier: MIT
// The only file that is compiled for AVX-512 (SConstruct sets the flags); step_lanes() calls it if the processor supports that. No other
// file may use anything from it: the linker keeps one copy of an inline function, and that must not be this one. So it works on a type of
// its own, whatever is no template is always inlined, and Eigen (through the colliders) uses no vector instructions, as everywhere.
#include "core/solver/step_tile.h"

#if defined(__AVX512F__) && defined(GRASS_IS_ONE_FUNCTION)
#include "core/base/lanes_16.h"

namespace grass {

static float step_lanes_16(
		TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders) {
	return step_tile<Lanes<16>>(r_state, p_steps, p_blend, p_colliders);
}
const TileStep STEP_LANES_16 = step_lanes_16;

} // namespace grass
#else
namespace grass {

const TileStep STEP_LANES_16 = nullptr;

} // namespace grass
#endif
