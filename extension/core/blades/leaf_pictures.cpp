// SPDX-License-Identifier: MIT
#include "core/blades/leaf_pictures.h"

#include "core/base/hash.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace grass {

namespace {

constexpr int TEXELS = LEAF_ACROSS * LEAF_ALONG;
constexpr int SPOTS_MOST = 14; // most spots in a picture

// The random numbers of one picture.
class Chance {
public:
	explicit Chance(int p_picture) : _salt(grass_hash(uint32_t(p_picture) + 77u)) {}
	float at(uint32_t p_number) const { return float(grass_hash(p_number ^ _salt) >> 8u) / float(1 << 24); }
	// Returns value noise over the points of a lattice.
	float noise(float p_x, float p_y) const {
		const float x = std::floor(p_x), y = std::floor(p_y);
		const auto point = [&](float p_dx, float p_dy) { return at(uint32_t(int(x + p_dx) * 131 + int(y + p_dy) * 7919)); };
		const float u = p_x - x, v = p_y - y;
		return (point(0, 0) * (1 - u) + point(1, 0) * u) * (1 - v) + (point(0, 1) * (1 - u) + point(1, 1) * u) * v;
	}

private:
	uint32_t _salt;
};

// Returns where a place on a leaf ranks in its histogram: low in furrows, higher on ridges, highest where it withers. p_across: -1..1;
// p_along: 0..1, root to tip; p_age: 0 fresh .. 1 ageing.
float rank_of(const Chance &p_chance, float p_across, float p_along, float p_age) {
	const float off = std::abs(p_across);
	const float veins = std::cos(21.0f * off + 1.2f * p_chance.noise(3.0f * p_across + 40.0f, 5.0f * p_along));
	const float keel = std::max(1.0f - off / 0.09f, 0.0f); // the midrib lies in a fold
	const float patches =
			p_chance.noise(4.0f * p_across + 9.0f, 22.0f * p_along) + 0.6f * p_chance.noise(16.0f * p_across, 64.0f * p_along);
	float rank = 0.45f * veins - 1.3f * keel + 0.9f * (patches - 0.8f);
	rank += off > 0.86f ? 0.5f : 0.0f; // the margin lets light through
	const float ragged = 0.16f * (p_chance.noise(6.0f * p_across + 3.0f, 12.0f) - 0.5f) + 0.05f * off;
	const float wither = (p_along + ragged - (1.0f - 0.16f * p_age)) / 0.06f;
	rank += std::clamp(wither, 0.0f, 1.5f) * (0.4f + 3.0f * p_age);
	for (int s = 0; s < int(std::lround(p_age * SPOTS_MOST)); s++) {
		const uint32_t number = 1000u + uint32_t(s) * 8u;
		const float dx = (p_across - (2.0f * p_chance.at(number) - 1.0f)) / (0.12f + 0.3f * p_chance.at(number + 2));
		const float dy = (p_along - p_chance.at(number + 1)) / (0.006f + 0.02f * p_chance.at(number + 3));
		rank += 4.5f * std::max(1.0f - dx * dx - dy * dy, 0.0f);
	}
	return rank;
}

// Returns the mean of a histogram for each channel.
std::array<float, 3> mean_of(std::span<const LeafTone> p_tones) {
	std::array<float, 3> mean{};
	for (const LeafTone &tone : p_tones) {
		mean[0] += tone.share * tone.red;
		mean[1] += tone.share * tone.green;
		mean[2] += tone.share * tone.blue;
	}
	return mean;
}

uint8_t tone_byte(float p_multiple) {
	return uint8_t(std::clamp(std::lround(255.0f * p_multiple / LEAF_BRIGHTEST), 0L, 255L));
}

} // namespace

std::span<const LeafTone> leaf_tones_of(int p_picture) {
	return p_picture < GRASS_LEAF_PICTURES / 2 ? std::span<const LeafTone>(FRESH_LEAF) : std::span<const LeafTone>(AGEING_LEAF);
}

// The ranks of the texels decide which texel gets which colour of the histogram. Each colour keeps its share, however the ranks are spread.
std::vector<uint8_t> make_leaf_picture(int p_picture) {
	const std::span<const LeafTone> tones = leaf_tones_of(p_picture);
	const Chance chance(p_picture);
	const float age = p_picture < GRASS_LEAF_PICTURES / 2 ? 0.0f : 0.5f + 0.5f * chance.at(1);
	std::vector<float> ranks(TEXELS);
	for (int i = 0; i < TEXELS; i++) {
		const int row = i / LEAF_ACROSS, column = i % LEAF_ACROSS;
		const float across = (float(column) + 0.5f) / float(LEAF_ACROSS), along = (float(row) + 0.5f) / float(LEAF_ALONG);
		ranks[size_t(i)] = rank_of(chance, 2.0f * across - 1.0f, along, age);
	}
	std::vector<int> order(TEXELS);
	std::iota(order.begin(), order.end(), 0);
	std::stable_sort(order.begin(), order.end(), [&ranks](int p_a, int p_b) { return ranks[size_t(p_a)] < ranks[size_t(p_b)]; });
	const std::array<float, 3> mean = mean_of(tones);
	std::vector<uint8_t> bytes(size_t(4 * TEXELS), 255);
	size_t tone = 0;
	float below = tones[0].share;
	for (int i = 0; i < TEXELS; i++) {
		while (tone + 1 < tones.size() && float(i) >= below * float(TEXELS)) {
			below += tones[++tone].share;
		}
		uint8_t *texel = &bytes[size_t(4 * order[size_t(i)])];
		texel[0] = tone_byte(tones[tone].red / mean[0]);
		texel[1] = tone_byte(tones[tone].green / mean[1]);
		texel[2] = tone_byte(tones[tone].blue / mean[2]);
	}
	return bytes;
}

} // namespace grass
