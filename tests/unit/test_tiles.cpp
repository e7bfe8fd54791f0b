// SPDX-License-Identifier: MIT
// Which tiles wake: TileManager against Algorithm 1 of Fan et al. 2015. How they sleep: test_tiles_sleep.cpp. The pool's
// limits: test_tiles_pool.cpp.
#include "tile_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>

using namespace grass;
using namespace grass::test;

TEST_CASE("tiles: without colliders there is nothing to do") {
	TileManager manager = make_manager();
	CHECK(step(manager, {}) == 0);
	CHECK(manager.get_colliders().empty());
	CHECK(manager.get_collider_list().empty());
	CHECK(manager.get_memory_usage() > 0);
}

TEST_CASE("tiles: lines 5 to 16: a collider's tiles are activated, each with a slot, fresh once") {
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

TEST_CASE("tiles: a moving collider leaves a trail of awake tiles two seconds long") {
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
			const int tile = manager.get_grid().get_index(x, 20);
			CHECK((manager.is_awake(tile) && !manager.is_settling(tile)) == expected);
		}
	}
	CHECK(manager.get_statistics().evicted == 0);
}

TEST_CASE("tiles: a fast collider wakes every tile on its way, one above the blades none") {
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

TEST_CASE("tiles: blades that lean out of their tile are met: the overhang") {
	TileManager manager = make_manager();
	TileParams params = manager.get_params();
	params.overhang = 0.2; // a ball of 0.1 in the middle of a 0.5 m tile comes to 0.15 m from its neighbours
	manager.set_params(params);
	CHECK(step(manager, { make_ball(manager, 3, 5) }) == 9);
	manager.reset();
	params.overhang = 0.14;
	manager.set_params(params);
	CHECK(step(manager, { make_ball(manager, 3, 5) }) == 1);
}

TEST_CASE("tiles: each tile's list holds exactly the colliders whose boxes meet its own") {
	TileManager manager = make_manager(4096);
	TileParams params = manager.get_params();
	params.overhang = 0.17;
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
			const double half = 0.5 * grid.get_tile_size() + params.overhang;
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

TEST_CASE("tiles: colliders that meet no tile are not uploaded, hulls bring their planes") {
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

TEST_CASE("tiles: a collider with bad numbers is left out and counted, the others stay") {
	TileManager manager = make_manager();
	ColliderShape bad = make_ball(manager, 4, 4);
	bad.now.position.x() = std::numeric_limits<double>::quiet_NaN();
	step(manager, { bad, make_ball(manager, 5, 5) });
	CHECK(manager.get_statistics().bad_colliders == 1);
	CHECK(manager.get_colliders().size() == 1);
	CHECK(manager.is_awake(manager.get_grid().get_index(5, 5)));
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

TEST_CASE("tiles: colliders in use say whether they are sharp beside a segment") {
	TileManager manager = make_manager();
	TileParams params = manager.get_params();
	params.segment = 0.04;
	manager.set_params(params);
	ColliderShape box = make_ball(manager, 3, 5);
	box.type = GRASS_BOX;
	box.size = Eigen::Vector3d::Constant(0.1);
	std::vector<ColliderShape> colliders{ box, make_ball(manager, 3, 5), make_ball(manager, 7, 7) };
	const auto sharp = [&] { return std::vector<uint8_t>(manager.get_sharp().begin(), manager.get_sharp().end()); };
	REQUIRE(step(manager, colliders) == 2);
	CHECK(sharp() == std::vector<uint8_t>{ 1, 0, 0 });
	colliders[0].now.position.y() = colliders[0].before.position.y() = 50.0;
	step(manager, colliders);
	CHECK(sharp() == std::vector<uint8_t>{ 0, 0 });
	params.segment = 0.2; // a ball is as sharp as that is long
	manager.set_params(params);
	step(manager, colliders);
	CHECK(sharp() == std::vector<uint8_t>{ 1, 1 });
}
