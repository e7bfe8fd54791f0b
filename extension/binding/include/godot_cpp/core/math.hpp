// SPDX-License-Identifier: MIT
// Functions on numbers, for float and double alike.
#pragma once

#include <godot_cpp/core/math_defs.hpp>

#include <cmath>

namespace godot::Math {

constexpr float abs(float p_x) {
	return p_x < 0 ? -p_x : p_x + 0.0f; // -0 becomes 0
}
constexpr double abs(double p_x) {
	return p_x < 0 ? -p_x : p_x + 0.0;
}

inline bool is_finite(float p_x) {
	return std::isfinite(p_x);
}
inline bool is_finite(double p_x) {
	return std::isfinite(p_x);
}

constexpr float deg_to_rad(float p_degrees) {
	return p_degrees * float(PI / 180.0);
}
constexpr double deg_to_rad(double p_degrees) {
	return p_degrees * (PI / 180.0);
}

// Relative above 1, absolute below.
constexpr bool is_equal_approx(float p_a, float p_b, float p_tolerance) {
	return p_a == p_b || abs(p_a - p_b) < p_tolerance;
}
constexpr bool is_equal_approx(double p_a, double p_b, double p_tolerance) {
	return p_a == p_b || abs(p_a - p_b) < p_tolerance;
}
constexpr bool is_equal_approx(float p_a, float p_b) {
	return is_equal_approx(p_a, p_b, MAX(float(CMP_EPSILON) * abs(p_a), float(CMP_EPSILON)));
}
constexpr bool is_equal_approx(double p_a, double p_b) {
	return is_equal_approx(p_a, p_b, MAX(CMP_EPSILON * abs(p_a), CMP_EPSILON));
}

} // namespace godot::Math
