// SPDX-License-Identifier: MIT
#include "core/blades/blade.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace grass;

namespace {
const glsl::vec2 SIZE(32.0f, 20.0f);

float border(float p_x, float p_z, float p_fade) {
	return glsl::grass_border({ p_x, p_z }, SIZE, p_fade);
}
} // namespace

TEST_CASE("border: rises from 0 at every side to 1 inside, by its width [Eq B6]") {
	for (const float side : { -1.0f, 1.0f }) {
		CHECK(border(side * 16.0f, 0.0f, 2.0f) == 0.0f);
		CHECK(border(side * 15.0f, 3.0f, 2.0f) == doctest::Approx(0.5));
		CHECK(border(side * 14.0f, 3.0f, 2.0f) == 1.0f);
		CHECK(border(5.0f, side * 10.0f, 2.0f) == 0.0f);
		CHECK(border(5.0f, side * 9.5f, 2.0f) == doctest::Approx(0.25));
		CHECK(border(5.0f, side * 8.0f, 2.0f) == 1.0f);
	}
	CHECK(border(17.0f, 0.0f, 2.0f) == 0.0f); // outside
}

TEST_CASE("border: corners are round [Eq B6]") {
	CHECK(border(15.0f, 9.0f, 2.0f) == doctest::Approx(1.0 - std::sqrt(2.0) / 2.0));
	CHECK(border(15.9f, 9.9f, 2.0f) == 0.0f);
}

TEST_CASE("border: is at most an eighth of the shorter side, and 0 is none [Eq B6]") {
	CHECK(border(0.0f, 10.0f - 2.5f, 10.0f) == 1.0f);
	CHECK(border(0.0f, 10.0f - 1.25f, 10.0f) == doctest::Approx(0.5));
	CHECK(border(15.99f, 9.99f, 0.0f) == 1.0f);
}
