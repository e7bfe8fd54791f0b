// SPDX-License-Identifier: MIT
// Wind (paper 4.3): a function of place and time alone, which the draw shaders add to any pose of a blade, at rest or simulated
// (shaders/blades/wind.inc); and the clock that it reads.
#pragma once

#include "core/base/tunable.h"
#include "core/blades/glsl_texts.h"

#include <Eigen/Core>

namespace grass {

// A light breeze moves leaves at 2 m/s, a gale bends trees at 17; 0 is calm, and skips the wind code.
inline constexpr Tunable WIND_SPEED{ "wind_speed", "m/s", 0.0, 40.0, 0.1, 3.0 };
// The direction in which the wind blows, from the world's +x towards its +z.
inline constexpr Tunable WIND_DIRECTION{ "wind_direction", "\u00b0", -360.0, 360.0, 1.0, 20.0 };
// The approximate distance between fronts. Below 1 m gusts look like trembling.
inline constexpr Tunable GUST_SIZE{ "gust_size", "m", 0.5, 200.0, 0.1, 7.0 };
// 0 = a steady wind, 1 = lulls of 0.4 and gusts of twice the wind's speed.
inline constexpr Tunable GUST_STRENGTH{ "gust_strength", "", 0.0, 1.0, 0.01, 0.6 };

// The wind's time, wrapped where the wrap does not show: over days a float would lose its precision.
struct WindClock {
	double sway = 0.0; // seconds
	double roll = 0.0; // distance that the wind has travelled, in gust sizes: a change of the wind moves no gust

	void advance(double p_delta, double p_speed, double p_gust_size);
};

// Returns the wind's velocity along a field's x and z, m/s: the part that blows along the ground. p_turn: from the field's axes to the
// world's; p_direction: WIND_DIRECTION.
Eigen::Vector2d wind_in_field(const Eigen::Matrix3d &p_turn, double p_speed, double p_direction);

} // namespace grass
