// SPDX-License-Identifier: MIT
// Which plots of a world are in memory: near the eyes, nearest first, within a budget, without back and forth.
#include "core/world/world_plan.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace grass;

namespace {

constexpr size_t MB = 1 << 20;

const WorldGrid &grid() {
	static const WorldGrid made({ 16384.0, 16384.0 }, 256.0);
	return made;
}

// Needs without anything held back.
WorldNeeds needs(std::span<const WorldEye> p_eyes, std::span<const LoadedPlot> p_loaded, size_t p_budget) {
	return { p_eyes, p_loaded, p_budget, 0 };
}

// Of so many bytes each.
std::vector<LoadedPlot> loaded_plots(std::initializer_list<PlotKey> p_keys, size_t p_bytes) {
	std::vector<LoadedPlot> plots;
	for (const PlotKey &key : p_keys) {
		plots.push_back({ key, p_bytes, 0 });
	}
	return plots;
}

WorldPlanner planner_of(size_t p_bytes) {
	WorldPlanner planner;
	planner.learn(loaded_plots({ { 0, 0 } }, p_bytes));
	return planner;
}

// Spread evenly from p_from to p_to along both axes.
std::vector<WorldEye> crowd(size_t p_count, double p_from, double p_to, double p_radius, unsigned p_seed) {
	std::mt19937 random(p_seed);
	std::uniform_real_distribution<double> place(p_from, p_to);
	std::vector<WorldEye> eyes;
	for (size_t i = 0; i < p_count; i++) {
		const double x = place(random);
		eyes.push_back({ { x, place(random) }, p_radius });
	}
	return eyes;
}

bool has(const std::vector<PlotKey> &p_keys, const PlotKey &p_key) {
	return std::ranges::find(p_keys, p_key) != p_keys.end();
}

} // namespace

TEST_CASE("world: places and plots of a grid") {
	CHECK(grid().at({ 0.0, 0.0 }) == PlotKey{ 0, 0 });
	CHECK(grid().at({ -0.001, 255.9 }) == PlotKey{ -1, 0 });
	CHECK(grid().centre({ -1, 2 }) == Eigen::Vector2d(-128.0, 640.0));
	CHECK(grid().has({ -32, 31 }));
	CHECK_FALSE(grid().has({ 32, 0 }));
	CHECK_FALSE(grid().has({ 0, -33 }));
	CHECK_FALSE(grid().has(grid().at({ 1e300, -1e300 })));
	CHECK(grid().distance({ 0, 0 }, { 100.0, 20.0 }) == 0.0);
	CHECK(grid().distance({ 0, 0 }, { -3.0, 260.0 }) == doctest::Approx(5.0));
	CHECK(grid().distance({ 0, 0 }, { -100.0, -50.0 }, { 400.0, 300.0 }) == doctest::Approx(0.0)); // across
	CHECK(grid().distance({ 0, 0 }, { -7.0, -400.0 }, { -7.0, 9000.0 }) == doctest::Approx(7.0));
	CHECK(grid().distance({ 0, 0 }, { -3.0, 260.0 }, { -3.0, 260.0 }) == doctest::Approx(5.0));
	CHECK(WorldGrid({ 300.0, 100.0 }, 256.0).has({ -1, 0 })); // rounded up
}

TEST_CASE("world: the plots within the radius are wanted, nearest first") {
	const WorldEye eye{ { 10.0, 10.0 }, 300.0 };
	const WorldPlan plan = WorldPlanner().plan(grid(), needs({ &eye, 1 }, {}, 100 * MB));
	REQUIRE_FALSE(plan.wanted.empty());
	CHECK(plan.wanted.front() == PlotKey{ 0, 0 });
	for (size_t i = 0; i < plan.wanted.size(); i++) {
		CHECK(grid().distance(plan.wanted[i], eye.place) <= eye.radius);
		CHECK((i == 0 || grid().distance(plan.wanted[i - 1], eye.place) <= grid().distance(plan.wanted[i], eye.place)));
	}
	size_t within = 0;
	for (int z = -32; z < 32; z++) {
		for (int x = -32; x < 32; x++) {
			within += grid().distance({ x, z }, eye.place) <= eye.radius ? 1 : 0;
		}
	}
	CHECK(plan.wanted.size() == within);
	CHECK_FALSE(plan.is_short);
}

