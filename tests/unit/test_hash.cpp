// SPDX-License-Identifier: MIT
#include "core/hash.h"

#include "core/half.h"

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
			all_fit = all_fit && value >= 0.0f && value < 1.0f && round_to_half(value) == value;
			sum += value;
			product += (value - 0.5) * (grass_tile_hash(x + 1, z, 1) - 0.5);
		}
	}
	const double count = 512.0 * 512.0;
	CHECK(all_fit);
	CHECK(std::abs(sum / count - 0.5) < 0.005);
	CHECK(std::abs(product / count * 12.0) < 0.02); // correlation
}
