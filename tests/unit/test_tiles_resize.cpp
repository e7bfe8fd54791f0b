// SPDX-License-Identifier: MIT
// TileManager while its pool becomes larger or smaller under awake tiles: since scripts say so, or since tiles wake and sleep.
#include "tile_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace grass;
using namespace grass::test;

TEST_CASE("tiles: a pool that grows keeps every tile where it is, and has room at once") {
	TileManager manager = make_manager(2);
	step(manager, { make_ball(manager, 2), make_ball(manager, 4), make_ball(manager, 6) });
	REQUIRE(manager.get_statistics().awake == 2);
	REQUIRE(manager.get_statistics().refused == 1);
	CHECK(manager.resize_pool(100).empty());
	CHECK(manager.get_params().pool_size == 100);
	CHECK(manager.get_slot_of(2) == 0);
	CHECK(manager.get_slot_of(4) == 1);
	step(manager, { make_ball(manager, 2), make_ball(manager, 4), make_ball(manager, 6) });
	check_consistent(manager);
	CHECK(manager.get_statistics().awake == 3);
	CHECK(manager.get_statistics().woken == 3); // the first two did not wake again
}

TEST_CASE("tiles: a pool that shrinks moves the tiles that it still holds, which go on as they were") {
	TileManager manager = make_manager(64);
	step(manager, { make_ball(manager, 2), make_ball(manager, 4), make_ball(manager, 6) });
	for (int i = 0; i < 12; i++) { // 2 and 4 come to rest
		step(manager, { make_ball(manager, 6) });
	}
	REQUIRE(manager.get_statistics().awake == 1);
	REQUIRE(manager.get_slot_of(6) == 2);
	const std::vector<SlotMove> moves = manager.resize_pool(1);
	REQUIRE(moves.size() == 1);
	CHECK(moves[0].tile == 6);
	CHECK(moves[0].from == 2);
	CHECK(moves[0].to == 0);
	CHECK(manager.get_slot_of(6) == 0);
	CHECK(manager.get_tile_of(0) == 6);
	step(manager, { make_ball(manager, 6), make_ball(manager, 8) });
	check_consistent(manager);
	CHECK(manager.get_statistics().woken == 3);
	CHECK(manager.get_statistics().evicted == 0);
	CHECK_FALSE(manager.is_awake(8)); // there is one slot
}

TEST_CASE("tiles: of too many tiles the calmest come to rest, and the others keep what is known of them") {
	TileManager manager = make_manager(4);
	step(manager, { make_ball(manager, 2), make_ball(manager, 4), make_ball(manager, 6), make_ball(manager, 8) });
	report(manager, { 3.0f, 1.0f, 2.0f, 4.0f });
	const std::vector<SlotMove> moves = manager.resize_pool(2);
	REQUIRE(moves.size() == 3);
	CHECK(moves[0].tile == 4);
	CHECK(moves[0].to == GRASS_NO_SLOT);
	CHECK(moves[1].tile == 6);
	CHECK(moves[1].to == GRASS_NO_SLOT);
	CHECK(moves[2].tile == 8);
	CHECK(moves[2].to == 1);
	CHECK(manager.get_statistics().evicted == 2);
	CHECK(manager.get_statistics().awake == 2);
	CHECK_FALSE(manager.is_awake(4));
	step(manager, { make_ball(manager, 10) });
	check_consistent(manager);
	CHECK_FALSE(manager.is_awake(2)); // calmer than 8, also in its new slot
	CHECK(manager.is_awake(8));
}

TEST_CASE("tiles: a report from before tiles changed slots is of other tiles") {
	TileManager manager = make_manager(4);
	step(manager, { make_ball(manager, 2), make_ball(manager, 4), make_ball(manager, 6) });
	const uint64_t before = manager.get_step_number();
	step(manager, {});
	report(manager, { 1.0f, 2.0f, 3.0f });
	REQUIRE(manager.resize_pool(2).size() == 2); // 2 is at rest, 6 is in its slot
	step(manager, {});
	report(manager, { 0.0f, 9.0f, 0.0f }, before); // of 2 and 4
	step(manager, { make_ball(manager, 8) });
	CHECK_FALSE(manager.is_awake(4)); // 2 J/kg, less than the 3 of 6
	CHECK(manager.is_awake(6));
}