TEST_CASE("world: of many eyes each plot has the distance to the nearest") {
	for (unsigned seed = 1; seed <= 6; seed++) {
		const double plot = seed % 2 == 0 ? 256.0 : 64.0, radius = 40.0 + 50.0 * seed;
		const WorldGrid small({ 2048.0, 1536.0 }, plot);
		std::vector<WorldEye> eyes = crowd(40, -900.0, 900.0, plot > radius ? radius : 0.9 * plot, seed);
		eyes.push_back({ { 17.0 * seed, -33.0 }, radius });
		const WorldPlan plan = WorldPlanner().plan(small, needs(eyes, {}, 100 * MB));
		std::set<PlotKey> expected;
		for (int z = -40; z < 40; z++) {
			for (int x = -40; x < 40; x++) {
				for (const WorldEye &eye : eyes) {
					if (small.has({ x, z }) && small.distance({ x, z }, eye.place) <= eye.radius) {
						expected.insert({ x, z });
					}
				}
			}
		}
		CHECK(std::set(plan.wanted.begin(), plan.wanted.end()) == expected);
		CHECK(plan.wanted.size() == expected.size()); // each once
	}
}

TEST_CASE("world: several eyes, one of them at the world's edge") {
	const WorldEye eyes[] = { { { 8190.0, 0.0 }, 100.0 }, { { -4000.0, 3000.0 }, 10.0 } };
	const WorldPlan plan = WorldPlanner().plan(grid(), needs(eyes, {}, 100 * MB));
	CHECK(has(plan.wanted, { 31, 0 }));
	CHECK_FALSE(has(plan.wanted, { 32, 0 }));
	CHECK(has(plan.wanted, grid().at(eyes[1].place)));
	CHECK(std::set(plan.wanted.begin(), plan.wanted.end()).size() == plan.wanted.size()); // each once
}

TEST_CASE("world: the budget holds the nearest, and tells how far it reaches") {
	const WorldPlanner planner = planner_of(10 * MB);
	const WorldEye eye{ { 128.0, 128.0 }, 600.0 };
	const WorldPlan plan = planner.plan(grid(), needs({ &eye, 1 }, {}, 55 * MB));
	CHECK(plan.wanted.size() == 5);
	CHECK(plan.is_short);
	CHECK(plan.reach == doctest::Approx(std::sqrt(2.0) * 128.0)); // one beside each side fits, none of the corners
	for (const PlotKey &key : plan.wanted) {
		CHECK(std::abs(key.x) + std::abs(key.z) <= 1);
	}
	CHECK(plan.missing == 0);
}

TEST_CASE("world: plots under cameras and bodies are held, whatever the budget is") {
	const WorldPlanner planner = planner_of(10 * MB);
	const WorldEye eyes[] = { { { 100.0, 128.0 }, 600.0 }, { { 3000.0, -500.0 }, 32.0 }, { { 3010.0, -510.0 }, 32.0 } };
	for (const size_t budget : { 0 * MB, 5 * MB, 19 * MB }) {
		const WorldPlan plan = planner.plan(grid(), needs(eyes, {}, budget));
		CHECK(plan.wanted == std::vector<PlotKey>{ { 0, 0 }, { 11, -2 } });
		CHECK(plan.under_eyes == 2);
		CHECK(plan.missing == 20 * MB - budget);
		CHECK(plan.is_short);
		CHECK(plan.reach == 0.0);
	}
	CHECK(planner.plan(grid(), needs(eyes, {}, 31 * MB)).wanted.size() == 3);
}

