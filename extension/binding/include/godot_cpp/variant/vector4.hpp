// SPDX-License-Identifier: MIT
// Four numbers.
#pragma once

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/forward.hpp>

namespace godot {

struct Vector4 {
	union {
		struct {
			real_t x, y, z, w;
		};
		real_t coord[4];
	};

	Vector4() : x(0), y(0), z(0), w(0) {}
	Vector4(real_t p_x, real_t p_y, real_t p_z, real_t p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}

	bool operator==(const Vector4 &p_v) const { return x == p_v.x && y == p_v.y && z == p_v.z && w == p_v.w; }
	bool operator!=(const Vector4 &p_v) const { return !(*this == p_v); }

	operator String() const;
};

} // namespace godot
