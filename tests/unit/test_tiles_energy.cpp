// SPDX-License-Identifier: MIT
// How tiles go to sleep by energy: TileManager and reports made by hand. With the solver: test_hand_over.cpp.
#include "tile_scene.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace grass;
using namespace grass::test;

namespace {

constexpr float CALM = 1.0f, LIVELY = 5.0f; // J/kg: the bound itself, and more than four times as much
constexpr float BETWEEN = 3.0f; // neither makes calm nor ends it

TileManager make_energy_manager(int p_pool_size = 64) {
	TileManager manager = make_manager(p_pool_size);
	TileParams params = manager.get_params();
	params.sleep_mode = SleepMode::ENERGY;
	params.sleep_energy = CALM;
	manager.set_params(params);
	return manager;
}

// Returns the tile of a ball that was there in one step, and has gone.
TileManager make_left_tile() {
	TileManager manager = make_energy_manager();
	step(manager, { make_ball(manager, 3) });
	return manager;
}

// A step after a report for the first slot; whether the tile in it settles then.
bool settles_after(TileManager &r_manager, float p_energy) {
	report(r_manager, { p_energy });
	step(r_manager, {});
	return r_manager.is_settling(3);
}

} // namespace

TEST_CASE("tiles: by energy a tile sleeps after half a second of calm, and settles at once") {
	TileManager manager = make_left_tile();
	CHECK_FALSE(settles_after(manager, LIVELY));
	CHECK_FALSE(settles_after(manager, CALM)); // calm from here on
	CHECK_FALSE(manager.is_settling(3));
	CHECK(settles_after(manager, CALM));
	CHECK(manager.get_slots()[0].blend.x == 1.0f); // a tenth of a second is less than this step
	step(manager, {});
	CHECK_FALSE(manager.is_awake(3));
	CHECK(manager.get_statistics().slept == 1);
	CHECK(manager.get_statistics().tile_steps == 4);
}

TEST_CASE("tiles: a calm tile settles in a tenth of a second, or in settle_time if that is shorter") {
	for (const double settle_time : { 0.5, 0.05, 0.0 }) {
		TileManager manager = make_left_tile();
		TileParams params = manager.get_params();
		params.settle_time = settle_time;
		manager.set_params(params);
		int settling_steps = 0;
		for (int i = 0; i < 60; i++) {
			report(manager, { 0.0f });
			step(manager, {}, 0.01);
			settling_steps += manager.is_settling(3) ? 1 : 0;
		}
		CHECK_FALSE(manager.is_awake(3));
		CHECK(settling_steps == std::max(1, int(std::lround(100.0 * std::min(settle_time, 0.1)))));
	}
}

TEST_CASE("tiles: calm is not lost between the bound and four times the bound, but nothing falls asleep there") {
	TileManager manager = make_left_tile();
	CHECK_FALSE(settles_after(manager, CALM));
	CHECK_FALSE(settles_after(manager, BETWEEN));
	CHECK_FALSE(settles_after(manager, BETWEEN));
	CHECK_FALSE(settles_after(manager, BETWEEN));
	CHECK(settles_after(manager, CALM));
	TileManager other = make_left_tile();
	for (int i = 0; i < 8; i++) {
		CHECK_FALSE(settles_after(other, BETWEEN)); // never became calm
	}
}

TEST_CASE("tiles: one lively report, or a touch, and the half second begins anew") {
	TileManager manager = make_left_tile();
	settles_after(manager, CALM);
	CHECK_FALSE(settles_after(manager, LIVELY));
	CHECK_FALSE(settles_after(manager, CALM));
	step(manager, { make_ball(manager, 3) });
	CHECK_FALSE(settles_after(manager, CALM));
	CHECK(settles_after(manager, CALM));
	step(manager, { make_ball(manager, 3) }); // while it settles
	CHECK_FALSE(manager.is_settling(3));
	CHECK_FALSE(settles_after(manager, CALM));
	CHECK(settles_after(manager, CALM));
}

TEST_CASE("tiles: under a collider nothing sleeps, however calm it is") {
	TileManager manager = make_energy_manager();
	for (int i = 0; i < 200; i++) {
		step(manager, { make_ball(manager, 3) });
		report(manager, { 0.0f });
	}
	CHECK(manager.is_awake(3));
	CHECK_FALSE(manager.is_settling(3));
	CHECK_FALSE(settles_after(manager, CALM));
	CHECK(settles_after(manager, CALM));
}