TEST_CASE("world: a plot dearer than the others keeps nobody away once it is left") {
	const WorldEye eye{ { 128.0, 128.0 }, 300.0 }, far{ { 5000.0, 128.0 }, 300.0 };
	WorldPlanner planner;
	std::vector<LoadedPlot> loaded = loaded_plots({ { 0, 0 }, { 1, 0 }, { -1, 0 } }, 10 * MB);
	loaded.front().rest = 2000 * MB;
	planner.learn(loaded);
	CHECK(planner.get_typical() == 10 * MB);
	CHECK(planner.plan(grid(), needs({ &eye, 1 }, loaded, 100 * MB)).wanted == std::vector<PlotKey>{ { 0, 0 } }); // it takes all there is
	CHECK(planner.plan(grid(), needs({ &far, 1 }, {}, 100 * MB)).wanted.size() == 9);
	const WorldEye beside{ { 384.0, 128.0 }, 200.0 };
	const WorldPlan plan = planner.plan(grid(), needs({ &beside, 1 }, {}, 100 * MB));
	CHECK_FALSE(has(plan.wanted, { 0, 0 }));
	CHECK(plan.wanted.size() == 8); // the others around it
	loaded.front().rest = 10 * MB; // what made it dear is gone
	planner.learn(loaded);
	CHECK(planner.plan(grid(), needs({ &eye, 1 }, loaded, 100 * MB)).wanted.size() == 9);
}

TEST_CASE("world: a pool is paid for before farther plots, as long as it exists") {
	const WorldPlanner planner = planner_of(10 * MB);
	const WorldEye eye{ { 128.0, 128.0 }, 300.0 };
	LoadedPlot plot{ { 0, 0 }, 10 * MB, 64 * MB };
	const auto count_wanted = [&](size_t p_budget) {
		return planner.plan(grid(), needs({ &eye, 1 }, { &plot, 1 }, p_budget)).wanted.size();
	};
	CHECK(count_wanted(150 * MB) == 1 + 7); // 76 MB are left
	CHECK(count_wanted(80 * MB) == 1);
	CHECK(planner.plan(grid(), needs({ &eye, 1 }, { &plot, 1 }, 60 * MB)).missing == 14 * MB);
	plot.pool = 0;
	CHECK(count_wanted(150 * MB) == 9);
	CHECK(count_wanted(80 * MB) == 8);
}

TEST_CASE("world: the farthest leaves first, and what lingers leaves where there is no room") {
	const WorldPlanner planner = planner_of(10 * MB);
	const WorldEye eye{ { 128.0, 128.0 }, 10.0 };
	const std::vector<LoadedPlot> loaded = loaded_plots({ { 2, 0 }, { 0, 0 }, { -1, 0 }, { 9, 0 } }, 10 * MB);
	SUBCASE("distance") {
		const WorldEye wide{ eye.place, 100.0 };
		const WorldPlan plan = planner.plan(grid(), needs({ &wide, 1 }, loaded, 100 * MB));
		REQUIRE(plan.leaving.size() == 2);
		CHECK(std::set(plan.leaving.begin(), plan.leaving.end()) == std::set<PlotKey>{ { 9, 0 }, { 2, 0 } });
	}
	SUBCASE("lingering") {
		const WorldEye beside{ { 300.0, 128.0 }, 10.0 }; // 44 m out of (0, 0)
		const std::vector<LoadedPlot> two = loaded_plots({ { 0, 0 }, { 1, 0 } }, 10 * MB);
		CHECK(planner.plan(grid(), needs({ &beside, 1 }, two, 20 * MB)).leaving.empty());
		CHECK(planner.plan(grid(), needs({ &beside, 1 }, two, 19 * MB)).leaving == std::vector<PlotKey>{ { 0, 0 } });
		const WorldEye farther{ { 256.0 + 10.0 + WorldPlanner::LINGER + 1.0, 128.0 }, 10.0 };
		CHECK(planner.plan(grid(), needs({ &farther, 1 }, two, 100 * MB)).leaving == std::vector<PlotKey>{ { 0, 0 } });
	}
	SUBCASE("nobody looks") {
		CHECK(planner.plan(grid(), needs({}, loaded, 100 * MB)).leaving.size() == 4);
	}
}

