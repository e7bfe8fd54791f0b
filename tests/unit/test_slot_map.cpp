// SPDX-License-Identifier: MIT
// The maps from tiles to slots and to places, against the standard library's.
#include "core/tiles/slot_map.h"
#include "core/tiles/tile_map.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>

using namespace grass;

TEST_CASE("slot map: the same as a std::map through 20,000 insertions and erasures, also where every square has one tile") {
	for (const int spread : { 1, 4, 8192 / 40 }) { // tiles lie close together, one a square, all over the largest field
		SlotMap map;
		map.reserve(300);
		const size_t memory = map.get_memory_usage();
		std::map<std::pair<int, int>, int> expected;
		std::mt19937 random(7);
		std::uniform_int_distribution<int> place(0, 39), slot(0, 16383);
		for (int i = 0; i < 20000; i++) {
			const int x = place(random) * spread, z = place(random) * spread;
			const auto found = expected.find({ x, z });
			REQUIRE(map.find(x, z) == (found == expected.end() ? SlotMap::NONE : found->second));
			if (found != expected.end()) {
				map.erase(x, z);
				expected.erase(found);
			} else if (expected.size() < 300) {
				expected[{ x, z }] = slot(random);
				map.insert(x, z, expected[{ x, z }]);
			} else {
				map.erase(x, z); // is not in it
			}
		}
		for (int z = 0; z < 40; z++) {
			for (int x = 0; x < 40; x++) {
				const auto found = expected.find({ x * spread, z * spread });
				const int slot_there = found == expected.end() ? SlotMap::NONE : found->second;
				REQUIRE(map.find(x * spread, z * spread) == slot_there);
				REQUIRE(map.find_square(x * spread, z * spread).at(x * spread, z * spread) == slot_there);
			}
		}
		CHECK(expected.size() == 300);
		CHECK(map.get_memory_usage() <= memory + 1024 * 8); // two entries a square, in powers of two
	}
}

TEST_CASE("slot map: the squares of a range hold all of its tiles, and no range has none") {
	CHECK(SlotMap::squares_of({ 3, 9, 4, 5 }) == TileRange{ 0, 3, 1, 2 });
	CHECK(SlotMap::squares_of({ 8, 12, 0, 8 }) == TileRange{ 2, 3, 0, 2 });
	CHECK(SlotMap::squares_of({}).count() == 0);
}

TEST_CASE("tile map: the same as a std::map while it grows from nothing to 10,000 tiles and is emptied again") {
	TileMap map;
	std::map<int, int> expected;
	std::mt19937 random(3);
	std::uniform_int_distribution<int> tile(0, (1 << 26) - 1);
	const size_t small = map.get_memory_usage();
	while (expected.size() < 10000) {
		const int index = tile(random);
		if (expected.emplace(index, int(expected.size())).second) {
			REQUIRE(map.find(index) == TileMap::NONE);
			map.insert(index, int(expected.size()) - 1);
		}
	}
	CHECK(map.get_memory_usage() > small);
	CHECK(std::all_of(expected.begin(), expected.end(), [&](const auto &p_entry) { return map.find(p_entry.first) == p_entry.second; }));
	size_t left = expected.size();
	for (const auto &[index, number] : expected) {
		map.erase(index);
		REQUIRE(map.find(index) == TileMap::NONE);
		left--;
		if (left % 1000 == 0) { // those that are left are still found
			REQUIRE(std::all_of(expected.upper_bound(index), expected.end(),
					[&](const auto &p_entry) { return map.find(p_entry.first) == p_entry.second; }));
		}
	}
	const size_t memory = map.get_memory_usage();
	map.clear();
	CHECK(map.get_memory_usage() <= memory);
}
