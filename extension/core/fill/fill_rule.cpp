// SPDX-License-Identifier: MIT
#include "core/fill/fill_rule.h"

#include "core/base/hash.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace grass {

namespace {

// Returns the random number of a lattice point, 0 <= h < 1. Has no period, so that fields of any size do not repeat.
double lattice_number(int64_t p_x, int64_t p_z, uint32_t p_seed) {
	return double(grass_tile_bits(uint32_t(p_x), uint32_t(p_z), p_seed)) / 4294967296.0;
}

double blend(double p_a, double p_b, double p_t) {
	return p_a + (p_b - p_a) * p_t;
}

double smooth(double p_t) {
	return p_t * p_t * (3.0 - 2.0 * p_t);
}

// Interpolates the lattice's numbers; their mean is 1/2.
double blended_noise(const Eigen::Vector2d &p_place, uint32_t p_seed) {
	const Eigen::Array2d corner = p_place.array().floor();
	const double s = smooth(p_place.x() - corner.x()), t = smooth(p_place.y() - corner.y());
	const int64_t x = int64_t(corner.x()), z = int64_t(corner.y());
	const double near_row = blend(lattice_number(x, z, p_seed), lattice_number(x + 1, z, p_seed), s);
	const double far_row = blend(lattice_number(x, z + 1, p_seed), lattice_number(x + 1, z + 1, p_seed), s);
	return blend(near_row, far_row, t);
}

} // namespace

double fade_out(double p_value, double p_limit, double p_fade) {
	if (p_value <= p_limit) {
		return 1.0;
	}
	return p_value < p_limit + p_fade ? 1.0 - smooth((p_value - p_limit) / p_fade) : 0.0;
}

// Three octaves of 4/7, 2/7 and 1/7. The variance of interpolated lattice numbers is 1/12 (26/35)^2, that of the sum (16 + 4 + 1)/49 of it.
// A sum of so many is nearly normal, so the cumulative normal distribution spreads it evenly.
double fill_noise(const Eigen::Vector2d &p_place, double p_size, uint32_t p_seed) {
	const Eigen::Vector2d place = p_place / p_size;
	const double sum =
			(4.0 * blended_noise(place, p_seed) + 2.0 * blended_noise(2.0 * place, p_seed + 1) + blended_noise(4.0 * place, p_seed + 2)) /
			7.0;
	const double deviation = 26.0 / 35.0 * std::sqrt(21.0 / 49.0 / 12.0);
	return 0.5 * std::erfc((0.5 - sum) / (deviation * std::numbers::sqrt2));
}

double FillMask::sample(const Eigen::Vector2d &p_at) const {
	if (!is_usable() || !(p_at.array() >= 0.0).all() || !(p_at.array() <= 1.0).all()) {
		return 0.0;
	}
	const Eigen::Array2d between(p_at.x() * width - 0.5, p_at.y() * height - 0.5); // texel centres have integer coordinates
	const Eigen::Array2d corner = between.floor(), t = between - corner;
	const auto texel = [&](int p_i, int p_j) {
		return double(texels[size_t(std::clamp(p_j, 0, height - 1)) * size_t(width) + size_t(std::clamp(p_i, 0, width - 1))]);
	};
	const int i = int(corner.x()), j = int(corner.y());
	const double near_row = blend(texel(i, j), texel(i + 1, j), t.x()), far_row = blend(texel(i, j + 1), texel(i + 1, j + 1), t.x());
	return blend(near_row, far_row, t.y()) / 255.0;
}

bool FillRule::asks_height() const {
	return get(FILL_HEIGHT_MIN) > FILL_PARAMS[FILL_HEIGHT_MIN].minimum || get(FILL_HEIGHT_MAX) < FILL_PARAMS[FILL_HEIGHT_MAX].maximum;
}

double FillRule::slope_share(double p_slope) const {
	const double fade = get(FILL_SLOPE_FADE);
	return fade_out(p_slope, get(FILL_SLOPE_MAX), fade) * fade_out(-p_slope, -get(FILL_SLOPE_MIN), fade);
}

double FillRule::height_share(double p_height) const {
	const double fade = get(FILL_HEIGHT_FADE);
	return fade_out(p_height, get(FILL_HEIGHT_MAX), fade) * fade_out(-p_height, -get(FILL_HEIGHT_MIN), fade);
}

// The border is in the middle of the fade, so that the fade does not change the cover.
double FillRule::noise_share(const Eigen::Vector2d &p_place) const {
	const double cover = get(FILL_NOISE_COVER);
	if (cover >= 1.0 || cover <= 0.0) {
		return cover;
	}
	const double fade = get(FILL_NOISE_FADE) * 2.0 * std::min(cover, 1.0 - cover);
	return fade_out(fill_noise(p_place + noise_origin, get(FILL_NOISE_SIZE), seed), cover - 0.5 * fade, fade);
}

double FillRule::texture_share(const TerrainTexel *p_texel) const {
	if (!asks_textures()) {
		return 1.0;
	}
	if (p_texel == nullptr) {
		return 0.0;
	}
	const auto grows = [this](uint8_t p_id) { return std::find(texture_ids.begin(), texture_ids.end(), p_id) != texture_ids.end(); };
	const double overlay = double(p_texel->blend) / TerrainTexel::FULL;
	return (grows(p_texel->base) ? 1.0 - overlay : 0.0) + (grows(p_texel->overlay) ? overlay : 0.0);
}

double FillRule::mask_share(const Eigen::Vector2d &p_place) const {
	if (!has_mask) {
		return 1.0;
	}
	const Eigen::Array2d size = mask_max - mask_min;
	const Eigen::Array2d at = (p_place - mask_min).array() / size;
	if (!mask || !(size > 0.0).all() || !(at >= 0.0).all() || !(at <= 1.0).all()) {
		return 0.0;
	}
	const double share = mask->sample(at.matrix());
	return inverts_mask ? 1.0 - share : share;
}

} // namespace grass
