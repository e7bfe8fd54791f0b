// SPDX-License-Identifier: MIT
// Constants of mathematics and the engine's tolerances.
#pragma once

#include <godot_cpp/core/defs.hpp>

#include <limits>

namespace godot {

namespace Math {

inline constexpr double SQRT2 = 1.41421356237309504880;
inline constexpr double SQRT12 = 0.70710678118654752440;
inline constexpr double SQRT3 = 1.73205080756887729353;
inline constexpr double SQRT13 = 0.57735026918962576451;
inline constexpr double LN2 = 0.69314718055994530942;
inline constexpr double PI = 3.14159265358979323846;
inline constexpr double TAU = 6.28318530717958647693;
inline constexpr double E = 2.71828182845904523536;
inline constexpr double INF = std::numeric_limits<double>::infinity();
inline constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

} // namespace Math

inline constexpr double CMP_EPSILON = 0.00001;
inline constexpr double CMP_EPSILON2 = CMP_EPSILON * CMP_EPSILON;
inline constexpr double UNIT_EPSILON = 0.001;

} // namespace godot

#define Math_SQRT12 ::godot::Math::SQRT12
#define Math_SQRT2 ::godot::Math::SQRT2
#define Math_LN2 ::godot::Math::LN2
#define Math_PI ::godot::Math::PI
#define Math_TAU ::godot::Math::TAU
#define Math_E ::godot::Math::E
#define Math_INF ::godot::Math::INF
#define Math_NAN ::godot::Math::NaN
