// SPDX-License-Identifier: MIT
// A rectangle of the plane: a corner and a size.
#pragma once

#include <godot_cpp/variant/vector2.hpp>

namespace godot {

struct Rect2 {
	Vector2 position;
	Vector2 size;

	Rect2() = default;
	Rect2(real_t p_x, real_t p_y, real_t p_width, real_t p_height) : position(p_x, p_y), size(p_width, p_height) {}
	Rect2(const Vector2 &p_position, const Vector2 &p_size) : position(p_position), size(p_size) {}

	Vector2 get_end() const { return position + size; }
	bool has_area() const { return size.x > 0 && size.y > 0; }
	Rect2 abs() const { return Rect2(position + size.min(Vector2()), size.abs()); }
	Rect2 merge(const Rect2 &p_other) const {
		const Vector2 low = position.min(p_other.position);
		return Rect2(low, get_end().max(p_other.get_end()) - low);
	}
	bool is_finite() const { return position.is_finite() && size.is_finite(); }
	bool operator==(const Rect2 &p_other) const { return position == p_other.position && size == p_other.size; }
	bool operator!=(const Rect2 &p_other) const { return !(*this == p_other); }

	operator String() const;
};

} // namespace godot
