// SPDX-License-Identifier: MIT
// TileManager over long runs: neither memory nor order is lost.
#include "tile_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <random>

using namespace grass;
using namespace grass::test;

namespace {

template <class T> bool have_same_bytes(std::span<const T> p_a, std::span<const T> p_b) {
	return p_a.size() == p_b.size() && (p_a.empty() || std::memcmp(p_a.data(), p_b.data(), p_a.size_bytes()) == 0);
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
