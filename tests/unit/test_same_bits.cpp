// SPDX-License-Identifier: MIT
// The versions of the step compute the same bits: a branch that any lane takes must not touch a lane that alone would not take it.
// The layer `stress` does so for five times as many scenes, `./grass bench stress` for far more.
#include "random_scene.h"
#include "sampled.h"

#include <doctest/doctest.h>

using namespace grass;
using namespace grass::test;

TEST_CASE("In 60 random scenes all lane widths compute what one float does, bit for bit") {
	for (uint32_t seed = 0; int(seed) < sampled(60); seed++) {
		INFO("scene ", seed);
		CHECK(find_difference(seed, seed % 2 ? Range::WILD : Range::EVERYDAY, 30) == "");
	}
}
