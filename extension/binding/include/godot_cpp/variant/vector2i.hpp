// SPDX-License-Identifier: MIT
// Two whole numbers.
#pragma once

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/vector2.hpp>

namespace godot {

struct Vector2i {
	union {
		struct {
			int32_t x, y;
		};
		struct {
			int32_t width, height;
		};
		int32_t coord[2];
	};

	Vector2i() : x(0), y(0) {}
	Vector2i(int32_t p_x, int32_t p_y) : x(p_x), y(p_y) {}

	int32_t &operator[](int p_axis) { return coord[p_axis]; }
	const int32_t &operator[](int p_axis) const { return coord[p_axis]; }

	Vector2i operator+(const Vector2i &p_v) const { return Vector2i(x + p_v.x, y + p_v.y); }
	Vector2i operator-(const Vector2i &p_v) const { return Vector2i(x - p_v.x, y - p_v.y); }
	Vector2i operator*(const Vector2i &p_v) const { return Vector2i(x * p_v.x, y * p_v.y); }
	Vector2i operator/(const Vector2i &p_v) const { return Vector2i(x / p_v.x, y / p_v.y); }
	Vector2i operator*(int32_t p_s) const { return Vector2i(x * p_s, y * p_s); }
	Vector2i operator/(int32_t p_s) const { return Vector2i(x / p_s, y / p_s); }
	Vector2i operator-() const { return Vector2i(-x, -y); }
	void operator+=(const Vector2i &p_v) { *this = *this + p_v; }
	void operator-=(const Vector2i &p_v) { *this = *this - p_v; }
	void operator*=(int32_t p_s) { *this = *this * p_s; }
	void operator/=(int32_t p_s) { *this = *this / p_s; }
	bool operator==(const Vector2i &p_v) const { return x == p_v.x && y == p_v.y; }
	bool operator!=(const Vector2i &p_v) const { return !(*this == p_v); }

	operator Vector2() const { return Vector2(static_cast<real_t>(x), static_cast<real_t>(y)); }

	operator String() const;
};

inline Vector2::operator Vector2i() const {
	return Vector2i(static_cast<int32_t>(x), static_cast<int32_t>(y));
}

} // namespace godot
