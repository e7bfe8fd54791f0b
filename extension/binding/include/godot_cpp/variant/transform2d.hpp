// SPDX-License-Identifier: MIT
// An affine map of the plane by its columns: image of x, image of y, origin.
#pragma once

#include <godot_cpp/variant/vector2.hpp>

#include <algorithm>
#include <iterator>

namespace godot {

struct Transform2D {
	Vector2 columns[3] = { Vector2(1, 0), Vector2(0, 1), Vector2(0, 0) };

	constexpr Transform2D() = default;
	constexpr Transform2D(real_t p_xx, real_t p_xy, real_t p_yx, real_t p_yy, real_t p_ox, real_t p_oy) :
			columns{ Vector2(p_xx, p_xy), Vector2(p_yx, p_yy), Vector2(p_ox, p_oy) } {}
	constexpr Transform2D(const Vector2 &p_x, const Vector2 &p_y, const Vector2 &p_origin) : columns{ p_x, p_y, p_origin } {}

	bool operator==(const Transform2D &p_other) const { return std::equal(columns, std::end(columns), p_other.columns); }
	bool operator!=(const Transform2D &p_other) const { return !(*this == p_other); }

	operator String() const;
};

} // namespace godot
