// SPDX-License-Identifier: MIT
#include "core/solver/slot_passes.h"

#include <algorithm>

namespace grass {

SlotPasses choose_passes(const StepInput &p_input, std::span<GrassSlot> r_slots) {
	SlotPasses passes;
	for (GrassSlot &slot : r_slots) {
		if (slot.list.w & GRASS_SLOT_RETIRED) {
			continue;
		}
		const std::span<const uint32_t> colliders = p_input.collider_list.subspan(slot.list.y, slot.list.z);
		if (colliders.empty()) {
			slot.list.w |= GRASS_SLOT_FREE;
			passes.free++;
		} else if (std::ranges::any_of(colliders, [&](uint32_t p_collider) { return p_input.sharp[p_collider] != 0; })) {
			slot.list.w |= GRASS_SLOT_EDGES;
			passes.edges++;
		}
	}
	return passes;
}

} // namespace grass
