// SPDX-License-Identifier: MIT
// The density by a fill rule at one place: the product of what slope, height, noise, mask and obstacles leave, 0..1 each.
#pragma once

#include "core/fill/fill_params.h"
#include "core/fill/terrain_ids.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <vector>

namespace grass {

// An image of where grass grows: 0 not at all .. 255 fully.
struct FillMask {
	int width = 0, height = 0;
	std::vector<uint8_t> texels; // row by row, the first row at the least z

	// Blended between the centres of the four nearest texels. p_at: share of the way across, 0..1; beyond that nothing grows.
	double sample(const Eigen::Vector2d &p_at) const;
	bool is_usable() const { return width > 0 && height > 0 && texels.size() == size_t(width) * size_t(height); }
};

struct FillRule {
	std::array<double, FILL_PARAM_COUNT> params; // FILL_PARAMS, in their units
	uint32_t seed = 0;
	bool has_mask = false; // without a picture yet, nothing grows
	std::shared_ptr<const FillMask> mask;
	bool inverts_mask = false;
	Eigen::Vector2d mask_min = Eigen::Vector2d::Zero(), mask_max = Eigen::Vector2d::Zero(); // what it covers, metres; equal: nothing

	Eigen::Vector2d noise_origin = Eigen::Vector2d::Zero(); // the map's origin in the noise, metres
	std::vector<uint8_t> texture_ids; // of the terrain, on which grass grows; none: on all

	FillRule();
	bool operator==(const FillRule &) const = default;

	double get(FillParamId p_param) const { return params[size_t(p_param)]; }
	bool asks_slope() const { return get(FILL_SLOPE_MIN) > 0.0 || get(FILL_SLOPE_MAX) < 90.0; }
	bool asks_height() const;
	bool asks_textures() const { return !texture_ids.empty(); }

	// p_slope: degrees from level; p_height: of the ground, metres above the field; p_place: x, z in metres.
	double slope_share(double p_slope) const;
	double height_share(double p_height) const;
	double noise_share(const Eigen::Vector2d &p_place) const;
	double mask_share(const Eigen::Vector2d &p_place) const;
	// By how much of the terrain's picture is of such textures. p_texel: null: not known yet.
	double texture_share(const TerrainTexel *p_texel) const;
};

// 1 up to p_limit, 0 from p_limit + p_fade on, smooth between.
double fade_out(double p_value, double p_limit, double p_fade);

// Noise with patches of p_size metres, spread evenly over 0..1: below s lies a share s of the ground.
double fill_noise(const Eigen::Vector2d &p_place, double p_size, uint32_t p_seed);

} // namespace grass
