// SPDX-License-Identifier: MIT
// Constants of mathematics and the engine's tolerances.
#pragma once

#include <godot_cpp/core/defs.hpp>

namespace godot {

namespace Math {

inline constexpr double PI = 3.14159265358979323846;

} // namespace Math

inline constexpr double CMP_EPSILON = 0.00001;
inline constexpr double UNIT_EPSILON = 0.001;

} // namespace godot