TEST_CASE("tiles: where no energy is reported the timer holds, but not within the half second") {
	TileManager manager = make_left_tile();
	for (int i = 0; i < 7; i++) {
		step(manager, {});
		REQUIRE_FALSE(manager.is_settling(3));
	}
	step(manager, {});
	CHECK(manager.is_settling(3)); // 2 s
	CHECK(manager.get_slots()[0].blend.x == 0.5f); // the whole settle_time: nobody knows how far it has to go
	TileManager quick = make_left_tile();
	TileParams params = quick.get_params();
	params.sleep_delay = 0.0;
	quick.set_params(params);
	step(quick, {});
	CHECK_FALSE(quick.is_settling(3));
	step(quick, {});
	CHECK(quick.is_settling(3));
}

TEST_CASE("tiles: blades that never calm down settle ten seconds after the last touch") {
	TileManager manager = make_left_tile();
	for (int i = 0; i < 39; i++) {
		REQUIRE_FALSE(settles_after(manager, LIVELY));
	}
	CHECK(settles_after(manager, LIVELY));
	CHECK(manager.get_slots()[0].blend.x == 0.5f); // in settle_time: there is a way to go
}

TEST_CASE("tiles: by timer energies are no reason to sleep, nor to stay awake") {
	for (const float energy : { 0.0f, LIVELY }) {
		TileManager manager = make_left_tile();
		TileParams params = manager.get_params();
		params.sleep_mode = SleepMode::TIMER;
		manager.set_params(params);
		for (int i = 0; i < 7; i++) {
			REQUIRE_FALSE(settles_after(manager, energy));
		}
		CHECK(settles_after(manager, energy));
		CHECK(manager.get_slots()[0].blend.x == 0.5f);
	}
}

TEST_CASE("tiles: energies that were measured before the last touch are not this tile's") {
	TileManager manager = make_energy_manager(1);
	step(manager, { make_ball(manager, 3) });
	step(manager, {});
	step(manager, { make_ball(manager, 5) }); // takes the only slot
	const uint64_t before = manager.get_step_number() - 1;
	for (int i = 0; i < 7; i++) {
		report(manager, { 0.0f }, before);
		step(manager, {});
		REQUIRE_FALSE(manager.is_settling(5));
	}
	step(manager, {});
	CHECK(manager.is_settling(5)); // as if nothing had been reported
}

TEST_CASE("tiles: a reset does not let energies of the life before in") {
	TileManager manager = make_energy_manager();
	step(manager, { make_ball(manager, 3) });
	manager.reset();
	step(manager, { make_ball(manager, 3) });
	CHECK(manager.get_step_number() == 2);
	report(manager, { 0.0f }, 1); // of the life before
	step(manager, {});
	step(manager, {});
	CHECK_FALSE(manager.is_settling(3));
	report(manager, { 0.0f }, 2);
	step(manager, {});
	step(manager, {});
	CHECK(manager.is_settling(3));
}

TEST_CASE("tiles: a tile that is not touched any more, hundreds of times over, leaves no slot behind") {
	TileManager manager = make_energy_manager(8);
	for (int i = 0; i < 300; i++) {
		step(manager, { make_ball(manager, i % 40) });
		report(manager, { CALM, LIVELY, BETWEEN, CALM, 0.0f, LIVELY, CALM, BETWEEN });
		check_consistent(manager);
	}
	for (int i = 0; i < 44; i++) {
		report(manager, std::vector<float>(8, LIVELY));
		step(manager, {});
	}
	CHECK(manager.get_statistics().awake == 0);
}

TEST_CASE("tiles: the same report again changes nothing: no tile is calm earlier, and none that woke since is meant") {
	TileManager once = make_left_tile(), often = make_left_tile();
	const uint64_t measured = once.get_step_number();
	report(once, { CALM }, measured);
	for (int i = 0; i < 4; i++) {
		report(often, { i == 0 ? CALM : LIVELY }, measured); // what comes later under that number is not looked at
		step(once, {});
		step(often, {});
		CHECK(once.is_settling(3) == often.is_settling(3));
	}
	CHECK_FALSE(often.is_awake(3));
}
