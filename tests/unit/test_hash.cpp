// SPDX-License-Identifier: MIT
#include "core/base/hash.h"

#include "core/base/half.h"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <set>
#include <vector>

using namespace grass;

TEST_CASE("hash: golden values, which saved fields and the GPU depend on") {
	CHECK(grass_hash(0u) == 129708002u);
	CHECK(grass_hash(1u) == 2831084092u);
	CHECK(grass_hash(0xffffffffu) == 3861530882u);
	CHECK(grass_tile_start(0, 0, 0) == 920u);
	CHECK(grass_tile_start(7, 11, 42) == 15584u);
	CHECK(grass_tile_hash(7, 11, 42) == 0.24365234375f);
}

TEST_CASE("hash: one bit changed in, about half of the bits changed out") {
	for (uint32_t bit = 0; bit < 32; bit++) {
		int flips = 0;
		for (uint32_t i = 0; i < 4096; i++) {
			flips += std::popcount(grass_hash(i * 977u) ^ grass_hash((i * 977u) ^ (1u << bit)));
		}
		CHECK(std::abs(flips / 4096.0 - 16.0) < 0.6);
	}
}

TEST_CASE("hash: starts are whole strides within the patch, each as frequent as the others") {
	std::vector<int> counts(GRASS_START_COUNT);
	bool all_fit = true;
	for (uint32_t z = 0; z < 1024; z++) {
		for (uint32_t x = 0; x < 1024; x++) {
			const uint32_t start = grass_tile_start(x, z, 5);
			const bool fits = start % GRASS_START_STRIDE == 0 && start / GRASS_START_STRIDE < GRASS_START_COUNT;
			all_fit = all_fit && fits;
			counts[fits ? start / GRASS_START_STRIDE : 0]++;
		}
	}
	CHECK(all_fit);
	const double expected = 1024.0 * 1024.0 / GRASS_START_COUNT;
	double chi_squared = 0.0;
	for (const int count : counts) {
		chi_squared += (count - expected) * (count - expected) / expected;
	}
	// 2,036 degrees of freedom: mean 2,036, deviation 64.
	CHECK(chi_squared > 2036 - 6 * 64);
	CHECK(chi_squared < 2036 + 6 * 64);
}

TEST_CASE("hash: a tile starts unlike its eight neighbours, and elsewhere under another seed") {
	int alike = 0, same_under_seed = 0;
	for (uint32_t z = 1; z < 200; z++) {
		for (uint32_t x = 1; x < 200; x++) {
			const uint32_t start = grass_tile_start(x, z, 9);
			for (uint32_t i = 0; i < 9; i++) {
				alike += i != 4 && grass_tile_start(x + i % 3 - 1, z + i / 3 - 1, 9) == start ? 1 : 0;
			}
			same_under_seed += grass_tile_start(x, z, 10) == start ? 1 : 0;
		}
	}
	CHECK(alike == 0);
	CHECK(same_under_seed < 199 * 199 / 510 * 2);
}

TEST_CASE("hash: a tile's number is even over 0 to 1, exact as a half, unlike its neighbours'") {
	double sum = 0.0, product = 0.0;
	bool all_fit = true;
	for (uint32_t z = 0; z < 512; z++) {
		for (uint32_t x = 0; x < 512; x++) {
			const float value = grass_tile_hash(x, z, 1);
			all_fit = all_fit && value >= 0.0f && value < 1.0f && half_to_float(float_to_half(value)) == value;
			sum += value;
			product += (value - 0.5) * (grass_tile_hash(x + 1, z, 1) - 0.5);
		}
	}
	const double count = 512.0 * 512.0;
	CHECK(all_fit);
	CHECK(std::abs(sum / count - 0.5) < 0.005);
	CHECK(std::abs(product / count * 12.0) < 0.02); // correlation
}

TEST_CASE("hash: of each 8 by 8 tiles every one has a turn of its own, in another order elsewhere and under another seed") {
	int same_elsewhere = 0, same_under_seed = 0;
	for (uint32_t block = 0; block < 100; block++) {
		const uint32_t x0 = 8 * (block % 10), z0 = 8 * (block / 10);
		uint64_t turns = 0;
		for (uint32_t i = 0; i < 64; i++) {
			const uint32_t turn = grass_tile_turn(x0 + i % 8, z0 + i / 8, 3);
			REQUIRE(turn < GRASS_TURNS);
			turns |= uint64_t(1) << turn;
		}
		CHECK(turns == ~uint64_t(0));
		same_elsewhere += grass_tile_turn(x0, z0, 3) == grass_tile_turn(0, 0, 3) ? 1 : 0;
		same_under_seed += grass_tile_turn(x0, z0, 3) == grass_tile_turn(x0, z0, 4) ? 1 : 0;
	}
	CHECK(same_elsewhere < 10);
	CHECK(same_under_seed < 10);
}

TEST_CASE("hash: tiles of the first turns are an even sample: each 4 by 4 and each 2 by 2 tiles has its share") {
	for (const auto &[side, turns] : { std::pair(4u, 16u), std::pair(2u, 16u), std::pair(4u, 32u), std::pair(2u, 48u) }) {
		const uint32_t expected = side * side * turns / GRASS_TURNS;
		for (uint32_t z0 = 0; z0 < 64; z0 += side) {
			for (uint32_t x0 = 0; x0 < 64; x0 += side) {
				uint32_t count = 0;
				for (uint32_t i = 0; i < side * side; i++) {
					count += grass_tile_turn(x0 + i % side, z0 + i / side, 8) < turns ? 1 : 0;
				}
				REQUIRE(count == expected);
			}
		}
	}
}
