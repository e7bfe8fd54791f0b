// SPDX-License-Identifier: MIT
// What the map makes of the grass at one place. Twin of shaders/map/map.inc, which draws the same: same names, same
// order of operations.
#pragma once

#include "core/blades/clump.h"
#include "core/map/map_channels.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>

namespace grass {

static_assert(MAP_CHUNK_SIZE == GRASS_CHUNK_SIZE && float(MAP_UNCUT) == float(GRASS_UNCUT));
static_assert(info_of(MAP_DENSITY).side == GRASS_FINE_TEXELS && info_of(MAP_HEIGHT).side == GRASS_COARSE_TEXELS);

// How far blades follow the ground's slope. 0: they stand upright, as grass does; 1: at a right angle to it, as hair.
inline constexpr Tunable FOLLOW_SLOPE{ "follow_slope", "", 0.0, 1.0, 0.01, 0.25 };

struct Growth {
	float density = 0.0f; // [Eq M1] share of the blades that stand
	float height = 1.0f; // [Eq M1] factor on their length
	float cut = float(MAP_UNCUT); // metres; MAP_UNCUT: nobody cut here
	float wear = 0.0f;
	Eigen::Vector2f lean = Eigen::Vector2f::Zero(); // as the map has it, -1..1
	Eigen::Vector2f tilt = Eigen::Vector2f::Zero(); // [Eq M4] of the ground: tangent of half the angle towards x, z
	float ground = 0.0f; // metres above the field
};

// [Eq M4] The tilt that follows a share of the ground's slope. p_normal: x and z of its unit normal.
inline Eigen::Vector2f ground_tilt(const Eigen::Vector2f &p_normal, float p_follow) {
	const Eigen::Vector3f normal(p_normal.x(), std::sqrt(std::max(0.0f, 1.0f - p_normal.squaredNorm())), p_normal.y());
	const Eigen::Vector3f along = (Eigen::Vector3f::UnitY() * (1.0f - p_follow) + normal * p_follow).normalized();
	return Eigen::Vector2f(along.x(), along.z()) / (1.0f + along.y());
}

// How far the tip of a blade of 1 m moves at most where it follows the slope, on ground of up to 60 degrees. Metres.
inline float slope_lean(float p_follow) {
	const float tilt = ground_tilt(Eigen::Vector2f(0.8660254f, 0.0f), p_follow).x(); // tangent of half the angle
	return 2.0f * tilt / std::sqrt(1.0f + tilt * tilt);
}

// [Eq M2] How far a blade has come up, 0..1. p_random: of the blade's own, 0..1.
inline float presence(float p_density, float p_random) {
	return std::clamp((p_density - p_random * float(1.0 - GRASS_SPROUT)) / float(GRASS_SPROUT), 0.0f, 1.0f);
}

// [Eq M3] [Eq M4] The clump that a blade of p_length metres (in the patch) grows by here.
inline Clump grown(const Clump &p_clump, const Growth &p_growth, float p_length) {
	Clump grown = p_clump;
	grown.height *= p_growth.height;
	if (p_growth.cut < float(MAP_UNCUT)) {
		grown.height = std::min(grown.height, p_growth.cut / std::max(p_length, 1e-4f));
	}
	grown.height = std::max(grown.height, float(GRASS_STUBBLE));
	const float combed = p_growth.lean.norm();
	if (combed > 0.0f) {
		const float share = std::min(combed, 1.0f);
		grown.lean = p_clump.lean * (1.0f - share) + float(GRASS_COMB_LEAN) / combed * share * p_growth.lean;
	}
	grown.lean += p_growth.tilt;
	return grown;
}

} // namespace grass
