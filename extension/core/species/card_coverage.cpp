// SPDX-License-Identifier: MIT
#include "core/species/card_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace grass {

namespace {

constexpr size_t RGBA_BYTES = 4, ALPHA = 3; // bytes

} // namespace

double card_coverage(std::span<const uint8_t> p_rgba) {
	size_t drawn = 0;
	for (size_t i = ALPHA; i < p_rgba.size(); i += RGBA_BYTES) {
		drawn += p_rgba[i] >= CARD_THRESHOLD ? 1 : 0;
	}
	return double(drawn) / double(std::max(p_rgba.size() / RGBA_BYTES, size_t(1)));
}

void keep_card_coverage(std::span<uint8_t> r_rgba, double p_coverage) {
	std::array<size_t, 256> texels{}; // count for each alpha
	for (size_t i = ALPHA; i < r_rgba.size(); i += RGBA_BYTES) {
		texels[r_rgba[i]]++;
	}
	const size_t all = r_rgba.size() / RGBA_BYTES, wanted = size_t(std::lround(p_coverage * double(all)));
	// All texels above this alpha are drawn, and some of those that have exactly this alpha.
	size_t edge = 255, above = 0;
	while (edge > 0 && above + texels[edge] < wanted) {
		above += texels[edge];
		edge--;
	}
	const size_t some = std::min(wanted - std::min(above, wanted), texels[edge]);
	size_t sum = texels[edge] / 2; // accumulates `some`, to spread it evenly over the texels with this alpha
	for (size_t i = ALPHA; i < r_rgba.size(); i += RGBA_BYTES) {
		const size_t alpha = r_rgba[i];
		sum += alpha == edge ? some : 0;
		const bool is_drawn = alpha > edge || (alpha == edge && sum >= texels[edge] && some > 0);
		sum -= alpha == edge && is_drawn ? texels[edge] : 0;
		const int scaled = int(std::lround(double(alpha) * CARD_THRESHOLD / double(std::max(edge, size_t(1)))));
		r_rgba[i] = uint8_t(is_drawn ? std::clamp(scaled, CARD_THRESHOLD, 255) : std::min(scaled, CARD_THRESHOLD - 1));
	}
}

} // namespace grass
