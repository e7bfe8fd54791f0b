// SPDX-License-Identifier: MIT
// A rectangle of whole numbers: a corner and a size.
#pragma once

#include <godot_cpp/variant/vector2i.hpp>

namespace godot {

struct Rect2i {
	Vector2i position;
	Vector2i size;

	Rect2i() = default;
	Rect2i(int32_t p_x, int32_t p_y, int32_t p_width, int32_t p_height) : position(p_x, p_y), size(p_width, p_height) {}
	Rect2i(const Vector2i &p_position, const Vector2i &p_size) : position(p_position), size(p_size) {}

	bool operator==(const Rect2i &p_other) const { return position == p_other.position && size == p_other.size; }
	bool operator!=(const Rect2i &p_other) const { return !(*this == p_other); }

	operator String() const;
};

} // namespace godot