TEST_CASE("tiles: a pool of any size, in any order, stays in order") {
	std::mt19937 random(5);
	TileManager manager = make_manager(64);
	const auto draw = [&](int p_most) { return int(random() % uint32_t(p_most + 1)); };
	for (int round = 0; round < 200; round++) {
		std::vector<ColliderShape> balls;
		for (int i = draw(60); i > 0; i--) {
			balls.push_back(make_ball(manager, draw(39), draw(39)));
		}
		step(manager, balls);
		check_consistent(manager);
		const int before = manager.get_statistics().awake, slots = round % 7 == 0 ? 0 : draw(200);
		const std::vector<SlotMove> moves = manager.resize_pool(slots);
		const auto rested = std::ranges::count(moves, GRASS_NO_SLOT, &SlotMove::to);
		REQUIRE(rested == std::max(before - slots, 0));
		REQUIRE(manager.get_statistics().awake == before - int(rested));
		for (const SlotMove &move : moves) {
			REQUIRE(move.to < slots);
			REQUIRE(manager.get_slot_of(move.tile) == move.to);
		}
	}
	manager.resize_pool(-5);
	CHECK(manager.get_params().pool_size == 0);
	manager.resize_pool(1 << 30);
	CHECK(manager.get_params().pool_size == TileParams::MAX_POOL_SIZE);
}

TEST_CASE("tiles: slots exist as tiles need them, in powers of two, and go some seconds after") {
	TileManager manager = make_manager(4096);
	CHECK(manager.get_room() == 0);
	step(manager, {});
	CHECK(manager.get_room() == 0);
	step(manager, { make_ball(manager, 2) });
	CHECK(manager.get_room() == 16);
	check_consistent(manager);
	std::vector<ColliderShape> balls;
	for (int i = 0; i < 300; i++) {
		balls.push_back(make_ball(manager, i % 39, i / 39));
	}
	step(manager, balls); // in one step
	check_consistent(manager);
	CHECK(manager.get_statistics().awake == 300);
	CHECK(manager.get_statistics().refused == 0);
	CHECK(manager.get_room() == 512);
	const size_t at_most = manager.get_memory_usage();
	for (int i = 0; i < 60; i++) { // all but the last one come to rest
		step(manager, { balls.back() });
	}
	REQUIRE(manager.get_statistics().awake == 1);
	const int slot = manager.get_slot_of(manager.get_tile_of(299));
	CHECK(slot == 299);
	CHECK(manager.trim(2.9).empty());
	CHECK(manager.get_room() == 512);
	const std::vector<SlotMove> moves = manager.trim(0.2);
	CHECK(manager.get_room() == 32);
	REQUIRE(moves.size() == 1);
	CHECK(moves[0].from == 299);
	CHECK(moves[0].to == 0);
	step(manager, { balls.back() });
	check_consistent(manager);
	CHECK(manager.get_statistics().woken == 300); // it did not wake again
	for (int i = 0; i < 60; i++) {
		step(manager, {});
	}
	REQUIRE(manager.get_statistics().awake == 0);
	CHECK(manager.trim(3.1).empty());
	CHECK(manager.get_room() == 0);
	CHECK(manager.get_memory_usage() + 512 * 200 < at_most); // lists of colliders stay
}

