// SPDX-License-Identifier: MIT
// TileManager where its pool and its bounds end, and over long runs.
#include "core/tiles.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <set>
#include <vector>

using namespace grass;

namespace {

constexpr double QUARTER = 0.25; // seconds

TileManager make_manager(int p_pool_size, const TileGrid &p_grid) {
	TileManager manager;
	manager.set_grid(p_grid);
	TileParams params;
	params.pool_size = p_pool_size;
	params.reach = 0.0;
	manager.set_params(params);
	return manager;
}

TileManager make_manager(int p_pool_size) {
	return make_manager(p_pool_size, TileGrid::make(20.0, 20.0, 256.0));
}

// A ball well inside of tile (p_x, 0), resting.
ColliderShape make_ball(const TileManager &p_manager, int p_x) {
	ColliderShape ball;
	ball.size.x() = 0.1;
	ball.now.position = ball.before.position = p_manager.get_grid().get_centre(p_x, 0);
	return ball;
}

// A flat box over the whole field and more.
ColliderShape make_lid(double p_half_size) {
	ColliderShape lid;
	lid.type = GRASS_BOX;
	lid.size = { p_half_size, 0.1, p_half_size };
	return lid;
}

void step(TileManager &r_manager, std::vector<ColliderShape> p_colliders, double p_delta = QUARTER) {
	r_manager.update(p_delta, p_colliders);
}

bool has_slot(const TileManager &p_manager, int p_tile) {
	return p_manager.get_slot_of(p_tile) != GRASS_NO_SLOT;
}

// No slot and no tile twice among the live; every list within the entries; both ways tile <-> slot agree.
void check_consistent(const TileManager &p_manager) {
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
	REQUIRE(int(slots.size()) == statistics.awake + statistics.settling);
	REQUIRE(statistics.woken == statistics.slept + statistics.evicted + slots.size());
}

template <class T> bool have_same_bytes(std::span<const T> p_a, std::span<const T> p_b) {
	return p_a.size() == p_b.size() && (p_a.empty() || std::memcmp(p_a.data(), p_b.data(), p_a.size_bytes()) == 0);
}

} // namespace

TEST_CASE("tiles: in a full pool the tile touched longest ago gives its slot, both are announced") {
	TileManager manager = make_manager(3);
	step(manager, { make_ball(manager, 4) });
	step(manager, { make_ball(manager, 2) });
	step(manager, { make_ball(manager, 6) });
	step(manager, { make_ball(manager, 8) });
	check_consistent(manager);
	CHECK_FALSE(has_slot(manager, 4));
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
	CHECK_FALSE(has_slot(manager, 2));
	CHECK_FALSE(has_slot(manager, 6));
	CHECK(has_slot(manager, 8));
}

TEST_CASE("tiles: where energies are known the calmest gives its slot, a settling one before all") {
	TileManager manager = make_manager(3);
	step(manager, { make_ball(manager, 2), make_ball(manager, 4), make_ball(manager, 6) });
	manager.report_energy(0, 2, 3.0f);
	manager.report_energy(1, 4, 1.0f);
	manager.report_energy(2, 6, 2.0f);
	step(manager, { make_ball(manager, 8) });
	CHECK_FALSE(has_slot(manager, 4));
	step(manager, { make_ball(manager, 10) }); // 8 is not known yet, so thought lively
	CHECK_FALSE(has_slot(manager, 6));
	for (int i = 0; i < 6; i++) {
		step(manager, { make_ball(manager, 8), make_ball(manager, 10) });
	}
	REQUIRE(manager.get_statistics().settling == 1); // 2
	manager.report_energy(manager.get_slot_of(2), 2, 100.0f);
	manager.report_energy(manager.get_slot_of(8), 8, 0.0f);
	step(manager, { make_ball(manager, 12), make_ball(manager, 10) });
	CHECK_FALSE(has_slot(manager, 2));
	CHECK(has_slot(manager, 8));
}

TEST_CASE("tiles: late and bad energies change nothing") {
	TileManager manager = make_manager(2);
	step(manager, { make_ball(manager, 2) });
	step(manager, { make_ball(manager, 4) });
	manager.report_energy(0, 3, 0.0f); // was another tile's
	manager.report_energy(1, 4, std::numeric_limits<float>::quiet_NaN());
	manager.report_energy(-1, 2, 0.0f);
	manager.report_energy(5, 2, 0.0f);
	manager.report_energy(1, -1, 0.0f);
	step(manager, { make_ball(manager, 6) });
	CHECK_FALSE(has_slot(manager, 2));
}

