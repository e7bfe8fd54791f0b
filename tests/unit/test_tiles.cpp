// SPDX-License-Identifier: MIT
// TileManager against Algorithm 1 and section 5.2 of Fan et al. 2015. The pool's limits: test_tiles_pool.cpp.
#include "core/tiles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <vector>

using namespace grass;

namespace {

constexpr double QUARTER = 0.25; // seconds; sums of it are exact

// A field of 40 x 40 tiles of 0.5 m, blades that do not lean out of their tile.
TileManager make_manager(int p_pool_size = 64) {
	TileManager manager;
	manager.set_grid(TileGrid::make(20.0, 20.0, 256.0));
	TileParams params;
	params.pool_size = p_pool_size;
	params.reach = 0.0;
	manager.set_params(params);
	return manager;
}

// A ball well inside of one tile, resting.
ColliderShape make_ball(const TileManager &p_manager, int p_x, int p_z) {
	ColliderShape ball;
	ball.size.x() = 0.1;
	ball.now.position = ball.before.position = p_manager.get_grid().get_centre(p_x, p_z);
	return ball;
}

int step(TileManager &r_manager, std::vector<ColliderShape> p_colliders, double p_delta = QUARTER) {
	r_manager.update(p_delta, p_colliders);
	return int(r_manager.get_slots().size());
}

uint32_t flags_of(const GrassSlot &p_record) {
	return p_record.list.w;
}

} // namespace

TEST_CASE("tiles: without objects there is nothing to do") {
	TileManager manager = make_manager();
	CHECK(step(manager, {}) == 0);
	CHECK(manager.get_colliders().empty());
	CHECK(manager.get_collider_list().empty());
	CHECK(manager.get_memory_usage() > 0);
}

TEST_CASE("tiles: lines 5 to 16: an object's tiles are activated, each with a slot, fresh once") {
	TileManager manager = make_manager();
	const ColliderShape ball = make_ball(manager, 3, 5);
	REQUIRE(step(manager, { ball }) == 1);
	const int tile = manager.get_grid().get_index(3, 5);
	const GrassSlot record = manager.get_slots()[0];
	CHECK(record.tile == ivec4{ 3, 5, tile, 0 });
	CHECK(record.list == uvec4{ grass_tile_start(3, 5, 0), 0, 1, GRASS_SLOT_FRESH });
	CHECK(record.blend == vec4{});
	CHECK(manager.get_slot_of(tile) == 0);
	CHECK(manager.get_tile_of(0) == tile);
	CHECK(manager.is_awake(tile));
	CHECK_FALSE(manager.is_awake(tile + 1));
	CHECK(manager.get_slot_of(tile + 1) == GRASS_NO_SLOT);
	CHECK(manager.get_statistics().woken == 1);

	REQUIRE(step(manager, { ball }) == 1);
	CHECK(flags_of(manager.get_slots()[0]) == 0);
	CHECK(manager.get_statistics().woken == 1);
	CHECK(manager.get_statistics().awake == 1);
}

TEST_CASE("tiles: line 11: a tile that is active already keeps its slot, a new one gets the lowest free") {
	TileManager manager = make_manager();
	step(manager, { make_ball(manager, 9, 9) });
	REQUIRE(step(manager, { make_ball(manager, 9, 9), make_ball(manager, 1, 1) }) == 2);
	CHECK(manager.get_tile_of(0) == manager.get_grid().get_index(9, 9));
	CHECK(manager.get_tile_of(1) == manager.get_grid().get_index(1, 1));
	CHECK(flags_of(manager.get_slots()[0]) == 0);
	CHECK(flags_of(manager.get_slots()[1]) == GRASS_SLOT_FRESH);
}

TEST_CASE("tiles: 5.2: a tile sleeps once the delay since the last touch has passed, settles, retires, is free") {
	TileManager manager = make_manager();
	const int tile = manager.get_grid().get_index(3, 5);
	step(manager, { make_ball(manager, 3, 5) });
	for (int i = 1; i <= 7; i++) { // 0.25 to 1.75 s after the touch
		REQUIRE(step(manager, {}) == 1);
		CHECK(flags_of(manager.get_slots()[0]) == 0);
		CHECK(manager.is_awake(tile));
	}
	REQUIRE(step(manager, {}) == 1); // 2 s: half a second of settling begins, two steps
	CHECK(flags_of(manager.get_slots()[0]) == GRASS_SLOT_SETTLING);
	CHECK(manager.get_slots()[0].blend.x == 0.5f);
	CHECK_FALSE(manager.is_awake(tile));
	CHECK(manager.get_slot_of(tile) == 0);
	CHECK(manager.get_statistics().settling == 1);
	REQUIRE(step(manager, {}) == 1);
	CHECK(flags_of(manager.get_slots()[0]) == GRASS_SLOT_SETTLING);
	CHECK(manager.get_slots()[0].blend.x == 1.0f);
	REQUIRE(step(manager, {}) == 1);
	CHECK(flags_of(manager.get_slots()[0]) == GRASS_SLOT_RETIRED);
	CHECK(manager.get_slots()[0].tile == ivec4{ 3, 5, tile, 0 });
	CHECK(manager.get_slots()[0].list.z == 0);
	CHECK(manager.get_slot_of(tile) == GRASS_NO_SLOT);
	CHECK(manager.get_tile_of(0) == TileMap::NONE);
	CHECK(manager.get_statistics().slept == 1);
	CHECK(manager.get_statistics().evicted == 0);
	CHECK(step(manager, {}) == 0);
	REQUIRE(step(manager, { make_ball(manager, 8, 8) }) == 1);
	CHECK(manager.get_slots()[0].tile.w == 0);
}

