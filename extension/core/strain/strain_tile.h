// SPDX-License-Identifier: MIT
// The free blades of a tile by their strains, and their step, for callers.
#pragma once

#include "core/solver/tile_state.h"
#include "core/strain/strain.h"

#include <span>

namespace grass {

// Blades are side by side, as in TileState, which has their rest pose.
struct alignas(64) StrainState {
	float strains[GRASS_STRAINS][GRASS_BLADES_PER_TILE];
	float before[GRASS_STRAINS][GRASS_BLADES_PER_TILE]; // one step earlier
	float offsets[3][GRASS_FREE_KNOTS][GRASS_BLADES_PER_TILE]; // of the knots from rest, metres
	float lengths[GRASS_BLADES_PER_TILE]; // metres, set by find_lengths()
	float masses_before[3][GRASS_STRAIN_MASSES][GRASS_BLADES_PER_TILE]; // of every second one, a step earlier
};

// A species in a step: what StepClock makes of it, and its section.
struct StrainSpecies {
	GrassStep step;
	StrainSection<float> section;
};

// Measures the blades of a tile that wakes.
void find_lengths(const TileState &p_tile, StrainState &r_state);

// Takes one step of all blades of a tile, as if nothing were near them. Returns the energy of the liveliest blade, [Eq Q10]. p_species: one
// for all blades, or one for each species.
using StrainTileStep = float (*)(const TileState &p_tile, StrainState &r_state, std::span<const StrainSpecies> p_species, float p_blend);
float step_strains(const TileState &p_tile, StrainState &r_state, std::span<const StrainSpecies> p_species, float p_blend);
float step_strains_float(const TileState &p_tile, StrainState &r_state, std::span<const StrainSpecies> p_species, float p_blend);
float step_strains_double(const TileState &p_tile, StrainState &r_state, std::span<const StrainSpecies> p_species, float p_blend);

// As get_lane_steps() of the solver.
std::span<const StrainTileStep> get_strain_steps();
extern const StrainTileStep STRAIN_LANES_16;

} // namespace grass
