// SPDX-License-Identifier: MIT
// What the tests of TileManager have in common: managers, colliders, steps.
#pragma once

#include "core/tiles/tiles.h"

#include <doctest/doctest.h>

#include <set>
#include <vector>

namespace grass::test {

constexpr double QUARTER = 0.25; // seconds; sums of it are exact

// Returns blades that do not lean out of their tile, put to sleep by the timer.
inline TileManager make_manager(int p_pool_size, const TileGrid &p_grid) {
	TileManager manager;
	manager.set_grid(p_grid);
	TileParams params;
	params.pool_size = p_pool_size;
	params.sleep_mode = SleepMode::TIMER;
	params.overhang = 0.0;
	manager.set_params(params);
	return manager;
}

// Returns a field of 40 x 40 tiles of 0.5 m.
inline TileManager make_manager(int p_pool_size = 64) {
	return make_manager(p_pool_size, TileGrid::make(20.0, 20.0, 256.0));
}

// Returns a ball well inside of one tile, resting.
inline ColliderShape make_ball(const TileManager &p_manager, int p_x, int p_z = 0) {
	ColliderShape ball;
	ball.size.x() = 0.1;
	ball.now.position = ball.before.position = p_manager.get_grid().get_centre(p_x, p_z);
	return ball;
}

inline int step(TileManager &r_manager, std::vector<ColliderShape> p_colliders, double p_delta = QUARTER) {
	r_manager.update(p_delta, p_colliders);
	return int(r_manager.get_slots().size());
}

// Slot by slot, measured after the last step unless told otherwise.
inline void report(TileManager &r_manager, const std::vector<float> &p_energies, uint64_t p_step) {
	r_manager.report_energy({ p_step, p_energies });
}
inline void report(TileManager &r_manager, const std::vector<float> &p_energies) {
	report(r_manager, p_energies, r_manager.get_step_number());
}

// Whatever describes its blades.
inline uint32_t flags_of(const GrassSlot &p_record) {
	return p_record.list.w & ~uint32_t(GRASS_SLOT_ALONE);
}

// No slot and no tile twice among the live; every list within the entries; both ways tile <-> slot agree.
inline void check_consistent(const TileManager &p_manager) {
	std::set<int> slots, tiles;
	uint32_t end = 0;
	for (const GrassSlot &record : p_manager.get_slots()) {
		if (record.list.w & GRASS_SLOT_RETIRED) {
			REQUIRE(p_manager.get_slot_of(record.tile.z) == GRASS_NO_SLOT);
			REQUIRE(slots.empty()); // retired first
			continue;
		}
		REQUIRE(slots.insert(record.tile.w).second);
		REQUIRE(tiles.insert(record.tile.z).second);
		REQUIRE(p_manager.get_slot_of(record.tile.z) == record.tile.w);
		REQUIRE(p_manager.get_tile_of(record.tile.w) == record.tile.z);
		REQUIRE(record.list.y == end);
		end += record.list.z;
	}
	REQUIRE(end == p_manager.get_collider_list().size());
	REQUIRE(int(end) <= p_manager.get_list_capacity());
	for (const uint32_t collider : p_manager.get_collider_list()) {
		REQUIRE(collider < p_manager.get_colliders().size());
	}
	const TileStatistics &statistics = p_manager.get_statistics();
	REQUIRE(int(slots.size()) == statistics.awake);
	REQUIRE(statistics.woken == statistics.slept + statistics.evicted + slots.size());
}

} // namespace grass::test
