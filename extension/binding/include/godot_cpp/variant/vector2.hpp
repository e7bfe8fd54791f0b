// SPDX-License-Identifier: MIT
// Two numbers: a point or direction of a plane.
#pragma once

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/forward.hpp>

namespace godot {

struct Vector2 {
	union {
		struct {
			real_t x, y;
		};
		struct {
			real_t width, height;
		};
		real_t coord[2];
	};

	Vector2() : x(0), y(0) {}
	Vector2(real_t p_x, real_t p_y) : x(p_x), y(p_y) {}

	real_t &operator[](int p_axis) { return coord[p_axis]; }
	const real_t &operator[](int p_axis) const { return coord[p_axis]; }

	Vector2 operator+(const Vector2 &p_v) const { return Vector2(x + p_v.x, y + p_v.y); }
	Vector2 operator-(const Vector2 &p_v) const { return Vector2(x - p_v.x, y - p_v.y); }
	Vector2 operator*(const Vector2 &p_v) const { return Vector2(x * p_v.x, y * p_v.y); }
	Vector2 operator/(const Vector2 &p_v) const { return Vector2(x / p_v.x, y / p_v.y); }
	Vector2 operator*(real_t p_s) const { return Vector2(x * p_s, y * p_s); }
	Vector2 operator/(real_t p_s) const { return Vector2(x / p_s, y / p_s); }
	Vector2 operator-() const { return Vector2(-x, -y); }
	void operator+=(const Vector2 &p_v) { *this = *this + p_v; }
	void operator-=(const Vector2 &p_v) { *this = *this - p_v; }
	void operator*=(real_t p_s) { *this = *this * p_s; }
	void operator/=(real_t p_s) { *this = *this / p_s; }
	void operator*=(const Vector2 &) = delete; // upstream has these, so a Variant is ambiguous
	void operator/=(const Vector2 &) = delete;
	bool operator==(const Vector2 &p_v) const { return x == p_v.x && y == p_v.y; }
	bool operator!=(const Vector2 &p_v) const { return !(*this == p_v); }

	real_t length() const { return std::sqrt(x * x + y * y); }
	Vector2 abs() const { return Vector2(Math::abs(x), Math::abs(y)); }
	Vector2 floor() const { return Vector2(std::floor(x), std::floor(y)); }
	Vector2 min(const Vector2 &p_v) const { return Vector2(MIN(x, p_v.x), MIN(y, p_v.y)); }
	Vector2 max(const Vector2 &p_v) const { return Vector2(MAX(x, p_v.x), MAX(y, p_v.y)); }
	bool is_finite() const { return Math::is_finite(x) && Math::is_finite(y); }

	operator Vector2i() const;

	operator String() const;
};

inline Vector2 operator*(float p_s, const Vector2 &p_v) {
	return p_v * p_s;
}
inline Vector2 operator*(double p_s, const Vector2 &p_v) {
	return p_v * real_t(p_s);
}

} // namespace godot