TEST_CASE("tiles: 5.2: the timestamp is refreshed while an object is in the tile") {
	TileManager manager = make_manager();
	for (int i = 0; i < 100; i++) {
		REQUIRE(step(manager, { make_ball(manager, 3, 5) }) == 1);
		REQUIRE(flags_of(manager.get_slots()[0]) == (i == 0 ? GRASS_SLOT_FRESH : 0));
	}
	for (int i = 0; i < 7; i++) {
		step(manager, {});
	}
	CHECK(manager.get_statistics().awake == 1);
	step(manager, {});
	CHECK(manager.get_statistics().awake == 0);
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
		CHECK(manager.get_statistics().awake == 1);
		CHECK(manager.get_statistics().woken == 1);
		for (int i = 0; i < 7; i++) {
			step(manager, {});
		}
		CHECK(manager.get_statistics().awake == 1);
		step(manager, {});
		CHECK(manager.get_slots()[0].blend.x == 0.5f); // from the start
	}
}

TEST_CASE("tiles: a moving object leaves a trail of awake tiles two seconds long") {
	TileManager manager = make_manager(4096);
	const double speed = 2.0; // metres a second: a tile in a quarter of a second
	ColliderShape ball = make_ball(manager, 0, 20);
	for (int i = 1; i <= 36; i++) {
		ball.before = ball.now;
		ball.now.position.x() += speed * QUARTER;
		std::vector<ColliderShape> colliders = { ball };
		manager.update(QUARTER, colliders);
		for (int x = 0; x < 40; x++) {
			// Step i touches tiles i - 1 and i; tile x was touched last in step x + 1.
			const int steps_since = i - (x + 1);
			const bool expected = x <= i && steps_since < 8;
			CHECK(manager.is_awake(manager.get_grid().get_index(x, 20)) == expected);
		}
	}
	CHECK(manager.get_statistics().evicted == 0);
}

TEST_CASE("tiles: a fast object wakes every tile on its way, one above the blades none") {
	TileManager manager = make_manager(4096);
	ColliderShape ball = make_ball(manager, 2, 7);
	ball.now.position = manager.get_grid().get_centre(35, 7);
	CHECK(step(manager, { ball }) == 34);
	ColliderShape above = make_ball(manager, 2, 30);
	above.now.position.y() = above.before.position.y() = 1.2;
	ColliderShape below = make_ball(manager, 2, 31);
	below.now.position.y() = below.before.position.y() = -0.2;
	CHECK(step(manager, { above, below }) == 34);
	above.before.position.y() = 0.9; // was among the blades at the start of the step
	CHECK(step(manager, { above, below }) == 35);
}

TEST_CASE("tiles: blades that lean out of their tile are met: the reach") {
	TileManager manager = make_manager();
	TileParams params = manager.get_params();
	params.reach = 0.2; // a ball of 0.1 in the middle of a 0.5 m tile comes to 0.15 m from its neighbours
	manager.set_params(params);
	CHECK(step(manager, { make_ball(manager, 3, 5) }) == 9);
	manager.reset();
	params.reach = 0.14;
	manager.set_params(params);
	CHECK(step(manager, { make_ball(manager, 3, 5) }) == 1);
}

