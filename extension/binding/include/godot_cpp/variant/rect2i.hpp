// SPDX-License-Identifier: MIT
// A rectangle of whole numbers: a corner and a size.
#pragma once

#include <godot_cpp/variant/rect2.hpp>
#include <godot_cpp/variant/vector2i.hpp>

namespace godot {

struct Rect2i {
	Vector2i position;
	Vector2i size;

	constexpr Rect2i() = default;
	constexpr Rect2i(int32_t p_x, int32_t p_y, int32_t p_width, int32_t p_height) : position(p_x, p_y), size(p_width, p_height) {}
	constexpr Rect2i(const Vector2i &p_position, const Vector2i &p_size) : position(p_position), size(p_size) {}

	const Vector2i &get_position() const { return position; }
	void set_position(const Vector2i &p_position) { position = p_position; }
	const Vector2i &get_size() const { return size; }
	void set_size(const Vector2i &p_size) { size = p_size; }
	Vector2i get_end() const { return position + size; }
	void set_end(const Vector2i &p_end) { size = p_end - position; }
	bool operator==(const Rect2i &p_other) const { return position == p_other.position && size == p_other.size; }
	bool operator!=(const Rect2i &p_other) const { return !(*this == p_other); }

	operator Rect2() const { return Rect2(position, size); }
	operator String() const;

#include <godot_cpp/variant/gen/rect2i.inc>
};

inline Rect2::operator Rect2i() const {
	return Rect2i(position, size);
}

} // namespace godot
