// SPDX-License-Identifier: MIT
#include "core/base/half.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

using namespace grass;

namespace {

// What a half means, from its definition.
double decode(uint16_t p_half) {
	const int exponent = p_half >> 10 & 31, fraction = p_half & 1023;
	const double magnitude = exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
	return p_half & 0x8000 ? -magnitude : magnitude;
}

bool is_nan(uint16_t p_half) {
	return (p_half & 0x7c00) == 0x7c00 && (p_half & 0x3ff) != 0;
}
bool is_finite(uint16_t p_half) {
	return (p_half & 0x7c00) != 0x7c00;
}

} // namespace

static_assert(float_to_half(1.0f) == 0x3c00 && half_to_float(0xc000) == -2.0f);

TEST_CASE("half: all 65,536 mean what the standard says and survive the way to float and back") {
	int wrong = 0;
	for (uint32_t bits = 0; bits < 65536; bits++) {
		const uint16_t half = uint16_t(bits);
		const float value = half_to_float(half);
		const bool back = float_to_half(value) == half;
		if (is_nan(half)) {
			wrong += std::isnan(value) && is_nan(float_to_half(value)) ? 0 : 1;
		} else if (is_finite(half)) {
			wrong += double(value) == decode(half) && std::signbit(value) == (half >= 0x8000) && back ? 0 : 1;
		} else {
			wrong += std::isinf(value) && std::signbit(value) == (half >= 0x8000) && back ? 0 : 1;
		}
	}
	CHECK(wrong == 0);
}

TEST_CASE("half: between two neighbours the nearer wins, halfway the even one") {
	int wrong = 0;
	for (uint32_t bits = 0; bits < 0x7bff; bits++) {
		const uint16_t low = uint16_t(bits), high = uint16_t(bits + 1);
		const float middle = float(0.5 * (decode(low) + decode(high))); // exact: 12 bits
		const uint16_t even = low % 2 == 0 ? low : high;
		for (const uint16_t sign : { uint16_t(0), uint16_t(0x8000) }) {
			const float side = sign ? -1.0f : 1.0f;
			wrong += float_to_half(side * middle) == (even | sign) ? 0 : 1;
			wrong += float_to_half(side * std::nextafter(middle, 0.0f)) == (low | sign) ? 0 : 1;
			wrong += float_to_half(side * std::nextafter(middle, 1e9f)) == (high | sign) ? 0 : 1;
		}
	}
	CHECK(wrong == 0);
}

TEST_CASE("half: the ends of the range") {
	const float infinity = std::numeric_limits<float>::infinity();
	CHECK(float_to_half(65504.0f) == 0x7bff);
	CHECK(float_to_half(std::nextafter(65520.0f, 0.0f)) == 0x7bff);
	CHECK(float_to_half(65520.0f) == 0x7c00);
	CHECK(float_to_half(-3e38f) == 0xfc00);
	CHECK(float_to_half(infinity) == 0x7c00);
	CHECK(float_to_half(-infinity) == 0xfc00);
	CHECK(is_nan(float_to_half(std::numeric_limits<float>::quiet_NaN())));
	CHECK(float_to_half(0x1p-24f) == 1);
	CHECK(float_to_half(0x1p-25f) == 0);
	CHECK(float_to_half(std::nextafter(0x1p-25f, 1.0f)) == 1);
	CHECK(float_to_half(-0x1p-26f) == 0x8000);
	CHECK(float_to_half(std::numeric_limits<float>::denorm_min()) == 0);
	CHECK(float_to_half(-0.0f) == 0x8000);
	CHECK(half_to_float(float_to_half(0.1f)) == 0.0999755859375f);
}
