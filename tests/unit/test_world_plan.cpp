// SPDX-License-Identifier: MIT
// Which plots of a world are in memory: near the eyes, nearest first, within a budget, without back and forth.
#include "core/world/world_plan.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace grass;

namespace {

constexpr size_t MB = 1 << 20;

const WorldGrid &grid() {
	static const WorldGrid made({ 16384.0, 16384.0 }, 256.0);
	return made;
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
	const WorldPlan plan = WorldPlanner().plan(grid(), { &eye, 1 }, {}, 100 * MB);
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

TEST_CASE("world: several eyes, one of them at the world's edge") {
	const WorldEye eyes[] = { { { 8190.0, 0.0 }, 100.0 }, { { -4000.0, 3000.0 }, 10.0 } };
	const WorldPlan plan = WorldPlanner().plan(grid(), eyes, {}, 100 * MB);
	CHECK(has(plan.wanted, { 31, 0 }));
	CHECK_FALSE(has(plan.wanted, { 32, 0 }));
	CHECK(has(plan.wanted, grid().at(eyes[1].place)));
	CHECK(std::set(plan.wanted.begin(), plan.wanted.end()).size() == plan.wanted.size()); // each once
}

TEST_CASE("world: the budget holds the nearest, and tells how far it reaches") {
	WorldPlanner planner;
	planner.learn({ 0, 0 }, 10 * MB);
	const WorldEye eye{ { 128.0, 128.0 }, 600.0 };
	const WorldPlan plan = planner.plan(grid(), { &eye, 1 }, {}, 55 * MB);
	CHECK(plan.wanted.size() == 5);
	CHECK(plan.is_short);
	CHECK(plan.reach == doctest::Approx(std::sqrt(2.0) * 128.0)); // one beside each side fits, none of the corners
	for (const PlotKey &key : plan.wanted) {
		CHECK(std::abs(key.x) + std::abs(key.z) <= 1);
	}
	CHECK(planner.plan(grid(), { &eye, 1 }, {}, 5 * MB).wanted.empty()); // a budget is a promise
}

TEST_CASE("world: the farthest leaves first, and what lingers leaves where there is no room") {
	WorldPlanner planner;
	planner.learn({ 0, 0 }, 10 * MB);
	const WorldEye eye{ { 128.0, 128.0 }, 10.0 };
	const PlotKey loaded[] = { { 2, 0 }, { 0, 0 }, { -1, 0 }, { 9, 0 } };
	SUBCASE("distance") {
		const WorldEye wide{ eye.place, 100.0 };
		const WorldPlan plan = planner.plan(grid(), { &wide, 1 }, loaded, 100 * MB);
		REQUIRE(plan.leaving.size() == 2);
		CHECK(std::set(plan.leaving.begin(), plan.leaving.end()) == std::set<PlotKey>{ { 9, 0 }, { 2, 0 } });
	}
	SUBCASE("lingering") {
		const WorldEye beside{ { 300.0, 128.0 }, 10.0 }; // 44 m out of (0, 0)
		const PlotKey two[] = { { 0, 0 }, { 1, 0 } };
		CHECK(planner.plan(grid(), { &beside, 1 }, two, 20 * MB).leaving.empty());
		CHECK(planner.plan(grid(), { &beside, 1 }, two, 19 * MB).leaving == std::vector<PlotKey>{ { 0, 0 } });
		const WorldEye farther{ { 256.0 + 10.0 + WorldPlanner::LINGER + 1.0, 128.0 }, 10.0 };
		CHECK(planner.plan(grid(), { &farther, 1 }, two, 100 * MB).leaving == std::vector<PlotKey>{ { 0, 0 } });
	}
	SUBCASE("nobody looks") {
		CHECK(planner.plan(grid(), {}, loaded, 100 * MB).leaving.size() == 4);
	}
}

TEST_CASE("world: a plan that is followed is the same plan again") {
	WorldPlanner planner;
	const WorldEye eye{ { 128.0, 128.0 }, 900.0 };
	std::vector<PlotKey> loaded;
	for (int round = 0; round < 200; round++) { // plots of uneven size, learned as they come
		const WorldPlan plan = planner.plan(grid(), { &eye, 1 }, loaded, 60 * MB);
		if (!plan.leaving.empty()) {
			std::erase(loaded, plan.leaving.front());
			continue;
		}
		const auto next = std::ranges::find_if(plan.wanted, [&](const PlotKey &p_key) { return !has(loaded, p_key); });
		if (next == plan.wanted.end()) {
			break;
		}
		loaded.push_back(*next);
		planner.learn(*next, size_t(1 + (std::abs(next->x * 7 + next->z * 3) % 5)) * 4 * MB);
	}
	const WorldPlan plan = planner.plan(grid(), { &eye, 1 }, loaded, 60 * MB);
	CHECK(plan.leaving.empty());
	CHECK(std::ranges::all_of(plan.wanted, [&](const PlotKey &p_key) { return has(loaded, p_key); }));
	size_t bytes = 0;
	for (const PlotKey &key : loaded) {
		bytes += planner.expected(key);
	}
	CHECK(bytes <= 60 * MB);
	CHECK(loaded.size() >= 3); // so many of the largest fit
}

TEST_CASE("world: eyes that are not numbers want nothing") {
	const WorldEye eyes[] = { { { std::nan(""), 0.0 }, 100.0 }, { { 0.0, std::numeric_limits<double>::infinity() }, 100.0 } };
	CHECK(WorldPlanner().plan(grid(), eyes, {}, 100 * MB).wanted.empty());
}
