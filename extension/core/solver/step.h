// SPDX-License-Identifier: MIT
// The input of one simulation step, the same for the GPU and the CPU backend.
#pragma once

#include "core/base/layout.h"

#include <Eigen/Core>

#include <array>
#include <span>

namespace grass {

// How the blades of an awake tile grow, if a map or a mix of species determines it. Made when the tile wakes, and when the map changes
// below it.
struct SlotGrowth {
	int slot = GRASS_NO_SLOT;
	std::array<vec4, GRASS_BLADES_PER_TILE> blades; // factor on the length; lean x, z; ground under the root, metres
	std::array<uint8_t, GRASS_BLADES_PER_TILE> species{}; // which blades of the patch they are
};

// Views only: TileManager owns the arrays, which are valid until its next update().
struct StepInput {
	std::span<const GrassSlot> slots; // Retired tiles first, then live ones by rising slot.
	std::span<const GrassCollider> colliders; // Field space, each relative to its anchor tile.
	std::span<const uint32_t> collider_list; // Indices into colliders; GrassSlot.list.y and .z cut it by tile.
	std::span<const Eigen::Vector4f> planes; // Hull planes in the collider's own space: n.xyz, d; n.x <= d inside; metres.
	GrassStep step; // The solver's parameters for this step.
	uint64_t number = 0; // Of this step: the first is 1, later ones are greater.
	std::span<const SlotGrowth> growth = {}; // Of fields with a map or species: every fresh slot, and those below which it changed.
	std::span<const GrassStep> species = {}; // Of fields with species: `step` as each of them takes it.
	std::span<const GrassForce> forces = {}; // Bits of GrassSlot.list.w, from GRASS_SLOT_FORCES on, say which of them move a tile.
	std::span<const uint8_t> sharp = {}; // Of the colliders: not 0 where a segment of a blade may lie across one, see is_sharp().
};

// The remaining motion of each slot's blades after a step, as the backend reports it, perhaps late: energies are measured when the next
// step begins, bends when it ends.
struct EnergyReport {
	uint64_t step = 0; // StepInput::number of that step; 0: nothing is known yet
	std::span<const float> energies; // [Eq 19] of each slot's liveliest blade, J/kg
	std::span<const Eigen::Vector3f> bends = {}; // [Eq M5] of each slot: how far its tips are from rest, shares of their blades
};

} // namespace grass
