// SPDX-License-Identifier: MIT
// The order in which lanes take the blades of a tile.
#include "core/solver/blade_order.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

using namespace grass;

namespace {

constexpr int BLADES = GRASS_BLADES_PER_TILE;

std::vector<int> of_order(const BladeOrder &p_order) {
	return { p_order.blades, p_order.blades + p_order.count };
}

// Returns how many parts lanes take in all: a group takes those of each number that one of its blades has.
int count_parts(const std::vector<uint8_t> &p_work, const std::vector<int> &p_blades, int p_lanes) {
	int sum = 0;
	for (size_t first = 0; first < p_blades.size(); first += size_t(p_lanes)) {
		std::vector<uint8_t> own;
		for (size_t i = first; i < std::min(first + size_t(p_lanes), p_blades.size()); i++) {
			own.push_back(p_work[size_t(p_blades[i])]);
		}
		std::ranges::sort(own);
		own.erase(std::unique(own.begin(), own.end()), own.end());
		sum += std::accumulate(own.begin(), own.end(), 0);
	}
	return sum;
}

} // namespace

TEST_CASE("blade order: most work first, those with the same in their places, those at rest not at all") {
	std::vector<uint8_t> work(BLADES, WORK_NONE);
	work[5] = WORK_FREE;
	work[9] = 9;
	work[20] = WORK_FREE;
	work[40] = 5;
	work[63] = 9;
	const BladeOrder order = order_blades(work, 8);
	CHECK(of_order(order) == std::vector<int>{ 9, 63, 40, 5, 20 });
	for (int i = order.count; i < BLADES + MOST_LANES; i++) {
		CHECK(order.blades[i] == 20);
	}
}

TEST_CASE("blade order: scattered blades with the same work share lanes") {
	std::vector<uint8_t> work(BLADES, WORK_NONE);
	work[2] = work[21] = work[40] = WORK_FREE;
	CHECK(of_order(order_blades(work, 8)) == std::vector<int>{ 2, 21, 40 });
}

TEST_CASE("blade order: blades stay in their places if no group is saved") {
	std::vector<uint8_t> work(BLADES, WORK_FREE), places(BLADES);
	work[3] = work[62] = WORK_NONE;
	std::iota(places.begin(), places.end(), uint8_t(0));
	for (const int lanes : { 1, 4, 8, 16 }) {
		const BladeOrder order = order_blades(work, lanes);
		CAPTURE(lanes);
		CHECK(order.count == (lanes == 1 ? BLADES - 2 : BLADES));
		CHECK((lanes == 1 || std::equal(places.begin(), places.end(), order.blades)));
	}
}

TEST_CASE("blade order: a tile at rest has none, and a tile of fewer blades only its own") {
	CHECK(order_blades(std::vector<uint8_t>(BLADES, WORK_NONE), 4).count == 0);
	const BladeOrder order = order_blades(std::vector<uint8_t>{ WORK_NONE, 3, WORK_FREE, 3 }, 4);
	CHECK(of_order(order) == std::vector<int>{ 1, 3, 2 });
}

TEST_CASE("blade order: lanes take every blade once, and half of the parts where a seventh of the blades is near a body") {
	std::mt19937 random(7);
	std::uniform_real_distribution<double> share(0.0, 1.0);
	for (const int lanes : { 4, 8, 16 }) {
		int ordered = 0, in_place = 0;
		for (int tile = 0; tile < 200; tile++) {
			std::vector<uint8_t> work;
			for (int b = 0; b < BLADES; b++) {
				const double of_blade = share(random);
				work.push_back(of_blade < 0.75 ? WORK_NONE : of_blade < 0.86 ? WORK_FREE : uint8_t(WORK_FREE + (of_blade < 0.9 ? 4 : 8)));
			}
			std::vector<int> places(BLADES), blades = of_order(order_blades(work, lanes));
			std::iota(places.begin(), places.end(), 0);
			ordered += count_parts(work, blades, lanes);
			in_place += count_parts(work, places, lanes);
			std::ranges::sort(blades);
			CHECK(std::ranges::adjacent_find(blades) == blades.end());
			CHECK(std::ranges::all_of(places,
					[&](int p_blade) { return work[size_t(p_blade)] == WORK_NONE || std::ranges::binary_search(blades, p_blade); }));
		}
		CAPTURE(lanes);
		CHECK(2 * ordered < in_place);
	}
}
