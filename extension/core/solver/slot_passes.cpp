// SPDX-License-Identifier: MIT
#include "core/solver/slot_passes.h"

#include <algorithm>
#include <array>
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
// The order of a step's slots: ranks of equal work, within which slots keep their order.
constexpr int RETIRED_RANK = 0, FAST_RANK = 1, LIVELIEST_RANK = 2;
// Two ranks for each power of 2 of energy, from 64 J/kg (11 m/s) down to 1e-5 (5 mm/s): the number of parts of a step follows from a
// blade's speed.
constexpr int HALF_OCTAVES = 46, RANKS = LIVELIEST_RANK + HALF_OCTAVES;
constexpr float MOST_ENERGY = 64.0f;

int half_octave_of(float p_energy) {
	return int((std::bit_cast<uint32_t>(p_energy) & 0x7fffffffu) >> 22);
}

int rank_of(float p_energy) {
	return LIVELIEST_RANK + std::clamp(half_octave_of(MOST_ENERGY) - half_octave_of(p_energy), 0, HALF_OCTAVES - 1);
}
} // namespace

SlotPasses choose_passes(const StepInput &p_input, std::span<const float> p_energies, std::span<GrassSlot> r_slots) {
	const std::vector<uint8_t> fast = find_fast(p_input);
	const auto has_any = [&](const GrassSlot &p_slot, std::span<const uint8_t> p_of_colliders) {
		const std::span<const uint32_t> colliders = p_input.collider_list.subspan(p_slot.list.y, p_slot.list.z);
		return std::ranges::any_of(colliders, [&](uint32_t p_collider) { return p_of_colliders[p_collider] != 0; });
	};
	const std::span<const float> energies = p_input.slots.size() > AT_ONCE ? p_energies : std::span<const float>();
	const auto find_rank = [&](const GrassSlot &p_slot) {
		if (p_slot.list.w & GRASS_SLOT_RETIRED) {
			return RETIRED_RANK;
		}
		const size_t number = size_t(p_slot.tile.w);
		return has_any(p_slot, fast) ? FAST_RANK : rank_of(number < energies.size() ? energies[number] : 0.0f);
	};
	std::vector<uint8_t> ranks(p_input.slots.size());
	std::array<size_t, RANKS + 1> places{}; // of the first slot of each rank
	for (size_t i = 0; i < ranks.size(); i++) {
		const int rank = find_rank(p_input.slots[i]);
		ranks[i] = uint8_t(rank);
		places[size_t(rank) + 1]++;
	}
	std::partial_sum(places.begin(), places.end(), places.begin());
	SlotPasses passes;
	for (size_t i = 0; i < ranks.size(); i++) {
		GrassSlot &slot = r_slots[places[ranks[i]]++] = p_input.slots[i];
		if (ranks[i] == RETIRED_RANK) {
			continue;
		}
		const bool is_crowd = slot.list.z > GRASS_SHARED_COLLIDERS, is_sharp = has_any(slot, p_input.sharp);
		slot.list.w |= (is_crowd ? GRASS_SLOT_CROWD : 0) | (is_sharp ? GRASS_SLOT_EDGES : 0) | (slot.list.z == 0 ? GRASS_SLOT_FREE : 0);
		passes.crowds += is_crowd;
		passes.edges += is_sharp && !is_crowd;
		passes.free += slot.list.z == 0;
	}
	return passes;
}

} // namespace grass
