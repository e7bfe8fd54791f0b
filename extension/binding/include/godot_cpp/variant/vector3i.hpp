// SPDX-License-Identifier: MIT
// Three whole numbers.
#pragma once

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/forward.hpp>

namespace godot {

struct Vector3i {
	union {
		struct {
			int32_t x, y, z;
		};
		int32_t coord[3];
	};

	constexpr Vector3i() : x(0), y(0), z(0) {}
	constexpr Vector3i(int32_t p_x, int32_t p_y, int32_t p_z) : x(p_x), y(p_y), z(p_z) {}

	constexpr bool operator==(const Vector3i &p_v) const { return x == p_v.x && y == p_v.y && z == p_v.z; }
	constexpr bool operator!=(const Vector3i &p_v) const { return !(*this == p_v); }

	operator String() const;
};

} // namespace godot
