// SPDX-License-Identifier: MIT
// TileManager while its pool becomes larger or smaller under awake tiles.
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
