// SPDX-License-Identifier: MIT
// Thin lines of a card do not vanish with the distance, and do not grow into a blot.
#include <doctest/doctest.h>

#include "core/species/card_coverage.h"

#include <cmath>
#include <vector>

using namespace grass;

namespace {

// p_side x p_side texels with upright lines a texel wide every p_gap.
std::vector<uint8_t> make_lines(int p_side, int p_gap) {
	std::vector<uint8_t> rgba;
	for (int i = 0; i < p_side * p_side; i++) {
		const uint8_t alpha = (i % p_side + i / p_side / 3) % p_gap == 0 ? 255 : 0;
		rgba.insert(rgba.end(), { 200, 150, 90, alpha });
	}
	return rgba;
}

// Returns the mean of each square of four.
std::vector<uint8_t> halved(const std::vector<uint8_t> &p_rgba, int p_side) {
	std::vector<uint8_t> half;
	for (int y = 0; y < p_side; y += 2) {
		for (int x = 0; x < p_side; x += 2) {
			for (int c = 0; c < 4; c++) {
				const auto at = [&](int p_x, int p_y) { return int(p_rgba[size_t(4 * (p_y * p_side + p_x) + c)]); };
				half.push_back(uint8_t((at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1)) / 4));
			}
		}
	}
	return half;
}

} // namespace

TEST_CASE("a card of thin lines is drawn to the same share in each smaller version") {
	for (const int gap : { 3, 5, 8 }) {
		CAPTURE(gap);
		std::vector<uint8_t> level = make_lines(128, gap);
		const double coverage = card_coverage(level);
		CHECK(coverage == doctest::Approx(1.0 / gap).epsilon(0.02));
		for (int side = 128; side > 16; side /= 2) {
			CAPTURE(side);
			level = halved(level, side);
			std::vector<uint8_t> kept = level;
			keep_card_coverage(kept, coverage);
			CHECK(std::abs(card_coverage(kept) - coverage) < 1.0 / (side * side / 4.0));
			CHECK(kept[0] == level[0]); // colours stay
		}
		CHECK(card_coverage(level) == 0.0); // as it would be
	}
}

TEST_CASE("a card that is drawn all over, nowhere, or has no texel keeps what it has") {
	std::vector<uint8_t> full(64, 255), none(64, 0), empty;
	keep_card_coverage(full, 1.0);
	keep_card_coverage(none, 0.0);
	keep_card_coverage(empty, 0.5);
	CHECK(card_coverage(full) == 1.0);
	CHECK(card_coverage(none) == 0.0);
	CHECK(card_coverage(empty) == 0.0);
}
