// SPDX-License-Identifier: MIT
// TileManager over long runs: neither memory nor order is lost.
#include "on_threads.h"
#include "tile_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

using namespace grass;
using namespace grass::test;

namespace {

template <class T> bool have_same_bytes(std::span<const T> p_a, std::span<const T> p_b) {
	return p_a.size() == p_b.size() && (p_a.empty() || std::memcmp(p_a.data(), p_b.data(), p_a.size_bytes()) == 0);
}

bool have_same_records(const TileManager &p_a, const TileManager &p_b) {
	return have_same_bytes(p_a.get_slots(), p_b.get_slots()) && have_same_bytes(p_a.get_colliders(), p_b.get_colliders()) &&
			have_same_bytes(p_a.get_collider_list(), p_b.get_collider_list());
}

// A step of bodies that wander within p_reach metres; now and then one becomes another one elsewhere.
void move_bodies(std::span<ColliderShape> r_bodies, std::mt19937 &r_random, double p_reach, bool p_is_first) {
	std::uniform_real_distribution<double> place(-p_reach, p_reach), size(0.05, 1.5), move(-0.5, 0.5);
	for (ColliderShape &body : r_bodies) {
		const bool is_placed = p_is_first || r_random() % 50 == 0;
		body.type = is_placed ? int(r_random() % 4) : body.type;
		body.size = is_placed ? Eigen::Vector3d{ size(r_random), size(r_random), size(r_random) } : body.size;
		body.before = body.now;
		body.now.position += Eigen::Vector3d{ move(r_random), 0.0, move(r_random) };
		body.now.position = is_placed ? Eigen::Vector3d{ place(r_random), 0.5, place(r_random) } : body.now.position;
		body.before = is_placed ? body.now : body.before;
		body.stamp = 0;
	}
}

} // namespace

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
	SUBCASE("by timer") {
		params.sleep_mode = SleepMode::TIMER;
	}
	SUBCASE("by energy") {
		params.sleep_mode = SleepMode::ENERGY;
	}
	params.sleep_energy = 5.0;
	params.sleep_delay = 0.2;
	params.settle_time = 0.1;
	first.set_params(params);
	second.set_params(params);
	std::mt19937 random(12);
	std::vector<ColliderShape> bodies(40);
	int differing = 0;
	for (int i = 0; i < 600; i++) {
		move_bodies(bodies, random, 10.0, i == 0);
		const std::span<ColliderShape> present(bodies.data(), random() % 3 == 0 ? 0 : random() % bodies.size());
		const double delta = random() % 2 == 0 ? 1.0 / 60.0 : 0.1;
		first.update(delta, present);
		second.update(delta, present);
		differing += have_same_records(first, second) ? 0 : 1;
		std::vector<float> energies(200);
		for (float &energy : energies) {
			energy = float(random() % 20);
		}
		const uint64_t late = std::min(first.get_step_number(), uint64_t(random() % 4));
		report(first, energies, first.get_step_number() - late);
		report(second, energies, second.get_step_number() - late);
		check_consistent(first);
	}
	CHECK(differing == 0);
	CHECK(first.get_statistics().evicted > 0);
	CHECK(first.get_statistics().slept > 0);
	CHECK(first.get_statistics().refused > 0);
}

TEST_CASE("tiles: threads choose for a crowd what one does") {
	const TileGrid grid = TileGrid::make(60.0, 60.0, 256.0);
	int pool_size = 0;
	SUBCASE("more than the pool holds") {
		pool_size = 300;
	}
	SUBCASE("and with room for all") {
		pool_size = grid.get_tiles_x() * grid.get_tiles_z();
	}
	TileManager alone = make_manager(pool_size, grid), together = make_manager(pool_size, grid);
	std::vector<ColliderShape> bodies(500);
	std::mt19937 random(3);
	int differing = 0;
	for (int i = 0; i < 60; i++) {
		const size_t moving = i == 0 ? bodies.size() : random() % bodies.size();
		move_bodies(std::span(bodies).first(moving), random, 30.0, i == 0);
		for (size_t k = moving; k < bodies.size(); k++) {
			bodies[k].before = bodies[k].now;
			bodies[k].stamp = bodies[k].stamp == 0 ? uint64_t(i) * bodies.size() + k + 1 : bodies[k].stamp;
		}
		ColliderShape &odd = bodies[random() % bodies.size()];
		odd.size.x() = i % 7 == 0 ? std::nan("") : 0.4;
		odd.stamp = 0;
		ColliderShape &far = bodies[random() % bodies.size()]; // aslant over the field in one step
		far.before.position.x() -= i % 5 == 0 ? 50.0 : 0.0;
		far.stamp = 0;
		const std::span<ColliderShape> present = std::span(bodies).first(i % 9 == 8 ? 200 : bodies.size());
		std::vector<ColliderShape> copies(present.begin(), present.end());
		alone.update(1.0 / 60.0, present);
		together.update(1.0 / 60.0, copies, on_threads);
		differing += have_same_records(alone, together) ? 0 : 1;
		for (size_t k = 0; k < present.size(); k++) {
			differing += alone.has_met_awake(k) != together.has_met_awake(k) || alone.has_met_grass(k) != together.has_met_grass(k);
		}
		check_consistent(together);
	}
	CHECK(differing == 0);
	const TileStatistics &counts = alone.get_statistics(), &counts_together = together.get_statistics();
	CHECK(counts.looked_at == counts_together.looked_at);
	CHECK(counts.refused == counts_together.refused);
	CHECK(counts.bad_colliders == counts_together.bad_colliders);
	CHECK(counts.capped == counts_together.capped);
	CHECK((counts.capped > 0) == (pool_size == 300));
	CHECK(counts.bad_colliders > 0);
	CHECK((counts.refused > 0) == (pool_size == 300));
}
