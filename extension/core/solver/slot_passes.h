// SPDX-License-Identifier: MIT
// Which pass of the GPU simulates which slot (docs/decisions/0019-dispatches-without-barriers.md).
#pragma once

#include "core/solver/step.h"

#include <span>

namespace grass {

// Slots that a pass of their own simulates.
struct SlotPasses {
	int edges = 0, free = 0, crowds = 0;
};

// Sets the bits of the live ones among r_slots, a copy of p_input.slots: GRASS_SLOT_EDGES where a collider is sharp, GRASS_SLOT_FREE where
// none is, GRASS_SLOT_CROWD where there are many. Brings to the front, behind the retired ones, what takes longest: tiles with a fast
// collider. Returns how many are simulated by the pass of each bit.
SlotPasses choose_passes(const StepInput &p_input, std::span<GrassSlot> r_slots);

} // namespace grass
