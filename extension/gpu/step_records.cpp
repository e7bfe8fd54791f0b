// SPDX-License-Identifier: MIT
#include "gpu/step_records.h"

#include "core/base/cpu_clock.h"
#include "core/field/device_fit.h"
#include "gpu/obstacles.h"

#include <algorithm>

namespace grass {

namespace {

// Returns whether the tile can share a workgroup.
bool is_thinned(const GrassSlot &p_slot) {
	return 2 * int(p_slot.blend.y) >= GRASS_BLADES_PER_TILE;
}

} // namespace

StepRecords::StepRecords(const StepInput &p_input, std::span<const float> p_energies, const PassKind &p_kind) :
		number(p_input.number), step(p_input.step) {
	CpuClock clock;
	slots.resize(p_input.slots.size());
	const bool may_share = std::ranges::any_of(p_input.slots, is_thinned) && can_share(p_kind);
	const bool wants_strains = std::ranges::any_of(p_input.slots, [&](const GrassSlot &p_slot) { return takes_strains(p_slot, p_input); });
	const bool may_use_strains = wants_strains && has_strains(p_kind);
	passes = choose_passes(p_input, p_energies, { uint32_t(count_working_tiles(device_limits())), may_share, may_use_strains }, slots);
	colliders.assign(p_input.colliders.begin(), p_input.colliders.end());
	collider_list.assign(p_input.collider_list.begin(), p_input.collider_list.end());
	planes.assign(p_input.planes.begin(), p_input.planes.end());
	growth.assign(p_input.growth.begin(), p_input.growth.end());
	forces.assign(p_input.forces.begin(), p_input.forces.end());
	species.assign(p_input.species.begin(), p_input.species.end());
	followers.assign(p_input.followers.begin(), p_input.followers.end());
	copy_ms = clock.lap();
}

uint32_t StepRecords::count_groups() const {
	uint32_t count = 0;
	for (const PassGroups &pass : passes) {
		count += pass.single.count + pass.many.count;
	}
	return count;
}

int64_t StepRecords::count_blades() const {
	int64_t count = 0;
	for (const GrassSlot &slot : slots) {
		count += slot.list.w & GRASS_SLOT_RETIRED ? 0 : GRASS_BLADES_PER_TILE - int64_t(slot.blend.y);
	}
	return count;
}

} // namespace grass
