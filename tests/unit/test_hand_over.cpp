// SPDX-License-Identifier: MIT
// Tiles, solver and sleep together: what is seen when a tile goes to sleep by energy.
#include "sampled.h"
#include "tile_scene.h"

#include "core/solver/simulate.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

using namespace grass;
using namespace grass::test;

namespace {

using Knots = std::vector<Eigen::Vector3f>; // of a tile

float farthest(const Knots &p_a, const Knots &p_b) {
	float most = 0.0f;
	for (size_t i = 0; i < p_a.size(); i++) {
		most = std::max(most, (p_a[i] - p_b[i]).norm());
	}
	return most;
}

// A ball that rolls through a field of 12 x 12 tiles, with all that a GrassField does in a tick.
struct Meadow {
	TileManager tiles;
	std::shared_ptr<const Patch> patch = std::make_shared<const Patch>(generate_patch(PatchParams()));
	CpuPool pool{ patch, 144 };
	StepClock clock;
	SolverParams solver;
	ColliderShape ball;
	uint64_t pool_step = 0; // the last one that was simulated

	// What was seen, metres. `awake`: the last pose of each tile before it settled; `last`: of the last step.
	std::map<int, Knots> awake, last;
	float longest_step = 0.0f, longest_way = 0.0f; // of a knot: in one step while settling, from awake to asleep

	explicit Meadow(const SolverParams &p_solver, double p_motion = 1e-3) : solver(p_solver) {
		tiles.set_grid(TileGrid::make(6.0, 6.0, 256.0));
		TileParams params;
		params.pool_size = 144;
		params.sleep_energy = solver.energy_within(p_motion);
		tiles.set_params(params);
		ball.size.x() = 0.15;
		ball.now.position = { -3.0, 0.15, 0.1 };
	}

	Knots knots(int p_slot) const {
		Knots all;
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			const Knots blade = pool.get_knots(p_slot, b);
			all.insert(all.end(), blade.begin(), blade.end());
		}
		return all;
	}
	void step(double p_delta) {
		ball.before = ball.now;
		ball.now.position.x() += 2.0 * p_delta;
		std::vector<ColliderShape> colliders = { ball };
		tiles.report_energy({ pool_step - (pool_step > 0), pool.get_energy() }); // energies are those at the start of a step
		tiles.update(p_delta, colliders);
		GrassStep record = clock.advance(solver, p_delta);
		record.field = { 0.5f, 12.0f, 12.0f, 0.0f };
		record.clump = { 1.6f, 1.0f, 1.0f, 1.0f };
		const auto slots = tiles.get_slots();
		pool.step({ slots, tiles.get_colliders(), tiles.get_collider_list(), tiles.get_planes(), record, tiles.get_step_number() });
		pool_step = tiles.get_step_number();
		for (const GrassSlot &slot : slots) {
			look(slot);
		}
	}
	void look(const GrassSlot &p_slot) {
		const int tile = p_slot.tile.z;
		if (p_slot.list.w & GRASS_SLOT_RETIRED) { // drawn at rest from now on: where its last step left it
			longest_way = std::max(longest_way, farthest(awake[tile], last[tile]));
			return;
		}
		const Knots now = knots(p_slot.tile.w);
		if (tiles.is_settling(tile)) {
			longest_step = std::max(longest_step, farthest(last[tile], now));
		} else {
			awake[tile] = now;
		}
		last[tile] = now;
	}
	// Until all is asleep; seconds that it took.
	double run(double p_rate) {
		double seconds = 0.0;
		while (seconds < 30.0 && (seconds < 4.0 || tiles.get_statistics().awake > 0)) {
			step(1.0 / p_rate);
			seconds += 1.0 / p_rate;
		}
		return seconds;
	}
};

SolverParams make_solver(Method p_method, double p_frequency, double p_damping) {
	SolverParams solver;
	solver.method = p_method;
	solver.natural_frequency = p_frequency;
	solver.damping_ratio = p_damping;
	return solver;
}

} // namespace

TEST_CASE("Below its energy no knot is farther from rest than the distance, nor would it swing farther") {
	SolverParams solver;
	for (const double rate : { 30.0, 60.0, 144.0 }) {
		StepClock clock;
		const GrassStep step = clock.advance(solver, 1.0 / rate);
		const double distance = 1e-3, energy = solver.energy_within(distance);
		// All of the energy in one knot: at the tip, where the pull to rest is weakest, and as speed.
		CHECK(0.5 * double(step.energy.y) * distance * distance / GRASS_FREE_KNOTS == doctest::Approx(energy));
		const double moved = distance * 2.0 * 3.14159265358979 * solver.natural_frequency / rate;
		CHECK(0.5 * double(step.energy.x) * moved * moved / GRASS_FREE_KNOTS == doctest::Approx(energy));
	}
}

TEST_CASE("A tile goes to sleep without a motion that could be seen, by either method") {
	constexpr struct {
		double frequency, damping, rate; // Hz, ratio, steps a second
	} SWINGS[] = { { 1.2, 0.5, 30 }, { 1.2, 0.5, 60 }, { 1.2, 0.5, 144 }, { 1.2, 0.15, 30 }, { 0.6, 0.6, 60 }, { 5.0, 0.1, 30 },
		{ 2.0, 1.5, 60 } };
	for (const Method method : { Method::PBD, Method::DIRECT }) {
		for (const auto &swing : sampled(SWINGS, 3)) {
			Meadow meadow(make_solver(method, swing.frequency, swing.damping));
			const double seconds = meadow.run(swing.rate);
			INFO("method ", int(method), ", ", swing.frequency, " Hz, damping ", swing.damping, ", ", swing.rate, " steps a second");
			CHECK(meadow.tiles.get_statistics().awake == 0);
			CHECK(meadow.tiles.get_statistics().slept >= 24);
			CHECK(seconds < 12.0);
			CHECK(meadow.longest_step < 1e-3f);
			CHECK(meadow.longest_way < 1e-3f);
			CHECK(meadow.longest_way > 0.0f);
		}
	}
}
