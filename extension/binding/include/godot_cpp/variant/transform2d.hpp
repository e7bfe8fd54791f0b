// SPDX-License-Identifier: MIT
// An affine map of the plane by its columns: image of x, image of y, origin.
#pragma once

#include <godot_cpp/variant/rect2.hpp>
#include <godot_cpp/variant/vector2.hpp>

namespace godot {

struct Transform2D {
	Vector2 columns[3] = { Vector2(1, 0), Vector2(0, 1), Vector2(0, 0) };

	constexpr Transform2D() = default;
	constexpr Transform2D(real_t p_xx, real_t p_xy, real_t p_yx, real_t p_yy, real_t p_ox, real_t p_oy) :
			columns{ Vector2(p_xx, p_xy), Vector2(p_yx, p_yy), Vector2(p_ox, p_oy) } {}
	constexpr Transform2D(const Vector2 &p_x, const Vector2 &p_y, const Vector2 &p_origin) : columns{ p_x, p_y, p_origin } {}
	Transform2D(real_t p_angle, const Vector2 &p_origin) :
			columns{ Vector2(std::cos(p_angle), std::sin(p_angle)), Vector2(-std::sin(p_angle), std::cos(p_angle)), p_origin } {}

	Vector2 &operator[](int p_column) { return columns[p_column]; }
	const Vector2 &operator[](int p_column) const { return columns[p_column]; }
	const Vector2 &get_origin() const { return columns[2]; }
	void set_origin(const Vector2 &p_origin) { columns[2] = p_origin; }
	Vector2 basis_xform(const Vector2 &p_v) const { return columns[0] * p_v.x + columns[1] * p_v.y; }
	Vector2 xform(const Vector2 &p_v) const { return basis_xform(p_v) + columns[2]; }
	Vector2 operator*(const Vector2 &p_v) const { return xform(p_v); }
	Transform2D operator*(const Transform2D &p_t) const { return Transform2D(basis_xform(p_t[0]), basis_xform(p_t[1]), xform(p_t[2])); }
	Transform2D &operator*=(const Transform2D &p_t) { return *this = *this * p_t; }
	bool operator==(const Transform2D &p_t) const { return columns[0] == p_t[0] && columns[1] == p_t[1] && columns[2] == p_t[2]; }
	bool operator!=(const Transform2D &p_t) const { return !(*this == p_t); }

	operator String() const;

#include <godot_cpp/variant/gen/transform2d.inc>
};

} // namespace godot
