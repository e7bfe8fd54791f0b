// SPDX-License-Identifier: MIT
#include "core/strain/step_strains.h"

#include <vector>

namespace grass {

namespace {

float step_strains_4(const TileState &p_tile, StrainState &r_state, std::span<const StrainSpecies> p_species, float p_blend) {
	return step_strains_of<Lanes<4>>(p_tile, r_state, p_species, p_blend);
}

#if defined(GRASS_HAS_WIDE)
GRASS_WIDE float step_strains_8(const TileState &p_tile, StrainState &r_state, std::span<const StrainSpecies> p_species, float p_blend) {
	return step_strains_of<Lanes<8>>(p_tile, r_state, p_species, p_blend);
}
#endif

// The same widths as the solver's.
std::vector<StrainTileStep> find_strain_steps() {
	std::vector<StrainTileStep> steps{ step_strains_4 };
#if defined(GRASS_HAS_WIDE)
	const size_t count = get_lane_steps().size();
	if (count > 1) {
		steps.push_back(step_strains_8);
	}
	if (count > 2) {
		steps.push_back(STRAIN_LANES_16);
	}
#endif
	return steps;
}

} // namespace

std::span<const StrainTileStep> get_strain_steps() {
	static const std::vector<StrainTileStep> steps = find_strain_steps();
	return steps;
}

float step_strains(const TileState &p_tile, StrainState &r_state, std::span<const StrainSpecies> p_species, float p_blend) {
	return get_strain_steps().back()(p_tile, r_state, p_species, p_blend);
}

} // namespace grass
