// SPDX-License-Identifier: MIT
// Functions on numbers, for float and double alike. Angles in radians unless said.
#pragma once

#include <godot_cpp/core/math_defs.hpp>

#include <cmath>
#include <concepts>

namespace godot::Math {

// A function of <cmath> under the engine's name: float stays float, whole numbers become double.
#define GODOT_MATH_FUNCTION(m_name)                                                                                                        \
	inline float m_name(float p_x) {                                                                                                       \
		return std::m_name(p_x);                                                                                                           \
	}                                                                                                                                      \
	inline double m_name(double p_x) {                                                                                                     \
		return std::m_name(p_x);                                                                                                           \
	}                                                                                                                                      \
	template <std::integral T> double m_name(T p_x) {                                                                                      \
		return std::m_name(static_cast<double>(p_x));                                                                                      \
	}

GODOT_MATH_FUNCTION(sin)
GODOT_MATH_FUNCTION(cos)
GODOT_MATH_FUNCTION(tan)
GODOT_MATH_FUNCTION(sinh)
GODOT_MATH_FUNCTION(cosh)
GODOT_MATH_FUNCTION(tanh)
GODOT_MATH_FUNCTION(atan)
GODOT_MATH_FUNCTION(asinh)
GODOT_MATH_FUNCTION(sqrt)
GODOT_MATH_FUNCTION(floor)
GODOT_MATH_FUNCTION(ceil)
GODOT_MATH_FUNCTION(round)
GODOT_MATH_FUNCTION(exp)
GODOT_MATH_FUNCTION(log)
GODOT_MATH_FUNCTION(log2)
GODOT_MATH_FUNCTION(log1p)
#undef GODOT_MATH_FUNCTION

// Outside -1..1 these give the value at the nearer end instead of NaN.
template <std::floating_point T> T asin(T p_x) {
	return p_x < T(-1) ? T(-PI / 2) : (p_x > T(1) ? T(PI / 2) : std::asin(p_x));
}
template <std::floating_point T> T acos(T p_x) {
	return p_x < T(-1) ? T(PI) : (p_x > T(1) ? T(0) : std::acos(p_x));
}

inline float atan2(float p_y, float p_x) {
	return std::atan2(p_y, p_x);
}
inline double atan2(double p_y, double p_x) {
	return std::atan2(p_y, p_x);
}
inline float pow(float p_x, float p_y) {
	return std::pow(p_x, p_y);
}
inline double pow(double p_x, double p_y) {
	return std::pow(p_x, p_y);
}
inline float fmod(float p_x, float p_y) {
	return std::fmod(p_x, p_y);
}
inline double fmod(double p_x, double p_y) {
	return std::fmod(p_x, p_y);
}

template <typename T> constexpr T abs(T p_x) {
	return p_x < T(0) ? T(-p_x) : (p_x == T(0) ? T(0) : p_x);
}
template <typename A, typename B> constexpr auto min(A p_a, B p_b) {
	return MIN(p_a, p_b);
}
template <typename A, typename B> constexpr auto max(A p_a, B p_b) {
	return MAX(p_a, p_b);
}
template <typename T, typename A, typename B> constexpr auto clamp(T p_x, A p_min, B p_max) {
	return CLAMP(p_x, p_min, p_max);
}
template <typename T> constexpr T sign(T p_x) {
	return SIGN(p_x);
}

inline bool is_nan(float p_x) {
	return std::isnan(p_x);
}
inline bool is_nan(double p_x) {
	return std::isnan(p_x);
}
inline bool is_inf(float p_x) {
	return std::isinf(p_x);
}
inline bool is_inf(double p_x) {
	return std::isinf(p_x);
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
constexpr float rad_to_deg(float p_radians) {
	return p_radians * float(180.0 / PI);
}
constexpr double rad_to_deg(double p_radians) {
	return p_radians * (180.0 / PI);
}

constexpr float lerp(float p_from, float p_to, float p_weight) {
	return p_from + (p_to - p_from) * p_weight;
}
constexpr double lerp(double p_from, double p_to, double p_weight) {
	return p_from + (p_to - p_from) * p_weight;
}
constexpr float inverse_lerp(float p_from, float p_to, float p_value) {
	return (p_value - p_from) / (p_to - p_from);
}
constexpr double inverse_lerp(double p_from, double p_to, double p_value) {
	return (p_value - p_from) / (p_to - p_from);
}
constexpr double remap(double p_value, double p_in_from, double p_in_to, double p_out_from, double p_out_to) {
	return lerp(p_out_from, p_out_to, inverse_lerp(p_in_from, p_in_to, p_value));
}

// Relative above 1, absolute below.
template <std::floating_point T> constexpr bool is_equal_approx(T p_a, T p_b, T p_tolerance) {
	return p_a == p_b || abs(p_a - p_b) < p_tolerance;
}
constexpr bool is_equal_approx(float p_a, float p_b) {
	return is_equal_approx(p_a, p_b, MAX(float(CMP_EPSILON) * abs(p_a), float(CMP_EPSILON)));
}
constexpr bool is_equal_approx(double p_a, double p_b) {
	return is_equal_approx(p_a, p_b, MAX(CMP_EPSILON * abs(p_a), CMP_EPSILON));
}
constexpr bool is_zero_approx(float p_x) {
	return abs(p_x) < float(CMP_EPSILON);
}
constexpr bool is_zero_approx(double p_x) {
	return abs(p_x) < CMP_EPSILON;
}

template <std::floating_point T> constexpr T smoothstep(T p_from, T p_to, T p_x) {
	if (is_equal_approx(p_from, p_to)) {
		return p_x <= p_from ? T(0) : T(1);
	}
	const T t = CLAMP((p_x - p_from) / (p_to - p_from), T(0), T(1));
	return t * t * (T(3) - T(2) * t);
}
template <std::floating_point T> constexpr T move_toward(T p_from, T p_to, T p_delta) {
	return abs(p_to - p_from) <= p_delta ? p_to : p_from + SIGN(p_to - p_from) * p_delta;
}
// The remainder with the sign of p_y.
template <std::floating_point T> T fposmod(T p_x, T p_y) {
	T remainder = std::fmod(p_x, p_y);
	if ((remainder < 0 && p_y > 0) || (remainder > 0 && p_y < 0)) {
		remainder += p_y;
	}
	return remainder + T(0);
}
constexpr int64_t posmod(int64_t p_x, int64_t p_y) {
	const int64_t remainder = p_x % p_y;
	return (remainder < 0 && p_y > 0) || (remainder > 0 && p_y < 0) ? remainder + p_y : remainder;
}
inline double snapped(double p_x, double p_step) {
	return p_step != 0.0 ? std::floor(p_x / p_step + 0.5) * p_step : p_x;
}
constexpr int64_t wrapi(int64_t p_x, int64_t p_min, int64_t p_max) {
	return p_max == p_min ? p_min : p_min + posmod(p_x - p_min, p_max - p_min);
}
inline double wrapf(double p_x, double p_min, double p_max) {
	const double range = p_max - p_min;
	return is_zero_approx(range) ? p_min : p_x - range * std::floor((p_x - p_min) / range);
}

} // namespace godot::Math
