// SPDX-License-Identifier: MIT
// The blade types: shapes of real blades, set by hand as a few control numbers and resampled to knots. May include Eigen, never Godot.
#pragma once

#include <Eigen/Core>
#include <array>

#include "core/base/layout.h"

namespace grass {

// A curve of length 1 that starts at the origin. The control numbers are evenly spaced along it, from
// the root (first) to the tip (last); degrees.
struct BladeType {
	static constexpr int CONTROLS = 6;

	const char *name;
	std::array<double, CONTROLS> inclination; // of the tangent from the vertical
	std::array<double, CONTROLS> bearing; // of the tangent about the vertical, relative to the direction in which the blade leans
	std::array<double, CONTROLS> twist; // of the width about the tangent, relative to the root
};

inline constexpr std::array<BladeType, 4> BLADE_TYPES{ {
		{ "upright", { 4, 7, 11, 15, 19, 24 }, { 0, 2, 4, 6, 8, 10 }, { 0, 6, 14, 24, 36, 48 } },
		{ "arched", { 8, 15, 26, 42, 60, 76 }, { 0, 0, 2, 4, 8, 12 }, { 0, 4, 9, 16, 24, 30 } },
		{ "drooping", { 9, 20, 40, 68, 94, 112 }, { 0, -2, -4, -4, 0, 8 }, { 0, 5, 10, 18, 30, 42 } },
		{ "wavy", { 12, 20, 22, 16, 26, 48 }, { 0, 10, 24, 40, 48, 52 }, { 0, 14, 34, 58, 80, 96 } },
} };

struct BladeCurve {
	std::array<Eigen::Vector3d, GRASS_KNOTS> knots; // leaning towards +x, y up; at knot_share() of a length of 1
	std::array<double, GRASS_KNOTS> twist; // radians, 0 at the root
};

// Returns p_type resampled to knots. p_bend multiplies the inclination (1 = as set by hand), p_twist the twist.
BladeCurve blade_curve(const BladeType &p_type, double p_bend, double p_twist);

} // namespace grass
