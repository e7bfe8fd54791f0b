// SPDX-License-Identifier: MIT
#include "core/blades/blade.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace grass;

namespace {
const glsl::vec2 SIZE(32.0f, 20.0f);

float border(float p_x, float p_z, float p_fade, float p_waver = 0.0f) {
	return glsl::grass_border({ p_x, p_z }, SIZE, p_fade, p_waver);
}

// Returns how far from a long side half of the grass grows, metres. p_x: along that side.
double line_at(float p_x, float p_fade, float p_waver) {
	for (int step = 1; step < 1000; step++) {
		const float inside = float(step) * p_fade / 1000.0f;
		if (border(p_x, 10.0f - inside, p_fade, p_waver) >= 0.5f) {
			return inside;
		}
	}
	return p_fade;
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

TEST_CASE("border: a waver moves the line where grass begins, within the border only [Eq B6]") {
	const float fade = 2.0f;
	double least = fade, most = 0.0;
	int crossings = 0;
	double before = 0.0;
	for (int step = 0; step <= 240; step++) {
		const float x = 0.1f * float(step) - 12.0f;
		CHECK(line_at(x, fade, 0.0f) == doctest::Approx(0.5 * fade).epsilon(0.01));
		const double line = line_at(x, fade, 1.0f);
		least = std::min(least, line);
		most = std::max(most, line);
		crossings += (line - 0.55 * fade) * before < 0.0;
		before = line - 0.55 * fade;
		CHECK(std::abs(line_at(x + 0.01f, fade, 1.0f) - line) < 0.1); // no jumps
		CHECK(border(x, 10.0f - fade, fade, 1.0f) == 1.0f);
		CHECK(border(x, 10.0f, fade, 1.0f) == 0.0f);
		CHECK(border(x, 0.0f, fade, 1.0f) == 1.0f);
	}
	CHECK(most - least > 0.5 * fade);
	CHECK(crossings > 4); // bays, not one slope
}
