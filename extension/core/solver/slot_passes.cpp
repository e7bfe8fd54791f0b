// SPDX-License-Identifier: MIT
#include "core/solver/slot_passes.h"

#include <algorithm>
#include <vector>

namespace grass {

namespace {
// Metres a second: blades near what is faster take several parts of a step [Eq 43], one after the other.
constexpr float FAST = 2.0f;

// Of each collider: whether its centre goes far in the step.
std::vector<uint8_t> find_fast(const StepInput &p_input) {
	std::vector<uint8_t> fast(p_input.colliders.size());
	const float most = FAST * p_input.step.chain.x;
	std::ranges::transform(p_input.colliders, fast.begin(), [&](const GrassCollider &p_collider) {
		const vec4 &now = p_collider.position, &before = p_collider.position_before;
		const float x = now.x - before.x, y = now.y - before.y, z = now.z - before.z;
		return uint8_t(x * x + y * y + z * z > most * most);
	});
	return fast;
}
} // namespace

SlotPasses choose_passes(const StepInput &p_input, std::span<GrassSlot> r_slots) {
	const auto colliders_of = [&](const GrassSlot &p_slot) { return p_input.collider_list.subspan(p_slot.list.y, p_slot.list.z); };
	const auto has_any = [&](const GrassSlot &p_slot, std::span<const uint8_t> p_of_colliders) {
		return std::ranges::any_of(colliders_of(p_slot), [&](uint32_t p_collider) { return p_of_colliders[p_collider] != 0; });
	};
	SlotPasses passes;
	for (GrassSlot &slot : r_slots) {
		if (slot.list.w & GRASS_SLOT_RETIRED) {
			continue;
		}
		const bool is_crowd = slot.list.z > GRASS_SHARED_COLLIDERS, is_sharp = has_any(slot, p_input.sharp);
		slot.list.w |= (is_crowd ? GRASS_SLOT_CROWD : 0) | (is_sharp ? GRASS_SLOT_EDGES : 0) | (slot.list.z == 0 ? GRASS_SLOT_FREE : 0);
		passes.crowds += is_crowd;
		passes.edges += is_sharp && !is_crowd;
		passes.free += slot.list.z == 0;
	}
	const std::vector<uint8_t> fast = find_fast(p_input);
	const auto comes_first = [&](const GrassSlot &p_slot) { return (p_slot.list.w & GRASS_SLOT_RETIRED) != 0 || has_any(p_slot, fast); };
	std::stable_partition(r_slots.begin(), r_slots.end(), comes_first);
	return passes;
}

} // namespace grass