TEST_CASE("tiles: a tile under an object never gives its slot: the wish is refused, until one is free") {
	TileManager manager = make_manager(2);
	const std::vector<ColliderShape> balls = { make_ball(manager, 2), make_ball(manager, 4), make_ball(manager, 6) };
	for (int i = 1; i <= 20; i++) {
		step(manager, balls);
		check_consistent(manager);
		CHECK(has_slot(manager, 2));
		CHECK(has_slot(manager, 4));
		CHECK(manager.get_statistics().refused == uint64_t(i));
		CHECK(manager.get_statistics().evicted == 0);
		CHECK(manager.get_colliders().size() == 2);
	}
	step(manager, { balls[1], balls[2] });
	CHECK(has_slot(manager, 6));
	CHECK_FALSE(has_slot(manager, 2));
	CHECK(manager.get_statistics().evicted == 1);
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
	while (manager.get_statistics().awake + manager.get_statistics().settling > 0) {
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
	params.sleep_delay = params.settle_time = params.reach = params.height = nan;
	params = params.sanitised();
	CHECK(params.sleep_delay == 2.0);
	CHECK(params.settle_time == 0.5);
	CHECK(params.reach == TileParams().reach);
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

TEST_CASE("tiles: 100,000 wakings and sleeps take no more memory than the first") {
	TileManager manager = make_manager(8);
	TileParams params = manager.get_params();
	params.sleep_delay = 0.0;
	manager.set_params(params);
	size_t memory = 0;
	for (int i = 0; i < 100000; i++) {
		std::vector<ColliderShape> balls = { make_ball(manager, i % 40), make_ball(manager, (i * 7 + 3) % 40) };
		manager.update(0.25, balls);
		manager.update(0.25, {});
		manager.update(0.25, {});
		manager.update(0.25, {});
		memory = i == 100 ? manager.get_memory_usage() : memory;
	}
	CHECK(manager.get_memory_usage() == memory);
	CHECK(manager.get_statistics().woken >= 100000);
	CHECK(manager.get_statistics().slept == manager.get_statistics().woken);
	CHECK(manager.get_statistics().high_water <= 8);
}

TEST_CASE("tiles: the same storm twice gives the same records, bit for bit, and is consistent in every step") {
	TileManager first = make_manager(200), second = make_manager(200);
	TileParams params = first.get_params();
	params.sleep_delay = 0.2;
	params.settle_time = 0.1;
	first.set_params(params);
	second.set_params(params);
	std::vector<ColliderShape> bodies(40);
	std::mt19937 random(12);
	std::uniform_real_distribution<double> place(-10.0, 10.0), size(0.05, 1.5), move(-0.5, 0.5);
	int differing = 0;
	for (int i = 0; i < 600; i++) {
		for (ColliderShape &body : bodies) {
			const bool is_placed = i == 0 || random() % 50 == 0;
			body.type = is_placed ? int(random() % 4) : body.type;
			body.size = is_placed ? Eigen::Vector3d(size(random), size(random), size(random)) : body.size;
			body.before = body.now;
			body.now.position += Eigen::Vector3d(move(random), 0.0, move(random));
			body.now.position = is_placed ? Eigen::Vector3d(place(random), 0.5, place(random)) : body.now.position;
			body.before = is_placed ? body.now : body.before;
		}
		const std::span<ColliderShape> present(bodies.data(), random() % 3 == 0 ? 0 : random() % bodies.size());
		const double delta = random() % 2 == 0 ? 1.0 / 60.0 : 0.1;
		first.update(delta, present);
		second.update(delta, present);
		differing += have_same_bytes(first.get_slots(), second.get_slots()) ? 0 : 1;
		differing += have_same_bytes(first.get_colliders(), second.get_colliders()) ? 0 : 1;
		differing += have_same_bytes(first.get_collider_list(), second.get_collider_list()) ? 0 : 1;
		const int slot = int(random() % 200);
		const float energy = float(random() % 100);
		first.report_energy(slot, first.get_tile_of(slot), energy);
		second.report_energy(slot, second.get_tile_of(slot), energy);
		check_consistent(first);
	}
	CHECK(differing == 0);
	CHECK(first.get_statistics().evicted > 0);
	CHECK(first.get_statistics().slept > 0);
	CHECK(first.get_statistics().refused > 0);
}
