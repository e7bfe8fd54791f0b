// SPDX-License-Identifier: MIT
// How tiles go to sleep by the timer: section 5.2 of Fan et al. 2015. By energy: test_tiles_energy.cpp.
#include "tile_scene.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace grass;
using namespace grass::test;

TEST_CASE("tiles: 5.2: a tile sleeps once the delay since the last touch has passed, settles, retires, is free") {
	TileManager manager = make_manager();
	const int tile = manager.get_grid().get_index(3, 5);
	step(manager, { make_ball(manager, 3, 5) });
	for (int i = 1; i <= 7; i++) { // 0.25 to 1.75 s after the touch
		REQUIRE(step(manager, {}) == 1);
		CHECK(flags_of(manager.get_slots()[0]) == 0);
		CHECK(manager.is_awake(tile));
		CHECK_FALSE(manager.is_settling(tile));
	}
	REQUIRE(step(manager, {}) == 1); // 2 s: half a second of settling begins, two steps
	CHECK(flags_of(manager.get_slots()[0]) == GRASS_SLOT_SETTLING);
	CHECK(manager.get_slots()[0].blend.x == 0.5f);
	CHECK(manager.is_awake(tile));
	CHECK(manager.is_settling(tile));
	CHECK(manager.get_slot_of(tile) == 0);
	CHECK(manager.get_statistics().awake == 1);
	CHECK(manager.get_statistics().settling == 1);
	REQUIRE(step(manager, {}) == 1);
	CHECK(flags_of(manager.get_slots()[0]) == GRASS_SLOT_SETTLING);
	CHECK(manager.get_slots()[0].blend.x == 1.0f);
	REQUIRE(step(manager, {}) == 1);
	CHECK(flags_of(manager.get_slots()[0]) == GRASS_SLOT_RETIRED);
	CHECK(manager.get_slots()[0].tile == ivec4{ 3, 5, tile, 0 });
	CHECK(manager.get_slots()[0].list.z == 0);
	CHECK_FALSE(manager.is_awake(tile));
	CHECK(manager.get_slot_of(tile) == GRASS_NO_SLOT);
	CHECK(manager.get_tile_of(0) == TileMap::NONE);
	CHECK(manager.get_statistics().slept == 1);
	CHECK(manager.get_statistics().evicted == 0);
	CHECK(manager.get_statistics().tile_steps == 10);
	CHECK(step(manager, {}) == 0);
	REQUIRE(step(manager, { make_ball(manager, 8, 8) }) == 1);
	CHECK(manager.get_slots()[0].tile.w == 0);
}

TEST_CASE("tiles: 5.2: the timestamp is refreshed while a collider is in the tile") {
	TileManager manager = make_manager();
	for (int i = 0; i < 100; i++) {
		REQUIRE(step(manager, { make_ball(manager, 3, 5) }) == 1);
		REQUIRE(flags_of(manager.get_slots()[0]) == (i == 0 ? GRASS_SLOT_FRESH : 0));
	}
	for (int i = 0; i < 7; i++) {
		step(manager, {});
	}
	CHECK(manager.get_statistics().settling == 0);
	step(manager, {});
	CHECK(manager.get_statistics().settling == 1);
}

TEST_CASE("tiles: settling at any tick takes its time, goes at even pace and arrives exactly") {
	for (const double hertz : { 30.0, 60.0, 144.0, 7.3 }) {
		TileManager manager = make_manager();
		step(manager, { make_ball(manager, 3, 5) }, 1.0 / hertz);
		double left = 1.0, seconds = 0.0;
		int arrivals = 0, settling_steps = 0;
		while (step(manager, {}, 1.0 / hertz) == 1 && flags_of(manager.get_slots()[0]) != GRASS_SLOT_RETIRED) {
			const float blend = manager.get_slots()[0].blend.x;
			if (flags_of(manager.get_slots()[0]) == GRASS_SLOT_SETTLING) {
				settling_steps++;
				const double before = left;
				left *= 1.0 - double(blend);
				CHECK(before - left <= 1.01 / (0.5 * hertz));
				arrivals += blend == 1.0f ? 1 : 0;
			} else {
				seconds += 1.0 / hertz;
			}
		}
		CHECK(left == 0.0);
		CHECK(arrivals == 1);
		CHECK(settling_steps == int(std::ceil(0.5 * hertz - 1e-3)));
		CHECK(std::abs(seconds - 2.0) <= 1.001 / hertz);
	}
}

TEST_CASE("tiles: a tile touched while it settles is awake again, in its slot, not fresh") {
	for (int settled = 1; settled <= 2; settled++) { // halfway, and arrived but not yet retired
		TileManager manager = make_manager();
		step(manager, { make_ball(manager, 3, 5) });
		for (int i = 0; i < 7 + settled; i++) {
			step(manager, {});
		}
		REQUIRE(manager.get_statistics().settling == 1);
		REQUIRE(step(manager, { make_ball(manager, 3, 5) }) == 1);
		CHECK(flags_of(manager.get_slots()[0]) == 0);
		CHECK(manager.get_slots()[0].blend.x == 0.0f);
		CHECK(manager.get_statistics().settling == 0);
		CHECK(manager.get_statistics().woken == 1);
		for (int i = 0; i < 7; i++) {
			step(manager, {});
		}
		CHECK(manager.get_statistics().settling == 0);
		step(manager, {});
		CHECK(manager.get_slots()[0].blend.x == 0.5f); // from the start
	}
}

TEST_CASE("tiles: a step without time, or of nonsense, neither ages nor harms a tile") {
	const double infinite = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
	TileManager manager = make_manager();
	step(manager, { make_ball(manager, 3, 5) });
	for (const double delta : { 0.0, -1.0, nan, infinite, -infinite }) {
		for (int i = 0; i < 20; i++) {
			REQUIRE(step(manager, {}, delta) == 1);
			REQUIRE(flags_of(manager.get_slots()[0]) == 0);
		}
	}
	for (int i = 0; i < 8; i++) {
		step(manager, {});
	}
	REQUIRE(manager.get_statistics().settling == 1);
	step(manager, {}, 0.0);
	CHECK(manager.get_slots()[0].blend.x == 0.0f);
	step(manager, {}, 1000.0);
	CHECK(manager.get_slots()[0].blend.x == 1.0f);
	step(manager, {}, 0.0);
	CHECK(flags_of(manager.get_slots()[0]) == GRASS_SLOT_RETIRED);
}

TEST_CASE("tiles: no delay and no settling time: away with the collider") {
	TileManager manager = make_manager();
	TileParams params = manager.get_params();
	params.sleep_delay = params.settle_time = 0.0;
	manager.set_params(params);
	step(manager, { make_ball(manager, 3, 5) });
	step(manager, {});
	CHECK(manager.get_slots()[0].blend.x == 1.0f);
	step(manager, {});
	CHECK(flags_of(manager.get_slots()[0]) == GRASS_SLOT_RETIRED);
}
