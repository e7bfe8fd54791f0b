// SPDX-License-Identifier: MIT
// The input of one simulation step, the same for the GPU and the CPU backend.
#pragma once

#include "core/base/layout.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <span>

namespace grass {

// How the blades of an awake tile grow, if a map or a mix of species determines it. Made when the tile wakes, and when the map changes
// below it.
struct SlotGrowth {
	int slot = GRASS_NO_SLOT;
	std::array<vec4, GRASS_BLADES_PER_TILE> blades; // factor on the length; lean x, z; ground below the root, metres
	std::array<uint8_t, GRASS_BLADES_PER_TILE> species{}; // the species of each blade
};

// Views only: TileManager owns the arrays, which are valid until its next update().
struct StepInput {
	std::span<const GrassSlot> slots; // Retired tiles first, then live ones, ascending by slot.
	std::span<const GrassCollider> colliders; // Field space, each relative to its anchor tile.
	std::span<const uint32_t> collider_list; // Indices into colliders; GrassSlot.list.y and .z give each tile's part.
	std::span<const Eigen::Vector4f> planes; // Hull planes in the collider's own space: n.xyz, d; n.x <= d inside; metres.
	GrassStep step; // The solver's parameters for this step.
	uint64_t number = 0; // Of this step: the first is 1, and they increase.
	std::span<const SlotGrowth>
			growth = {}; // For fields with a map or species, ascending by slot: every fresh slot, and those below which the map changed.
	std::span<const GrassStep> species = {}; // For fields with species: `step` for each of them.
	std::span<const GrassForce> forces = {}; // The bits of GrassSlot.list.w from GRASS_SLOT_FORCES on select those that move a tile.
	std::span<const GrassSlot> followers = {}; // After the step, blades of these tiles follow the simulated ones: records for join().
	std::span<const uint8_t> sharp = {}; // For each collider: not 0 if a segment of a blade may lie across it, see is_sharp().
};

// Returns whether the blades of the record take the step by their strains. Those that a map has cut or let grow are scaled first, as
// chains.
inline bool takes_strains(const GrassSlot &p_slot, const StepInput &p_input) {
	constexpr uint32_t OTHERS = GRASS_SLOT_FRESH | GRASS_SLOT_RETIRED;
	return (p_slot.list.w & (GRASS_SLOT_ALONE | OTHERS)) == GRASS_SLOT_ALONE && p_slot.list.z == 0 &&
			int(p_input.step.contact.w) == GRASS_METHOD_DIRECT &&
			!std::ranges::binary_search(p_input.growth, p_slot.tile.w, {}, &SlotGrowth::slot);
}

// How a tile fares when the pool is resized.
struct SlotMove {
	int tile; // index
	int from, to; // slots; to GRASS_NO_SLOT: it is at rest from now on
};

// The remaining motion of each slot's blades after a step, as the backend reports it, perhaps late: energies are measured when the next
// step begins, bends when it ends.
struct EnergyReport {
	uint64_t step = 0; // StepInput::number of that step; 0: nothing is reported yet
	std::span<const float> energies; // [Eq 19] of each slot's liveliest blade, J/kg
	std::span<const Eigen::Vector3f> bends = {}; // [Eq M5] of each slot: mean distance of its tips from rest, as a share of blade length
};

} // namespace grass
