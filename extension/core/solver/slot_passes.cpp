// SPDX-License-Identifier: MIT
#include "core/solver/slot_passes.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <vector>

namespace grass {

namespace {
// Metres per second. Blades near a faster collider divide a step into several parts [Eq 43], one after the other.
constexpr float FAST = 2.0f;

// Returns for each collider whether its centre moves far in the step.
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

// A GPU simulates up to this many tiles at once. These are not sorted by energy, since moved records must be uploaded again.
constexpr size_t AT_ONCE = 128;
// The order of a pass's slots: ranks of equal work, within which slots keep their order.
constexpr int FAST_RANK = 0, LIVELIEST_RANK = 1;
// Two ranks for each power of 2 of energy, from 64 J/kg (11 m/s) down to 1e-5 (5 mm/s): the number of parts of a step follows from a
// blade's speed.
constexpr int HALF_OCTAVES = 46, RANKS = LIVELIEST_RANK + HALF_OCTAVES;
constexpr float MOST_ENERGY = 64.0f;
// The threads for each tile of a workgroup: all blades of a tile, or half as many each time, down to GRASS_DETAIL_BLADES.
constexpr auto LANES = [] {
	std::array<uint32_t, std::bit_width(uint32_t(GRASS_GROUP_TILES))> lanes{ GRASS_BLADES_PER_TILE };
	for (size_t i = 1; i < lanes.size(); i++) {
		lanes[i] = lanes[i - 1] / 2;
	}
	return lanes;
}();
static_assert(LANES.back() == GRASS_DETAIL_BLADES);
constexpr size_t KINDS = SLOT_PASSES * LANES.size(); // of workgroups

int half_octave_of(float p_energy) {
	return int((std::bit_cast<uint32_t>(p_energy) & 0x7fffffffu) >> 22);
}

int energy_rank(float p_energy) {
	return LIVELIEST_RANK + std::clamp(half_octave_of(MOST_ENERGY) - half_octave_of(p_energy), 0, HALF_OCTAVES - 1);
}

uint32_t count_blades(const GrassSlot &p_slot) {
	return p_slot.list.w & GRASS_SLOT_RETIRED ? 0u : uint32_t(GRASS_BLADES_PER_TILE) - uint32_t(p_slot.blend.y);
}

// Finds for each slot the kind of its workgroup and its rank.
class SlotOrder {
public:
	SlotOrder(const StepInput &p_input, std::span<const float> p_energies, const GroupLimits &p_limits) :
			_input(p_input),
			_limits(p_limits),
			_fast(find_fast(p_input)),
			_energies(p_input.slots.size() > AT_ONCE ? p_energies : std::span<const float>()) {}

	size_t find_kind(const GrassSlot &p_slot) const {
		const SlotPass pass = find_pass(p_slot);
		size_t lanes = 0;
		const bool may_share = pass == SlotPass::STRAINS || (_limits.may_share && pass != SlotPass::CROWD);
		while (may_share && lanes + 1 < LANES.size() && count_blades(p_slot) <= LANES[lanes + 1]) {
			lanes++;
		}
		return size_t(pass) * LANES.size() + lanes;
	}
	size_t find_rank(const GrassSlot &p_slot) const {
		const size_t number = size_t(p_slot.tile.w);
		return size_t(has_any(p_slot, _fast) ? FAST_RANK : energy_rank(number < _energies.size() ? _energies[number] : 0.0f));
	}

private:
	bool has_any(const GrassSlot &p_slot, std::span<const uint8_t> p_of_colliders) const {
		const std::span<const uint32_t> colliders = _input.collider_list.subspan(p_slot.list.y, p_slot.list.z);
		return std::ranges::any_of(colliders, [&](uint32_t p_collider) { return p_of_colliders[p_collider] != 0; });
	}
	SlotPass find_pass(const GrassSlot &p_slot) const {
		if (p_slot.list.w & GRASS_SLOT_RETIRED) {
			return SlotPass::PLAIN;
		}
		if (p_slot.list.z == 0) {
			return _limits.has_strains && takes_strains(p_slot, _input) ? SlotPass::STRAINS : SlotPass::FREE;
		}
		return p_slot.list.z > GRASS_SHARED_COLLIDERS ? SlotPass::CROWD : has_any(p_slot, _input.sharp) ? SlotPass::EDGES : SlotPass::PLAIN;
	}
	const StepInput &_input;
	GroupLimits _limits;
	std::vector<uint8_t> _fast;
	std::span<const float> _energies;
};

// Divides the slots of one kind among workgroups, whose colliders are shared. p_first: number of the first slot; r_group: of the next
// workgroup.
SlotGroups make_groups(
		std::span<GrassSlot> r_slots, uint32_t p_first, uint32_t p_count, uint32_t p_lanes, uint32_t p_room, uint32_t &r_group) {
	SlotGroups groups{ .first = r_group };
	uint32_t colliders = 0;
	uvec4 *group = nullptr;
	for (uint32_t i = p_first; i < p_first + p_count; i++) {
		GrassSlot &slot = r_slots[i];
		const bool has_room =
				group != nullptr && group->z < GRASS_BLADES_PER_TILE / p_lanes && colliders + slot.list.z <= GRASS_SHARED_COLLIDERS;
		if (!has_room) {
			group = &r_slots[r_group].group;
			*group = { i, p_lanes, 0, p_room > 0 ? r_group % p_room : 0 };
			r_group++;
			groups.count++;
			colliders = 0;
		}
		group->z++;
		slot.blend.w = float(colliders);
		colliders += slot.list.z;
		groups.tiles += slot.list.w & GRASS_SLOT_RETIRED ? 0 : 1;
		groups.blades += count_blades(slot);
	}
	return groups;
}

void add(SlotGroups &r_groups, const SlotGroups &p_more) {
	r_groups.first = r_groups.count == 0 ? p_more.first : r_groups.first;
	r_groups.count += p_more.count;
	r_groups.tiles += p_more.tiles;
	r_groups.blades += p_more.blades;
}
} // namespace

SlotPasses choose_passes(const StepInput &p_input, std::span<const float> p_energies, GroupLimits p_limits, std::span<GrassSlot> r_slots) {
	const SlotOrder order(p_input, p_energies, p_limits);
	std::vector<uint16_t> keys(p_input.slots.size());
	std::vector<uint32_t> places(KINDS * RANKS + 1); // of the first slot of each kind and rank
	std::array<uint32_t, KINDS> counts{};
	for (size_t i = 0; i < keys.size(); i++) {
		const size_t kind = order.find_kind(p_input.slots[i]);
		keys[i] = uint16_t(kind * RANKS + order.find_rank(p_input.slots[i]));
		places[size_t(keys[i]) + 1]++;
		counts[kind]++;
	}
	std::partial_sum(places.begin(), places.end(), places.begin());
	for (size_t i = 0; i < keys.size(); i++) {
		r_slots[places[keys[i]]++] = p_input.slots[i];
	}
	SlotPasses passes;
	uint32_t first = 0, group = 0;
	for (size_t kind = 0; kind < KINDS; kind++) {
		const uint32_t lanes = LANES[kind % LANES.size()];
		const size_t number = kind / LANES.size();
		PassGroups &pass = passes[number];
		const bool is_single = lanes == LANES.front() && number != size_t(SlotPass::STRAINS);
		add(is_single ? pass.single : pass.many, make_groups(r_slots, first, counts[kind], lanes, p_limits.room, group));
		first += counts[kind];
	}
	return passes;
}

} // namespace grass
