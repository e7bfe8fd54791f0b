// SPDX-License-Identifier: MIT
// The order in which lanes take the blades of a tile. Only a few of the blades in a tile with a collider are near it, and their step costs
// many times more. So blades with the same work share lanes, and blades at rest are in none. A blade's result does not depend on its
// neighbours, so no bit of it depends on the order.
#pragma once

#include "core/solver/tile_step.h"

#include <cstdint>
#include <span>

namespace grass {

// The work that a step has with a blade.
inline constexpr uint8_t WORK_NONE = 0; // it is at rest, and nothing can touch it there
inline constexpr uint8_t WORK_FREE = 1; // one solve, or none; beside a collider by as much more as the step has parts, [Eq 43]

struct BladeOrder {
	// By lane: blades of the tile. The last ones repeat a blade, so that every group of lanes is whole.
	uint8_t blades[GRASS_BLADES_PER_TILE + MOST_LANES];
	int count; // without those that repeat one
};

// Orders blades, most work first. p_work: of each simulated blade; p_lanes: how many blades a group has. Blades stay in their places if
// that takes no more groups, since neighbours are read at once.
BladeOrder order_blades(std::span<const uint8_t> p_work, int p_lanes);

} // namespace grass
