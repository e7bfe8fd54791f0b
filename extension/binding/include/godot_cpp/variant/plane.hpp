// SPDX-License-Identifier: MIT
// A plane: the points p with dot(normal, p) == d. "Over" is the side the normal points to.
#pragma once

#include <godot_cpp/variant/vector3.hpp>

namespace godot {

struct Plane {
	Vector3 normal;
	real_t d = 0;

	Plane() = default;
	Plane(real_t p_a, real_t p_b, real_t p_c, real_t p_d) : normal(p_a, p_b, p_c), d(p_d) {}
	Plane(const Vector3 &) = delete; // upstream has it, so a Variant is ambiguous

	bool operator==(const Plane &p_other) const { return normal == p_other.normal && d == p_other.d; }
	bool operator!=(const Plane &p_other) const { return !(*this == p_other); }

	operator String() const;
};

} // namespace godot
