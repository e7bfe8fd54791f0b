// SPDX-License-Identifier: MIT
// Tiles that are left as they are, since the colliders on them stand still.
#include <doctest/doctest.h>

#include "tile_scene.h"

#include <algorithm>
#include <random>

using namespace grass;
using namespace grass::test;

namespace {

// A manager that puts tiles to sleep by energy, with colliders that have stood in one of its tiles until that was left as it is.
struct StillScene {
	TileManager manager = make_manager();
	std::vector<ColliderShape> balls{ make_ball(manager, 3, 5) };

	StillScene() {
		balls[0].size = Eigen::Vector3d::Constant(0.1);
		balls[0].owner = 7;
		TileParams params = manager.get_params();
		params.sleep_mode = SleepMode::ENERGY;
		params.still_delay = 1.0;
		manager.set_params(params);
	}

	// Returns whether the tile is simulated in the next step, of a quarter of a second.
	bool is_simulated() {
		const int records = step(manager, balls);
		CHECK(manager.get_statistics().awake == 1);
		CHECK(manager.get_statistics().still == 1 - records);
		CHECK(manager.get_statistics().simulated == records);
		return records == 1;
	}
	// Steps until the tile is left as it is.
	int steps_until_still() {
		int steps = 0;
		while (steps < 20 && is_simulated()) {
			steps++;
		}
		return steps;
	}
};

constexpr int STEPS = 4; // of the delay

} // namespace

TEST_CASE("tiles: one whose colliders have stood still for long is left as it is, without a record, until anything changes") {
	StillScene scene;
	CHECK(scene.steps_until_still() == STEPS);
	CHECK(scene.manager.get_colliders().empty());
	CHECK(scene.manager.get_collider_list().empty());
	CHECK(scene.manager.get_sharp().empty());
	CHECK(!scene.is_simulated());
	CHECK(scene.manager.get_statistics().still == scene.manager.get_statistics().awake);
	SUBCASE("a collider that moves") {
		scene.balls[0].now.position.y() += 0.01;
		CHECK(scene.is_simulated());
		scene.balls[0].before = scene.balls[0].now;
		CHECK(scene.steps_until_still() == STEPS - 1);
	}
	SUBCASE("one that is elsewhere without having moved, or has turned so") {
		scene.balls[0].now.position.y() = scene.balls[0].before.position.y() += 0.01;
		CHECK(scene.steps_until_still() == STEPS);
		scene.balls[0].now.rotation = scene.balls[0].before.rotation = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ());
		CHECK(scene.steps_until_still() == STEPS);
	}
	SUBCASE("one that creeps more slowly than what counts as motion") {
		int simulated = 0;
		for (int i = 0; i < 250; i++) {
			scene.balls[0].before = scene.balls[0].now;
			scene.balls[0].now.position.y() += 9e-6;
			simulated += scene.is_simulated();
		}
		CHECK(simulated >= STEPS); // at each millimetre
	}
	SUBCASE("one that trembles") {
		scene.balls[0].now.position.y() += 4e-4;
		scene.balls[0].before = scene.balls[0].now;
		scene.steps_until_still();
		for (int i = 0; i < 20; i++) {
			std::swap(scene.balls[0].before, scene.balls[0].now);
			scene.balls[0].now.position.y() = scene.balls[0].before.position.y() + (i % 2 ? 5e-6 : -5e-6);
			CHECK(!scene.is_simulated());
		}
	}
	SUBCASE("another shape, another size, another one in its place") {
		scene.balls[0].size *= 1.001;
		CHECK(scene.steps_until_still() == STEPS);
		scene.balls[0].type = GRASS_BOX;
		CHECK(scene.steps_until_still() == STEPS);
		scene.balls[0].owner = 8;
		CHECK(scene.steps_until_still() == STEPS);
	}
	SUBCASE("one that comes, and goes") {
		scene.balls.push_back(scene.balls[0]);
		CHECK(scene.steps_until_still() == STEPS);
		scene.balls.pop_back();
		CHECK(scene.steps_until_still() == STEPS);
	}
	SUBCASE("the ground below it") {
		scene.manager.stir({ 3, 4, 5, 6 });
		CHECK(scene.steps_until_still() == STEPS);
		scene.manager.stir({ 7, 8, 5, 6 });
		CHECK(!scene.is_simulated());
	}
	SUBCASE("no collider any more") {
		scene.balls.clear();
		CHECK(step(scene.manager, {}) == 1);
	}
	SUBCASE("others that come before it in the order of all") {
		scene.balls.insert(scene.balls.begin(), make_ball(scene.manager, 9, 9));
		CHECK(step(scene.manager, scene.balls) == 1);
		CHECK(scene.manager.get_slots()[0].tile.x == 9);
	}
}

