// SPDX-License-Identifier: MIT
// Wind (paper 4.3): a function of place and time alone, added by the drawing to whatever pose a blade has, at
// rest or simulated. Twin of shaders/blades/wind.inc: same names, same order of operations.
#pragma once

#include <Eigen/Core>

#include "core/blades/blade.h"

namespace grass {

// A light breeze moves leaves at 2 m/s, a gale bends trees at 17; 0 is calm, and skips the wind code.
inline constexpr Tunable WIND_SPEED{ "wind_speed", "m/s", 0.0, 40.0, 0.1, 3.0 };
// Where the wind blows to, from +x towards +z.
inline constexpr Tunable WIND_DIRECTION{ "wind_direction", "\u00b0", -360.0, 360.0, 1.0, 20.0 };
// From front to front, about. Below 1 m gusts read as trembling.
inline constexpr Tunable GUST_SIZE{ "gust_size", "m", 0.5, 200.0, 0.1, 7.0 };
// 0 = an even wind, 1 = lulls of 0.4 and gusts of twice the wind's speed.
inline constexpr Tunable GUST_STRENGTH{ "gust_strength", "", 0.0, 1.0, 0.01, 0.6 };

struct WindParams {
	Eigen::Vector2f velocity = Eigen::Vector2f::Zero(); // along x, z; m/s
	float gust_size = float(GUST_SIZE.initial); // metres
	float gust_strength = float(GUST_STRENGTH.initial); // 0..1
};

// Time as the wind knows it, wrapped where nothing is seen of it: it grows for days, and floats tire.
struct WindClock {
	double sway = 0.0; // seconds
	double roll = 0.0; // gust sizes that the wind has travelled: a change of the wind moves no gust

	void advance(double p_delta, double p_speed, double p_gust_size);
};

// What the wind does at one place to a point of a blade.
struct Wind {
	Eigen::Vector2f tilt = Eigen::Vector2f::Zero(); // towards x and z, as the lean of tilt_change
	float gust = 0.0f; // 0 = lull .. 1 = the middle of a gust
};

// [Eq W1] Gusts: noise that travels with the wind. p_wind.velocity must not be zero.
float gust_at(const Eigen::Vector2f &p_place, const WindClock &p_clock, const WindParams &p_wind);

// [Eq W2] The tilt of the blade's tangent at p_along (0 = root .. 1 = tip). p_place: field-space x, z in metres;
// p_random: the blade's own four numbers, 0..1. No wind gives exactly zero.
Wind wind_at(
		const Eigen::Vector2f &p_place, float p_along, const Eigen::Array4f &p_random, const WindClock &p_clock, const WindParams &p_wind);

// [Eq W3] A point of a blade, bent by the wind without stretching. p_point: blade space, metres; p_reach:
// tangent there, its length the distance from the root along the blade; p_tilt: of the tangent there.
Eigen::Vector3f wind_point(const Eigen::Vector3f &p_point, const Eigen::Vector3f &p_reach, const Eigen::Vector2f &p_tilt);

// How much of the wind a point feels: 1, falling to 0 for a point that lies on the ground.
float wind_hold(const Eigen::Vector3f &p_point, const Eigen::Vector3f &p_reach);

} // namespace grass
