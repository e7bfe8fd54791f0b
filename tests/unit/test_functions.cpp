// SPDX-License-Identifier: MIT
#include "core/base/functions.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace grass;

TEST_CASE("functions: sine and cosine are right without the C library") {
	double worst = 0.0;
	for (double angle = -40.0; angle < 40.0; angle += 0.0137) {
		worst = std::max({ worst, std::abs(sine(angle) - std::sin(angle)), std::abs(cosine(angle) - std::cos(angle)) });
	}
	CHECK(worst < 1e-12);
}

TEST_CASE("functions: the exponential and its two halves are right without the C library") {
	double worst = 0.0; // shares
	for (double x = -50.0; x < 50.0; x += 0.00713) {
		const auto compare = [&](double p_found, double p_wanted) { worst = std::max(worst, std::abs(p_found / p_wanted - 1.0)); };
		compare(exponential(x), std::exp(x));
		compare(hyperbolic_sine(x * 0.1), std::sinh(x * 0.1));
		compare(hyperbolic_cosine(x * 0.1), std::cosh(x * 0.1));
	}
	CHECK(worst < 1e-13);
	CHECK(exponential(0.0) == 1.0);
	CHECK(exponential(-1e6) == 0.0);
	CHECK(std::isinf(exponential(1e6)));
	CHECK(hyperbolic_sine(1e-9) == doctest::Approx(1e-9).epsilon(1e-15));
}
