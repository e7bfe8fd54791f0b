// SPDX-License-Identifier: MIT
// The versions of the step compute the same bits: a branch that any lane takes must not touch a lane that alone would not take it.
// The layer `stress` does so for five times as many scenes, `./grass bench stress` for far more.
#include "random_scene.h"
#include "sampled.h"

#include <doctest/doctest.h>

#include <bit>

using namespace grass;
using namespace grass::test;

namespace {

uint64_t bits_of(double p_value) {
	return std::bit_cast<uint64_t>(p_value);
}
uint64_t bits_of(float p_value) {
	return std::bit_cast<uint32_t>(p_value);
}
uint64_t bits_of(const Lanes<4> &p_value) {
	return bits_of(p_value[1]);
}

// A processor's own minimum of two zeros may be either, and of a number that is none the other one.
template <class T> void check_second_counts() {
	volatile float zero = 0.0f, none = NOT_A_NUMBER; // nothing is known while it compiles
	const T plus(zero), minus = -plus, not_a_number(none), one(1.0f);
	CHECK(bits_of(plus) != bits_of(minus));
	for (const auto &[first, second] : { std::pair(plus, minus), std::pair(minus, plus), std::pair(not_a_number, one) }) {
		CHECK(bits_of(minimum(first, second)) == bits_of(second));
		CHECK(bits_of(maximum(first, second)) == bits_of(second));
	}
	CHECK(bits_of(absolute(minus)) == bits_of(minus));
	CHECK(bits_of(absolute(plus)) == bits_of(plus));
}

} // namespace

TEST_CASE("golden: of two zeros the second is the smaller and the larger one, on every processor") {
	check_second_counts<float>();
	check_second_counts<double>();
	check_second_counts<Lanes<4>>();
}

TEST_CASE("In 60 random scenes all lane widths compute what one float does, bit for bit") {
	for (uint32_t seed = 0; int(seed) < sampled(60); seed++) {
		INFO("scene ", seed);
		CHECK(find_difference(seed, seed % 2 ? Range::WILD : Range::EVERYDAY, 30) == "");
	}
}
