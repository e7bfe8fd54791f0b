// SPDX-License-Identifier: MIT
// Pictures of leaves have the colours of their histogram, each as often as it says, and leave a blade's mean colour as it is.
#include <doctest/doctest.h>

#include "core/blades/leaf_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

using namespace grass;

namespace {

constexpr int TEXELS = LEAF_ACROSS * LEAF_ALONG;

// Mean of some of a picture's texels, as multiples of the blade's colour.
std::array<double, 3> mean_of(const std::vector<uint8_t> &p_picture, int p_from_row, int p_to_row) {
	std::array<double, 3> sum{};
	for (int i = p_from_row * LEAF_ACROSS; i < p_to_row * LEAF_ACROSS; i++) {
		for (size_t c = 0; c < 3; c++) {
			sum[c] += p_picture[size_t(4 * i) + c] / 255.0 * double(LEAF_BRIGHTEST) / ((p_to_row - p_from_row) * LEAF_ACROSS);
		}
	}
	return sum;
}

} // namespace

TEST_CASE("shares of a leaf's tones are all of it") {
	for (const int picture : { 0, GRASS_LEAF_PICTURES - 1 }) {
		float sum = 0.0f;
		for (const LeafTone &tone : leaf_tones_of(picture)) {
			CHECK(tone.share > 0.0f);
			sum += tone.share;
		}
		CHECK(sum == doctest::Approx(1.0f));
	}
}

TEST_CASE("pictures of leaves have the histogram of their kind") {
	for (int picture = 0; picture < GRASS_LEAF_PICTURES; picture++) {
		const std::vector<uint8_t> bytes = make_leaf_picture(picture);
		REQUIRE(bytes.size() == size_t(4 * TEXELS));
		std::map<std::array<uint8_t, 3>, int> counts;
		for (int i = 0; i < TEXELS; i++) {
			const uint8_t *texel = &bytes[size_t(4 * i)];
			counts[{ texel[0], texel[1], texel[2] }]++;
		}
		const auto tones = leaf_tones_of(picture);
		REQUIRE(counts.size() == tones.size());
		std::vector<int> found, wanted;
		for (const auto &[color, count] : counts) {
			found.push_back(count);
		}
		for (const LeafTone &tone : tones) {
			wanted.push_back(int(std::lround(tone.share * TEXELS)));
		}
		std::sort(found.begin(), found.end());
		std::sort(wanted.begin(), wanted.end());
		for (size_t i = 0; i < tones.size(); i++) {
			CHECK(std::abs(found[i] - wanted[i]) <= 2);
		}
		for (const double mean : mean_of(bytes, 0, LEAF_ALONG)) {
			CHECK(mean == doctest::Approx(1.0).epsilon(0.01));
		}
	}
}

TEST_CASE("an ageing leaf is brown at its tip, a fresh one is not, and no two are the same") {
	const std::vector<uint8_t> fresh = make_leaf_picture(0), ageing = make_leaf_picture(GRASS_LEAF_PICTURES - 1);
	const auto young = mean_of(fresh, LEAF_ALONG - 6, LEAF_ALONG), old = mean_of(ageing, LEAF_ALONG - 6, LEAF_ALONG);
	CHECK(old[0] / old[1] > 1.3);
	CHECK(young[0] / young[1] < 1.2);
	CHECK(make_leaf_picture(1) != fresh);
	CHECK(make_leaf_picture(0) == fresh);
}
