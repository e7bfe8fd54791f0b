// SPDX-License-Identifier: MIT
// A rotation as a unit quaternion x, y, z, w.
#pragma once

#include <godot_cpp/variant/vector3.hpp>

namespace godot {

struct Quaternion {
	union {
		struct {
			real_t x, y, z, w;
		};
		real_t components[4];
	};

	Quaternion() : x(0), y(0), z(0), w(1) {}
	Quaternion(real_t p_x, real_t p_y, real_t p_z, real_t p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}
	Quaternion(const Quaternion &p_q) : x(p_q.x), y(p_q.y), z(p_q.z), w(p_q.w) {} // as upstream's, not trivial
	void operator=(const Quaternion &p_q) {
		x = p_q.x;
		y = p_q.y;
		z = p_q.z;
		w = p_q.w;
	}

	bool operator==(const Quaternion &p_q) const { return x == p_q.x && y == p_q.y && z == p_q.z && w == p_q.w; }
	bool operator!=(const Quaternion &p_q) const { return !(*this == p_q); }

	operator String() const;
};

} // namespace godot