TEST_CASE("tiles: only time in which blades are simulated counts: what goes on moving when it is seen again is not left as it is") {
	StillScene scene;
	CHECK(scene.is_simulated());
	CHECK(scene.is_simulated());
	SUBCASE("its tile was out of view") {
		const Frustum nothing = { Eigen::Vector4f(1.0f, 0.0f, 0.0f, -1e6f), Eigen::Vector4f(-1.0f, 0.0f, 0.0f, -1e6f) };
		scene.manager.get_view().see(std::vector<Frustum>{ nothing }, 0.0f);
		for (int i = 0; i < 20; i++) {
			step(scene.manager, scene.balls);
		}
		CHECK(scene.manager.get_statistics().simulated == 0);
		CHECK(scene.manager.get_statistics().still == 0);
		scene.manager.get_view().see_all();
	}
	SUBCASE("the field was") {
		scene.manager.pass_unseen(60.0);
	}
	CHECK(scene.is_simulated());
}

TEST_CASE("tiles: put to sleep by the timer, they are simulated as long as a collider is in them, as in the paper") {
	StillScene scene;
	TileParams params = scene.manager.get_params();
	params.sleep_mode = SleepMode::TIMER;
	scene.manager.set_params(params);
	CHECK(scene.steps_until_still() == 20);
}

TEST_CASE("solver: the time in which a swing dies down: to a hundredth, within a second and ten") {
	SolverParams params;
	params.natural_frequency = 1.0;
	params.damping_ratio = 0.2;
	CHECK(params.calm_time() == doctest::Approx(3.665).epsilon(1e-3));
	params.damping_ratio = 0.0;
	CHECK(params.calm_time() == 10.0);
	params.damping_ratio = 1.0;
	params.natural_frequency = 8.0;
	CHECK(params.calm_time() == 1.0);
}

TEST_CASE("tiles: colliders with the stamp of the last step are not looked at again, and wake the same tiles as others do") {
	std::mt19937 random(5);
	std::uniform_real_distribution<double> place(-4.0, 4.0), size(0.1, 0.6);
	for (const int pool_size : { 4096, 40 }) { // the second is too small for all of them
		TileManager stamped = make_manager(pool_size), plain = make_manager(pool_size);
		std::vector<ColliderShape> colliders(24);
		uint64_t stamps = 0;
		for (int round = 0; round < 120; round++) {
			for (size_t i = 0; i < colliders.size(); i++) {
				ColliderShape &collider = colliders[i];
				collider.before = collider.now;
				const bool moves = round == 0 || int(random() % 40) == 0;
				if (moves) {
					collider.size.x() = size(random);
					collider.now.position = { place(random), 0.1, place(random) };
				}
				collider.stamp = moves ? 0 : (collider.stamp == 0 ? ++stamps : collider.stamp);
			}
			if (round % 30 == 29) { // others move up
				colliders.erase(colliders.begin() + 2);
			}
			std::vector<ColliderShape> copies = colliders, without = colliders;
			for (ColliderShape &collider : without) {
				collider.stamp = 0;
			}
			stamped.update(0.1, copies);
			plain.update(0.1, without);
			REQUIRE(stamped.get_slots().size() == plain.get_slots().size());
			CHECK(std::ranges::equal(stamped.get_slots(), plain.get_slots(), [](const GrassSlot &p_a, const GrassSlot &p_b) {
				return p_a.tile == p_b.tile && p_a.list == p_b.list && p_a.blend == p_b.blend;
			}));
			CHECK(std::ranges::equal(stamped.get_collider_list(), plain.get_collider_list()));
			CHECK(stamped.get_statistics().refused == plain.get_statistics().refused);
			for (size_t i = 0; i < colliders.size(); i++) {
				CHECK(stamped.has_met_grass(i) == plain.has_met_grass(i));
			}
		}
		CHECK(stamped.get_statistics().looked_at < plain.get_statistics().looked_at / (pool_size > 100 ? 3 : 1));
	}
}

TEST_CASE("tiles: a collider that stands still costs no look at a tile, until the ground changes below it") {
	StillScene scene;
	scene.balls[0].stamp = 1;
	scene.steps_until_still();
	const uint64_t before = scene.manager.get_statistics().looked_at;
	CHECK(before > 0);
	for (int i = 0; i < 10; i++) {
		CHECK(!scene.is_simulated());
	}
	CHECK(scene.manager.get_statistics().looked_at == before);
	SUBCASE("the ground") {
		scene.manager.stir({ 0, 1, 0, 1 });
		scene.is_simulated();
		CHECK(scene.manager.get_statistics().looked_at > before);
	}
	SUBCASE("the limits of the tiles") {
		TileParams params = scene.manager.get_params();
		params.height = 0.01;
		scene.manager.set_params(params);
		scene.balls[0].now.position.y() = scene.balls[0].before.position.y() = 0.3;
		scene.balls[0].stamp = 2;
		CHECK(step(scene.manager, scene.balls) == 1); // leaves, and rises
		CHECK(!scene.manager.has_met_grass(0));
	}
	SUBCASE("another pool: all tiles are at rest") {
		TileParams params = scene.manager.get_params();
		params.pool_size = 8;
		scene.manager.set_params(params);
		CHECK(scene.is_simulated());
		CHECK(scene.manager.get_statistics().woken == 1);
	}
}
