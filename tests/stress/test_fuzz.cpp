// SPDX-License-Identifier: MIT
// The fuzzer's scenes, from random bytes: the seed of a failure repeats it.
#include "fuzz_scene.h"
#include "stress.h"

#include <doctest/doctest.h>

using namespace grass::test;

TEST_CASE("fuzz: scenes out of random bytes, with what no user should set and no patch holds") {
	check_each(sized(500, 200000), [](int p_seed) {
		std::mt19937 random{ uint32_t(p_seed) };
		std::vector<uint8_t> bytes(512);
		for (uint8_t &byte : bytes) {
			byte = uint8_t(random());
		}
		return play_bytes(bytes);
	});
}