TEST_CASE("tiles: many slots are prepared before they are there, and until then tiles wait without taking any from others") {
	TileManager manager = make_manager(4096);
	manager.get_room_plan().set_ready(64, 0);
	std::vector<ColliderShape> balls;
	for (int i = 0; i < 300; i++) {
		balls.push_back(make_ball(manager, i % 39, i / 39));
	}
	step(manager, { balls.begin(), balls.begin() + 40 });
	CHECK(manager.get_room() == 64);
	CHECK(manager.get_room_plan().get_wanted() == 0);
	for (int i = 0; i < 3; i++) {
		step(manager, { balls.begin() + 20, balls.end() });
		check_consistent(manager);
		CHECK(manager.get_statistics().awake == 64);
		CHECK(manager.get_statistics().evicted == 0);
		CHECK(manager.get_room_plan().get_wanted() == 512);
		manager.get_room_plan().set_ready(64, 0);
	}
	manager.get_room_plan().set_ready(64, 512);
	step(manager, { balls.begin() + 20, balls.end() });
	check_consistent(manager);
	CHECK(manager.get_statistics().awake == 300);
	CHECK(manager.get_statistics().woken == 300);
	CHECK(manager.get_room() == 512);
	CHECK(manager.get_room_plan().get_wanted() == 0);
	for (int i = 0; i < 60; i++) {
		step(manager, { balls.begin() + 200, balls.end() });
	}
	REQUIRE(manager.get_statistics().awake == 100);
	CHECK(manager.trim(3.1).empty()); // 256 of them are not there yet
	CHECK(manager.get_room() == 512);
	CHECK(manager.get_room_plan().get_wanted() == 256);
	manager.get_room_plan().set_ready(64, 256);
	CHECK(manager.trim(0.1).size() > 0);
	CHECK(manager.get_room() == 256);
	CHECK(manager.get_room_plan().get_wanted() == 0);
	step(manager, { balls.begin() + 200, balls.end() });
	check_consistent(manager);
	CHECK(manager.get_statistics().woken == 300);
}

TEST_CASE("tiles: slots that are needed now and then stay") {
	TileManager manager = make_manager(4096);
	step(manager, { make_ball(manager, 2) });
	for (int i = 0; i < 40; i++) { // for much longer than it takes until they go
		CHECK(manager.trim(1.0).empty());
		CHECK(manager.get_room() == 16);
		step(manager, { make_ball(manager, 2) });
	}
}

TEST_CASE("tiles: the records are the same whatever slots existed before") {
	TileManager grown = make_manager(4096), large = make_manager(4096);
	std::vector<ColliderShape> many;
	for (int i = 0; i < 1000; i++) {
		many.push_back(make_ball(large, i % 39, i / 39));
	}
	step(large, many);
	while (large.get_statistics().awake > 0) {
		step(large, {});
	}
	std::mt19937 random(9);
	for (int round = 0; round < 100; round++) {
		std::vector<ColliderShape> balls;
		for (uint32_t i = random() % 80; i > 0; i--) {
			balls.push_back(make_ball(grown, int(random() % 39), int(random() % 39)));
		}
		step(grown, balls);
		step(large, balls);
		REQUIRE(grown.get_slots().size() == large.get_slots().size());
		for (size_t i = 0; i < grown.get_slots().size(); i++) {
			REQUIRE(grown.get_slots()[i].tile == large.get_slots()[i].tile);
			REQUIRE(grown.get_slots()[i].list == large.get_slots()[i].list);
		}
	}
	CHECK(grown.get_room() < large.get_room());
}

TEST_CASE("tiles: no more are awake than are granted, and the calmest give way") {
	TileManager manager = make_manager(64);
	step(manager, { make_ball(manager, 2), make_ball(manager, 4), make_ball(manager, 6) });
	report(manager, { 3.0f, 1.0f, 2.0f });
	CHECK_FALSE(manager.lacks_grant());
	CHECK(manager.grant(40).empty()); // enough
	const std::vector<SlotMove> moves = manager.grant(2);
	REQUIRE(moves.size() == 1);
	CHECK(moves[0].tile == 4);
	CHECK(moves[0].to == GRASS_NO_SLOT);
	CHECK(manager.is_awake(2));
	CHECK(manager.is_awake(6));
	step(manager, { make_ball(manager, 2), make_ball(manager, 6), make_ball(manager, 8) });
	check_consistent(manager);
	CHECK(manager.lacks_grant());
	const PoolDemand demand = manager.find_demand();
	CHECK(demand.tiles[0] == 3); // nothing is known of cameras
	CHECK(demand.most == 64);
	manager.grant(64);
	step(manager, { make_ball(manager, 2), make_ball(manager, 6), make_ball(manager, 8) });
	CHECK(manager.get_statistics().awake == 3);
	CHECK_FALSE(manager.lacks_grant());
}
