// SPDX-License-Identifier: MIT
// TileManager where its pool and its bounds end.
#include "tile_scene.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace grass;
using namespace grass::test;

namespace {

// Returns a flat box over the whole field and more.
ColliderShape make_lid(double p_half_size) {
	ColliderShape lid;
	lid.type = GRASS_BOX;
	lid.size = { p_half_size, 0.1, p_half_size };
	return lid;
}

} // namespace

TEST_CASE("tiles: in a full pool the tile touched longest ago gives its slot, both are announced") {
	TileManager manager = make_manager(3);
	step(manager, { make_ball(manager, 4) });
	step(manager, { make_ball(manager, 2) });
	step(manager, { make_ball(manager, 6) });
	step(manager, { make_ball(manager, 8) });
	check_consistent(manager);
	CHECK_FALSE(manager.is_awake(4));
	CHECK(manager.get_slot_of(8) == 0);
	CHECK(manager.get_statistics().evicted == 1);
	CHECK(manager.get_statistics().refused == 0);
	REQUIRE(manager.get_slots().size() == 4);
	CHECK(manager.get_slots()[0].tile.z == 4);
	CHECK(manager.get_slots()[0].list.w == GRASS_SLOT_RETIRED);
	CHECK(manager.get_slots()[1].tile.z == 8);
	CHECK(manager.get_slots()[1].list.w == GRASS_SLOT_FRESH);
	step(manager, { make_ball(manager, 10), make_ball(manager, 12) });
	check_consistent(manager);
	CHECK_FALSE(manager.is_awake(2));
	CHECK_FALSE(manager.is_awake(6));
	CHECK(manager.is_awake(8));
}

TEST_CASE("tiles: where energies are known the calmest gives its slot, a settling one before all") {
	TileManager manager = make_manager(3);
	step(manager, { make_ball(manager, 2), make_ball(manager, 4), make_ball(manager, 6) });
	report(manager, { 3.0f, 1.0f, 2.0f });
	step(manager, { make_ball(manager, 8) });
	CHECK_FALSE(manager.is_awake(4));
	step(manager, { make_ball(manager, 10) }); // 8 is not known yet, so thought lively
	CHECK_FALSE(manager.is_awake(6));
	for (int i = 0; i < 6; i++) {
		step(manager, { make_ball(manager, 8), make_ball(manager, 10) });
	}
	REQUIRE(manager.get_statistics().settling == 1); // 2
	REQUIRE(manager.get_slot_of(2) == 0);
	REQUIRE(manager.get_slot_of(8) == 1);
	report(manager, { 100.0f, 0.0f });
	step(manager, { make_ball(manager, 12), make_ball(manager, 10) });
	CHECK_FALSE(manager.is_awake(2));
	CHECK(manager.is_awake(8));
}

TEST_CASE("tiles: late and bad energies change nothing") {
	const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
	TileManager manager = make_manager(2);
	step(manager, { make_ball(manager, 2) });
	step(manager, { make_ball(manager, 4) });
	report(manager, { 5.0f, 0.0f }, 1); // the second slot was free then, or another tile's
	report(manager, { 5.0f, nan, 0.0f, 0.0f });
	report(manager, { 5.0f, -infinite });
	report(manager, {});
	step(manager, { make_ball(manager, 6) });
	CHECK_FALSE(manager.is_awake(2));
	CHECK(manager.is_awake(4));
}

TEST_CASE("tiles: a tile under a collider never gives its slot: the wish is refused, until one is free") {
	TileManager manager = make_manager(2);
	const std::vector<ColliderShape> balls = { make_ball(manager, 2), make_ball(manager, 4), make_ball(manager, 6) };
	for (int i = 1; i <= 20; i++) {
		step(manager, balls);
		check_consistent(manager);
		CHECK(manager.is_awake(2));
		CHECK(manager.is_awake(4));
		CHECK(manager.get_statistics().refused == uint64_t(i));
		CHECK(manager.get_statistics().evicted == 0);
		CHECK(manager.get_colliders().size() == 2);
	}
	step(manager, { balls[1], balls[2] });
	CHECK(manager.is_awake(6));
	CHECK_FALSE(manager.is_awake(2));
	CHECK(manager.get_statistics().evicted == 1);
}

TEST_CASE("tiles: a crowd beyond the pool costs a look or two a body, and all of them meet grass") {
	TileManager manager = make_manager(16);
	std::vector<ColliderShape> crowd;
	for (int z = 2; z < 40; z += 4) {
		for (int x = 2; x < 40; x += 4) {
			crowd.push_back(make_ball(manager, x, z));
			crowd.back().size.x() = 0.9; // nine tiles and more
		}
	}
	step(manager, crowd);
	REQUIRE(manager.get_statistics().awake == 16);
	for (int i = 0; i < 5; i++) {
		const TileStatistics before = manager.get_statistics();
		step(manager, crowd);
		check_consistent(manager);
		CHECK(manager.get_statistics().looked_at - before.looked_at <= 16 + crowd.size());
		CHECK(manager.get_statistics().refused - before.refused >= crowd.size() - 2);
		CHECK(manager.get_statistics().woken == 16);
		for (size_t n = 0; n < crowd.size(); n++) {
			CHECK(manager.has_met_grass(n));
		}
	}
	crowd.erase(crowd.begin()); // its tiles are free for the next ones
	step(manager, crowd);
	check_consistent(manager);
	CHECK(manager.get_statistics().woken > 16);
	CHECK(manager.get_statistics().awake == 16);
}

