// SPDX-License-Identifier: MIT
// For a long time, and again and again: nothing drifts, and what happens again happens alike, bit for bit.
#include "grown_tile.h"
#include "stress.h"

#include "core/solver/simulate.h"
#include "core/tiles/tiles.h"

#include <doctest/doctest.h>

using namespace grass;
using namespace grass::test;

namespace {

constexpr double DELTA = 1.0 / 64.0; // seconds; sums of it are exact
constexpr int CYCLE = 24; // steps from one waking to the next

// One tile, which a ball wakes in every cycle and leaves to sleep, with all that a GrassField does in a tick.
struct Sleeper {
	TileManager tiles;
	CpuPool pool{ shared_patch(), 1 };
	StepClock clock;
	SolverParams solver;
	std::vector<ColliderShape> bodies;

	explicit Sleeper(Method p_method) {
		solver.method = p_method;
		tiles.set_grid(TileGrid::make(0.5, 0.5, 256.0));
		TileParams params;
		params.pool_size = 1;
		params.sleep_mode = SleepMode::TIMER;
		params.sleep_delay = 4 * DELTA;
		params.settle_time = 4 * DELTA;
		tiles.set_params(params);
	}
	void step(int p_time) {
		bodies.clear();
		if (p_time < 8) {
			ColliderShape ball;
			ball.size.x() = 0.1;
			ball.before.position = { -0.2 + 0.05 * p_time, 0.15, 0.02 };
			ball.now.position = { -0.15 + 0.05 * p_time, 0.15, 0.02 };
			bodies.push_back(ball);
		}
		tiles.update(DELTA, bodies);
		GrassStep record = clock.advance(solver, DELTA);
		record.field = { 0.5f, 1.0f, 1.0f, 0.0f };
		record.clump = { 1.6f, 1.0f, 1.0f, 1.0f };
		pool.step({ tiles.get_slots(), tiles.get_colliders(), tiles.get_collider_list(), tiles.get_planes(), record,
				tiles.get_step_number() });
	}
	// A hash of every knot after every step in which the tile was awake; FNV-1a.
	uint64_t cycle() {
		uint64_t hash = 14695981039346656037u;
		std::vector<uint16_t> row(GRASS_POOL_BLADES_PER_ROW * GRASS_KNOTS * 4);
		for (int time = 0; time < CYCLE; time++) {
			step(time);
			if (tiles.get_statistics().awake > 0) {
				for (const int blade : { 7, 40 }) {
					for (const Eigen::Vector3f &knot : pool.get_knots(0, blade)) {
						for (const float part : { knot.x(), knot.y(), knot.z() }) {
							hash = (hash ^ std::bit_cast<uint32_t>(part)) * 1099511628211u;
						}
					}
				}
			}
		}
		return hash;
	}
};

} // namespace

TEST_CASE("stress: a million steps at rest (100,000 if not in full), beside a body that touches nothing, change no bit") {
	check_each(2, [](int p_number) -> std::string {
		BladeScene scene;
		scene.params.method = METHODS[p_number];
		scene.add(GRASS_SPHERE, { 0.68f, 0.2f, 0.0f }, { 0.15f, 0, 0 }); // so near that no blade may be skipped as idle
		for (int i = sized(100000, 1000000); i > 0; i--) {
			scene.step();
		}
		return scene.is_exactly_at_rest() && scene.energy == 0.0f ? "" : std::string(name_of(METHODS[p_number])) + ": blades have moved";
	});
}

TEST_CASE("stress: a tile woken and put to sleep 100,000 times (2,000 if not in full) moves alike every time, bit for bit") {
	check_each(2, [](int p_number) -> std::string {
		Sleeper sleeper(METHODS[p_number]);
		sleeper.cycle(); // the very first step knows no step before it
		const uint64_t wanted = sleeper.cycle();
		const int cycles = sized(2000, 100000);
		for (int i = 0; i < cycles; i++) {
			if (sleeper.cycle() != wanted) {
				return std::string(name_of(METHODS[p_number])) + ", cycle " + std::to_string(i) + " is another one";
			}
		}
		const TileStatistics &counts = sleeper.tiles.get_statistics();
		return counts.slept == uint64_t(cycles) + 2 && counts.woken == counts.slept ? "" : "the tile did not wake and sleep every time";
	});
}
