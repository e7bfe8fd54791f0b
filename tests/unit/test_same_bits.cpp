// SPDX-License-Identifier: MIT
// The versions of the step compute the same bits: a branch that any lane takes must not touch a lane that alone would not take it.
// `./grass bench stress` does so for far more scenes.
#include "random_scene.h"
#include "sampled.h"

#include <doctest/doctest.h>

using namespace grass;
using namespace grass::test;

TEST_CASE("In 200 random scenes all lane widths compute what one float does, bit for bit") {
	for (uint32_t seed = 0; int(seed) < sampled(200); seed++) {
		INFO("scene ", seed);
		CHECK(find_difference(seed, seed % 2 ? Range::WILD : Range::EVERYDAY, 30) == "");
	}
}
