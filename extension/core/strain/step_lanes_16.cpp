// SPDX-License-Identifier: MIT
// As core/solver/step_lanes_16.cpp: compiled for AVX-512, so no other file may use anything from it.
#include "core/strain/step_strains.h"

#if defined(__AVX512F__) && defined(GRASS_IS_ONE_FUNCTION)
#include "core/base/lanes_16.h"

namespace grass {

static float step_strains_16(const TileState &p_tile, StrainState &r_state, std::span<const StrainSpecies> p_species, float p_blend) {
	return step_strains_of<Lanes<16>>(p_tile, r_state, p_species, p_blend);
}
const StrainTileStep STRAIN_LANES_16 = step_strains_16;

} // namespace grass
#else
namespace grass {

const StrainTileStep STRAIN_LANES_16 = nullptr;

} // namespace grass
#endif
