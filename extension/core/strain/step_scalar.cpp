// SPDX-License-Identifier: MIT
// The scalar versions, against which the wide one is measured and tested.
#include "core/strain/step_strains.h"

namespace grass {

void find_lengths(const TileState &p_tile, StrainState &r_state) {
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		float sum = 0.0f;
		for (int s = 0; s < GRASS_SEGMENTS; s++) {
			sum += length(load_knot<float>(p_tile.rest, s + 1, b) - load_knot<float>(p_tile.rest, s, b));
		}
		r_state.lengths[b] = sum;
	}
}

float step_strains_float(const TileState &p_tile, StrainState &r_state, std::span<const StrainSpecies> p_species, float p_blend) {
	return step_strains_of<float>(p_tile, r_state, p_species, p_blend);
}

float step_strains_double(const TileState &p_tile, StrainState &r_state, std::span<const StrainSpecies> p_species, float p_blend) {
	return step_strains_of<double>(p_tile, r_state, p_species, p_blend);
}

} // namespace grass
