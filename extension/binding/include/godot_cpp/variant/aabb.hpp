// SPDX-License-Identifier: MIT
// An axis-aligned box: a corner and a size.
#pragma once

#include <godot_cpp/variant/vector3.hpp>

namespace godot {

struct AABB {
	Vector3 position;
	Vector3 size;

	AABB() = default;
	AABB(const Vector3 &p_position, const Vector3 &p_size) : position(p_position), size(p_size) {}

	Vector3 get_end() const { return position + size; }
	bool is_finite() const { return position.is_finite() && size.is_finite(); }
	bool operator==(const AABB &p_box) const { return position == p_box.position && size == p_box.size; }
	bool operator!=(const AABB &p_box) const { return !(*this == p_box); }

	operator String() const;
};

} // namespace godot
