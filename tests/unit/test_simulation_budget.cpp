// SPDX-License-Identifier: MIT
// How the time of steps decides how coarse the simulation is.
#include "core/lod/simulation_budget.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <random>

using namespace grass;

namespace {

constexpr double NAN_TIME = std::numeric_limits<double>::quiet_NaN(), ENDLESS = std::numeric_limits<double>::infinity();

// A field whose steps take p_whole milliseconds if every drawn blade is simulated. A share of that stays however coarse it is. Its times
// are known three steps late, and vary by p_noise.
struct Plant {
	SimulationBudget budget;
	double whole, fixed = 0.2, power = 1.5, noise = 0.1;
	std::mt19937 random{ 20261126 };
	std::deque<double> on_their_way{ 0.0, 0.0, 0.0 };

	double time() const { return whole * (fixed + (1.0 - fixed) / std::pow(double(budget.get_coarseness()), power)); }
	void step(double p_budget) {
		on_their_way.push_back(time() * (1.0 + noise * std::uniform_real_distribution<double>(-1.0, 1.0)(random)));
		budget.advance(p_budget, on_their_way.front());
		on_their_way.pop_front();
	}
	void steps(int p_count, double p_budget) {
		for (int i = 0; i < p_count; i++) {
			step(p_budget);
		}
	}
};

} // namespace

TEST_CASE("simulation budget: steps come within it and stay there, whatever they take and however much they vary") {
	for (const double power : { 0.5, 1.0, 2.0 }) {
		for (const double whole : { 1.2, 1.6, 2.2 }) {
			for (const double noise : { 0.0, 0.1, 0.3 }) {
				Plant plant;
				plant.power = power;
				plant.whole = whole;
				plant.noise = noise;
				plant.steps(400, 1.0);
				float least = SimulationBudget::MOST, most = 1.0f;
				for (int i = 0; i < 600; i++) {
					plant.step(1.0);
					CHECK(plant.time() < 1.1);
					least = std::min(least, plant.budget.get_coarseness());
					most = std::max(most, plant.budget.get_coarseness());
				}
				CHECK(plant.time() > 0.65); // and uses it
				CHECK(most / least < 1.35f); // without swinging
				if (noise <= 0.1) {
					CHECK(most / least < 1.1f);
				}
			}
		}
	}
}

TEST_CASE("simulation budget: a step changes little, in both directions") {
	Plant plant;
	plant.whole = 20.0;
	float before = plant.budget.get_coarseness();
	float most = 0.0f;
	for (int i = 0; i < 600; i++) {
		plant.whole = i < 300 ? 20.0 : 0.1;
		plant.step(1.0);
		most = std::max(most, std::abs(plant.budget.get_coarseness() / before - 1.0f));
		before = plant.budget.get_coarseness();
		CHECK(before >= 1.0f);
		CHECK(before <= SimulationBudget::MOST);
		if (i == 299) {
			CHECK(before == SimulationBudget::MOST);
		}
	}
	CHECK(before == 1.0f);
	CHECK(most <= SimulationBudget::FASTEST + 1e-5f);
	CHECK(most > 0.01f);
}

TEST_CASE("simulation budget: within the dead band, and without a time, nothing changes") {
	SimulationBudget budget;
	for (int i = 0; i < 60; i++) {
		budget.advance(1.0, 2.0);
	}
	const float coarse = budget.get_coarseness();
	CHECK(coarse > 1.5f);
	for (const double time : { 0.0, -1.0, NAN_TIME, ENDLESS }) {
		for (int i = 0; i < 20; i++) {
			budget.advance(1.0, time);
		}
	}
	CHECK(budget.get_coarseness() == coarse);
	for (int i = 0; i < 3; i++) {
		budget.advance(1.0, 0.9);
	}
	const float settled = budget.get_coarseness();
	for (int i = 0; i < 60; i++) {
		budget.advance(1.0, i % 2 == 0 ? 0.82 : 0.98);
	}
	CHECK(budget.get_coarseness() == settled);
}

TEST_CASE("simulation budget: one slow frame, or two, change nothing") {
	SimulationBudget budget;
	for (int i = 0; i < 200; i++) {
		budget.advance(1.0, i % 10 < 2 ? 50.0 : 0.9);
	}
	CHECK(budget.get_coarseness() == 1.0f);
}

TEST_CASE("simulation budget: without one, and with one that is no number, every drawn blade is simulated again, slowly") {
	for (const double none : { 0.0, -2.0, NAN_TIME, ENDLESS }) {
		SimulationBudget budget;
		for (int i = 0; i < 60; i++) {
			budget.advance(1.0, 9.0);
		}
		float before = budget.get_coarseness();
		CHECK(before > 2.0f);
		for (int i = 0; i < 200; i++) {
			budget.advance(none, 9.0);
			CHECK(budget.get_coarseness() >= before * (1.0f - SimulationBudget::FASTEST) - 1e-5f);
			before = budget.get_coarseness();
		}
		CHECK(before == 1.0f);
	}
}