TEST_CASE("tiles: each tile's list holds exactly the objects whose boxes meet its own") {
	TileManager manager = make_manager(4096);
	TileParams params = manager.get_params();
	params.reach = 0.17;
	params.height = 0.8;
	manager.set_params(params);
	const TileGrid &grid = manager.get_grid();
	std::mt19937 random(11);
	std::uniform_real_distribution<double> place(-11.0, 11.0), height(-0.6, 1.6), size(0.05, 0.6), move(-0.3, 0.3);
	int differing = 0, entries = 0;
	for (int round = 0; round < 20; round++) {
		std::vector<ColliderShape> colliders(60);
		for (ColliderShape &collider : colliders) {
			collider.type = int(random() % 4);
			collider.size = { size(random), size(random), size(random) };
			collider.before.position = { place(random), height(random), place(random) };
			collider.now.position = collider.before.position + Eigen::Vector3d(move(random), move(random), move(random));
			collider.now.rotation = Quaternion(size(random), move(random), move(random), move(random)).normalized();
		}
		manager.update(1.0 / 60.0, colliders);
		std::map<int, std::vector<int>> expected;
		for (int tile = 0; tile < grid.get_tile_count(); tile++) {
			const Eigen::Vector3d centre = grid.get_centre(grid.get_x(tile), grid.get_z(tile));
			const double half = 0.5 * grid.get_tile_size() + params.reach;
			const Eigen::Vector3d low(centre.x() - half, 0.0, centre.z() - half), high(centre.x() + half, params.height, centre.z() + half);
			for (size_t i = 0; i < colliders.size(); i++) {
				const Bounds bounds = colliders[i].get_swept_bounds();
				const bool meets = (bounds.min.array() <= high.array()).all() && (bounds.max.array() >= low.array()).all();
				if (meets) {
					expected[tile].push_back(int(i));
				}
			}
		}
		std::map<int, std::vector<int>> listed;
		for (const GrassSlot &record : manager.get_slots()) {
			for (uint32_t i = 0; i < record.list.z; i++) {
				const GrassCollider &packed = manager.get_colliders()[manager.get_collider_list()[record.list.y + i]];
				const auto is_packed = [&](const ColliderShape &p_collider) {
					return p_collider.pack(grid, 0).position == packed.position;
				};
				listed[record.tile.z].push_back(int(std::find_if(colliders.begin(), colliders.end(), is_packed) - colliders.begin()));
				entries++;
			}
		}
		differing += listed == expected ? 0 : 1;
	}
	CHECK(differing == 0);
	CHECK(entries > 5000);
}

TEST_CASE("tiles: objects that meet no tile are not uploaded, hulls bring their planes") {
	TileManager manager = make_manager();
	ColliderShape hull = make_ball(manager, 4, 4);
	hull.type = GRASS_HULL;
	hull.size.setConstant(0.1);
	hull.planes.assign(5, { 0.0f, 1.0f, 0.0f, 0.1f });
	ColliderShape other_hull = hull;
	other_hull.planes.assign(7, { 1.0f, 0.0f, 0.0f, 0.1f });
	ColliderShape outside = make_ball(manager, 400, 4);
	step(manager, { outside, hull, make_ball(manager, 4, 4), other_hull });
	REQUIRE(manager.get_colliders().size() == 3);
	CHECK(manager.get_colliders()[0].anchor.w == 0);
	CHECK(manager.get_colliders()[1].anchor.z == GRASS_SPHERE);
	CHECK(manager.get_colliders()[2].anchor.w == 5);
	CHECK(manager.get_colliders()[2].position_before.w == 7.0f);
	REQUIRE(manager.get_planes().size() == 12);
	CHECK(manager.get_planes()[5].x() == 1.0f);
	CHECK(manager.get_statistics().colliders == 3);
	CHECK(manager.get_statistics().list_entries == 3);
	step(manager, {});
	CHECK(manager.get_planes().empty());
	CHECK(manager.get_colliders().empty());
}

TEST_CASE("tiles: an object with bad numbers is left out and counted, the others stay") {
	TileManager manager = make_manager();
	ColliderShape bad = make_ball(manager, 4, 4);
	bad.now.position.x() = std::numeric_limits<double>::quiet_NaN();
	step(manager, { bad, make_ball(manager, 5, 5) });
	CHECK(manager.get_statistics().bad_colliders == 1);
	CHECK(manager.get_colliders().size() == 1);
	CHECK(manager.is_awake(manager.get_grid().get_index(5, 5)));
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

TEST_CASE("tiles: no delay and no settling time: away with the object") {
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

TEST_CASE("tiles: another grid or seed puts all to rest, other parameters do not") {
	TileManager manager = make_manager();
	step(manager, { make_ball(manager, 3, 5) });
	manager.set_grid(manager.get_grid());
	TileParams params = manager.get_params();
	params.sleep_delay = 3.0;
	manager.set_params(params);
	CHECK(manager.get_tile_of(0) != TileMap::NONE);
	params.seed = 4;
	manager.set_params(params);
	CHECK(manager.get_tile_of(0) == TileMap::NONE);
	CHECK(manager.get_slots().empty());
	step(manager, { make_ball(manager, 3, 5) });
	CHECK(manager.get_slots()[0].list.x == grass_tile_start(3, 5, 4));
	manager.set_grid(TileGrid::make(3.0, 3.0, 256.0));
	CHECK(manager.get_slots().empty());
	CHECK(manager.get_tile_of(0) == TileMap::NONE);
	CHECK(step(manager, {}) == 0);
	step(manager, { make_ball(manager, 1, 1) });
	CHECK(manager.get_slots()[0].tile == ivec4{ 1, 1, 7, 0 });
}