TEST_CASE("world: a plan that is followed is the same plan again") {
	WorldPlanner planner;
	const WorldEye eye{ { 128.0, 128.0 }, 900.0 };
	std::vector<LoadedPlot> loaded;
	const auto is_loaded = [&](const PlotKey &p_key) {
		return std::ranges::any_of(loaded, [&](const LoadedPlot &p_plot) { return p_plot.key == p_key; });
	};
	for (int round = 0; round < 200; round++) { // plots of uneven size, learned as they come
		planner.learn(loaded);
		const WorldPlan plan = planner.plan(grid(), needs({ &eye, 1 }, loaded, 60 * MB));
		if (!plan.leaving.empty()) {
			std::erase_if(loaded, [&](const LoadedPlot &p_plot) { return p_plot.key == plan.leaving.front(); });
			continue;
		}
		const auto next = std::ranges::find_if(plan.wanted, [&](const PlotKey &p_key) { return !is_loaded(p_key); });
		if (next == plan.wanted.end()) {
			break;
		}
		loaded.push_back({ *next, size_t(1 + (std::abs(next->x * 7 + next->z * 3) % 5)) * 4 * MB, 0 });
	}
	planner.learn(loaded);
	const WorldPlan plan = planner.plan(grid(), needs({ &eye, 1 }, loaded, 60 * MB));
	CHECK(plan.leaving.empty());
	CHECK(std::ranges::all_of(plan.wanted, is_loaded));
	size_t bytes = 0;
	for (const LoadedPlot &plot : loaded) {
		bytes += plot.rest;
	}
	CHECK(bytes <= 60 * MB);
	CHECK(loaded.size() >= 3); // so many of the largest fit
}

TEST_CASE("world: eyes that are not numbers want nothing") {
	const WorldEye eyes[] = { { { std::nan(""), 0.0 }, 100.0 }, { { 0.0, std::numeric_limits<double>::infinity() }, 100.0 } };
	CHECK(WorldPlanner().plan(grid(), needs(eyes, {}, 100 * MB)).wanted.empty());
}

// Counted, not timed. A plan that compares each eye with each plot takes millions of distances for 1,000 bodies.
TEST_CASE("world: a plan's work grows with the bodies, or with the plots that the budget holds, not with both") {
	const WorldPlanner planner = planner_of(MB);
	for (const double width : { 50.0, 400.0, 3000.0, 8000.0 }) {
		for (const size_t count : { 200, 1000, 4200 }) {
			std::vector<WorldEye> eyes = crowd(count, -width, width, 32.0, unsigned(count));
			eyes.insert(eyes.begin(), { { 5.0, 7.0 }, 400.0 });
			const WorldPlan plan = planner.plan(grid(), needs(eyes, {}, 500 * MB));
			INFO(count << " bodies on " << 2.0 * width << " m: " << plan.tests << " tests, " << plan.wanted.size() << " plots");
			CHECK(plan.tests <= 100 + 4 * int64_t(count));
			CHECK(plan.wanted.size() >= std::min<size_t>(count / 4, 4));
		}
	}
	const WorldGrid fine({ 16384.0, 16384.0 }, 64.0);
	const WorldEye wide{ { 5.0, 7.0 }, 8192.0 }; // 65,536 plots
	const WorldPlan plan = planner.plan(fine, needs({ &wide, 1 }, {}, 100 * MB));
	CHECK(plan.wanted.size() == 100);
	CHECK(plan.tests < 500);
}
