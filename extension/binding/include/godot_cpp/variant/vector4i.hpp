// SPDX-License-Identifier: MIT
// Four whole numbers.
#pragma once

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/forward.hpp>

namespace godot {

struct Vector4i {
	union {
		struct {
			int32_t x, y, z, w;
		};
		int32_t coord[4];
	};

	constexpr Vector4i() : x(0), y(0), z(0), w(0) {}
	constexpr Vector4i(int32_t p_x, int32_t p_y, int32_t p_z, int32_t p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}

	constexpr bool operator==(const Vector4i &p_v) const { return x == p_v.x && y == p_v.y && z == p_v.z && w == p_v.w; }
	constexpr bool operator!=(const Vector4i &p_v) const { return !(*this == p_v); }

	operator String() const;
};

} // namespace godot
