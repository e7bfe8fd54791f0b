// SPDX-License-Identifier: MIT
// Computes the density that a fill rule gives one place: the product of what slope, height, noise, mask and obstacles leave, 0..1 each.
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

	// Returns the mask, interpolated between the centres of the four nearest texels. p_at: position in the mask, 0..1 along each side;
	// nothing grows outside.
	double sample(const Eigen::Vector2d &p_at) const;
	bool is_usable() const { return width > 0 && height > 0 && texels.size() == size_t(width) * size_t(height); }
};

struct FillRule {
	std::array<double, FILL_PARAM_COUNT> params = initial_of(FILL_PARAMS); // in their units
	uint32_t seed = 0;
	bool has_mask = false; // while its picture is not loaded, nothing grows
	std::shared_ptr<const FillMask> mask;
	bool inverts_mask = false;
	Eigen::Vector2d mask_min = Eigen::Vector2d::Zero(), mask_max = Eigen::Vector2d::Zero(); // the area that it covers, metres; equal: none

	Eigen::Vector2d noise_origin = Eigen::Vector2d::Zero(); // the map's origin in the noise, metres
	std::vector<uint8_t> texture_ids; // textures of the terrain on which grass grows; empty: all
	// For fields without a rule: fills only where an obstacle changes the grass or has changed it, and leaves other places as they are.
	bool only_at_obstacles = false;

	bool operator==(const FillRule &) const = default;

	double get(FillParamId p_param) const { return params[size_t(p_param)]; }
	bool asks_slope() const { return get(FILL_SLOPE_MIN) > 0.0 || get(FILL_SLOPE_MAX) < 90.0; }
	bool asks_height() const;
	bool asks_textures() const { return !texture_ids.empty(); }

	// Return the share that one condition leaves. p_slope: degrees from level; p_height: of the ground, metres above the field; p_place: x,
	// z in metres.
	double slope_share(double p_slope) const;
	double height_share(double p_height) const;
	double noise_share(const Eigen::Vector2d &p_place) const;
	double mask_share(const Eigen::Vector2d &p_place) const;
	// Returns the share of the terrain's picture that such textures have. p_texel: null: not known yet.
	double texture_share(const TerrainTexel *p_texel) const;
};

// Returns 1 up to p_limit and 0 from p_limit + p_fade on, with a smooth transition.
double fade_out(double p_value, double p_limit, double p_fade);

// Returns noise with patches of p_size metres, distributed evenly over 0..1: a share s of the ground is below s.
double fill_noise(const Eigen::Vector2d &p_place, double p_size, uint32_t p_seed);

} // namespace grass
