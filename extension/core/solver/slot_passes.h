// SPDX-License-Identifier: MIT
// Determines which pass of the GPU simulates which slot (docs/decisions/0019-dispatches-without-barriers.md).
#pragma once

#include "core/solver/step.h"

#include <span>

namespace grass {

// The number of slots that each separate pass simulates.
struct SlotPasses {
	int edges = 0, free = 0, crowds = 0;
};

// Copies p_input.slots to r_slots, which has room for as many, and sets the bits of the live ones: GRASS_SLOT_EDGES where a collider is
// sharp, GRASS_SLOT_FREE where there is no collider, GRASS_SLOT_CROWD where there are many. After the retired slots, those that take
// longest come first: tiles with a fast collider, then, if there are more tiles than a GPU simulates at once, those with the liveliest
// blades (docs/decisions/0047-lively-tiles-first.md). p_energies: J/kg, by slot, as last reported; slots beyond its end have no known
// energy and come last. Returns how many slots the pass of each bit simulates.
SlotPasses choose_passes(const StepInput &p_input, std::span<const float> p_energies, std::span<GrassSlot> r_slots);

} // namespace grass