TEST_CASE("tiles: pool sizes of nothing, one, and far too many") {
	TileManager manager = make_manager(0);
	step(manager, { make_ball(manager, 2) });
	CHECK(manager.get_slots().empty());
	CHECK(manager.get_statistics().capped == 1);
	manager = make_manager(-5);
	CHECK(manager.get_params().pool_size == 0);
	manager = make_manager(1);
	step(manager, { make_ball(manager, 2) });
	step(manager, { make_ball(manager, 3) });
	check_consistent(manager);
	CHECK(manager.get_slot_of(3) == 0);
	manager = make_manager(std::numeric_limits<int>::max());
	CHECK(manager.get_params().pool_size == TileParams::MAX_POOL_SIZE);
	step(manager, { make_ball(manager, 3) });
	CHECK(manager.get_slots().size() == 1);
}

TEST_CASE("tiles: slots that were given back are handed out again, lowest first") {
	TileManager manager = make_manager(150);
	step(manager, { make_lid(50.0) });
	REQUIRE(manager.get_statistics().awake >= 140);
	while (manager.get_statistics().awake > 0) {
		step(manager, {});
	}
	step(manager, { make_ball(manager, 1), make_ball(manager, 2) });
	CHECK(manager.get_slot_of(1) == 0);
	CHECK(manager.get_slot_of(2) == 1);
	manager.reset();
	step(manager, { make_lid(50.0) });
	const int all = manager.get_statistics().awake;
	CHECK(manager.get_tile_of(all - 1) != TileMap::NONE);
	CHECK(manager.get_statistics().evicted == 0);
}

TEST_CASE("tiles: parameters that are no numbers become the defaults") {
	const double nan = std::numeric_limits<double>::quiet_NaN();
	TileParams params;
	params.sleep_delay = params.settle_time = params.overhang = params.height = nan;
	params = params.sanitised();
	CHECK(params.sleep_delay == 2.0);
	CHECK(params.settle_time == 0.5);
	CHECK(params.overhang == TileParams().overhang);
	CHECK(params.height == TileParams().height);
	params.sleep_delay = -1.0;
	CHECK(params.sanitised().sleep_delay == 0.0);
}

TEST_CASE("tiles: a body over millions of tiles gets the pool around its centre, and the rest is counted") {
	TileManager manager = make_manager(100, TileGrid::make(2000.0, 2000.0, 256.0)); // 16,000,000 tiles
	ColliderShape lid = make_lid(3000.0);
	lid.now.position = lid.before.position = manager.get_grid().get_centre(1234, 2345);
	step(manager, { lid });
	check_consistent(manager);
	CHECK(manager.get_statistics().awake == 100);
	CHECK(manager.get_statistics().capped == 16000000 - 100);
	for (const GrassSlot &record : manager.get_slots()) {
		CHECK(std::abs(record.tile.x - 1234) <= 5);
		CHECK(std::abs(record.tile.y - 2345) <= 5);
	}
	step(manager, { lid });
	CHECK(manager.get_statistics().evicted == 0);
	lid.size = { 3000.0, 0.1, 0.1 }; // a long strip: all of the pool along it
	manager.reset();
	step(manager, { lid });
	CHECK(manager.get_statistics().awake == 100);
}

TEST_CASE("tiles: a body that crosses the field aslant in one step wakes each tile on its way") {
	TileManager manager = make_manager(1024, TileGrid::make(50.0, 50.0, 256.0)); // 10,000 tiles
	ColliderShape ball;
	ball.size.x() = 0.3;
	ball.before.position = { -22.0, 0.2, -21.0 };
	ball.now.position = { 21.0, 0.2, 22.0 };
	step(manager, { ball });
	const TileStatistics &now = manager.get_statistics();
	CHECK(now.capped == 0);
	CHECK(now.refused == 0);
	CHECK(now.awake < 1000);
	int on_the_way = 0;
	for (int i = 0; i <= 1000; i++) {
		const Eigen::Vector3d place = ball.before.position + (ball.now.position - ball.before.position) * (0.001 * i);
		const TilePlace tile = manager.get_grid().get_place(place);
		on_the_way += manager.is_awake(manager.get_grid().get_index(tile.x, tile.z));
	}
	CHECK(on_the_way == 1001);
	CHECK(now.list_entries == now.awake); // one entry each, where pieces overlap too
	check_consistent(manager);
	CHECK(manager.has_met_grass(0));
}

TEST_CASE("tiles: many bodies over everything fill the list fairly, up to its bound") {
	TileManager manager = make_manager(256);
	const std::vector<ColliderShape> lids(500, make_lid(50.0));
	step(manager, lids);
	check_consistent(manager);
	CHECK(int(manager.get_collider_list().size()) <= manager.get_list_capacity());
	CHECK(manager.get_colliders().size() == 500);
	CHECK(manager.get_statistics().capped > 0);
	const std::vector<ColliderShape> crowd(10000, make_ball(manager, 3));
	manager.reset();
	step(manager, crowd);
	check_consistent(manager);
	CHECK(int(manager.get_collider_list().size()) == manager.get_list_capacity());
}

TEST_CASE("tiles: ten million tiles take no memory of their own") {
	const TileManager small = make_manager(4096, TileGrid::make(0.5, 0.5, 256.0));
	TileManager large = make_manager(4096, TileGrid::make(1600.0, 1600.0, 256.0));
	CHECK(large.get_grid().get_tile_count() == 10240000);
	CHECK(large.get_memory_usage() == small.get_memory_usage());
	ColliderShape ball = make_ball(large, 3199);
	ball.now.position.z() = ball.before.position.z() = -ball.now.position.z();
	step(large, { ball });
	CHECK(large.get_slots()[0].tile == ivec4{ 3199, 3199, 10239999, 0 });
	CHECK(large.get_memory_usage() < 4 << 20);
}
