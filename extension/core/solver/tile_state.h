// SPDX-License-Identifier: MIT
// The blades of one awake tile on the CPU. Only simulate.cpp and the step write it.
#pragma once

#include "core/base/layout.h"
#include "core/bodies/collider.h"
#include "core/solver/strain/constants.h"
#include "core/solver/tile_step.h"

namespace grass {

// The effect of forces on the blades of a tile in a step, [Eq W6]: acceleration, m/s^2, and drag, 1/s. Lives for one step.
struct alignas(64) AirLoad {
	float load[3][GRASS_BLADES_PER_TILE];
	float drag[GRASS_BLADES_PER_TILE];
};

template <class T> struct StrainSection;

// Blades are side by side within each component of a knot, as in the GPU's buffers. Metres, blade space. Rest pose and roots are computed
// when the tile wakes; knots change in every step.
struct alignas(64) TileState {
	float rest[3][GRASS_KNOTS][GRASS_BLADES_PER_TILE];
	float knots[3][GRASS_FREE_KNOTS][GRASS_BLADES_PER_TILE];
	float before[3][GRASS_FREE_KNOTS][GRASS_BLADES_PER_TILE]; // one step earlier
	float twist[GRASS_FREE_KNOTS][GRASS_BLADES_PER_TILE]; // of the joint below each knot, radians
	float calm[GRASS_BLADES_PER_TILE]; // METHOD_PBD: what kept_calm() returned, [Eq 48]
	// [Eq Q1] If the last step moved the blades by their strains: these, now and one step earlier. Knots and twists follow them.
	float strains[GRASS_STRAINS][GRASS_BLADES_PER_TILE];
	float strains_before[GRASS_STRAINS][GRASS_BLADES_PER_TILE];
	float width[2][GRASS_BLADES_PER_TILE]; // x and z of the direction of a blade's width at its root
	float root[3][GRASS_BLADES_PER_TILE]; // relative to the tile's centre
	uint8_t species[GRASS_BLADES_PER_TILE];
	bool has_strains; // the last step moved the blades by their strains
	bool is_far; // GRASS_SLOT_FAR: contact_rate does not apply
	int left_out; // how many of them, the last ones, this step does not simulate
	const AirLoad *air; // for this step; null where no force moves the tile
	// For this step, one for each species: it moves the blades by their strains. Null: as chains.
	const StrainSection<float> *sections;
};

} // namespace grass
