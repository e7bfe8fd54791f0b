// SPDX-License-Identifier: MIT
// Two whole numbers.
#pragma once

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/vector2.hpp>

namespace godot {

struct Vector2i {
	enum Axis {
		AXIS_X,
		AXIS_Y,
	};

	union {
		struct {
			int32_t x, y;
		};
		struct {
			int32_t width, height;
		};
		int32_t coord[2];
	};

	constexpr Vector2i() : x(0), y(0) {}
	constexpr Vector2i(int32_t p_x, int32_t p_y) : x(p_x), y(p_y) {}

	int32_t &operator[](int p_axis) { return coord[p_axis]; }
	const int32_t &operator[](int p_axis) const { return coord[p_axis]; }

	constexpr Vector2i operator+(const Vector2i &p_v) const { return Vector2i(x + p_v.x, y + p_v.y); }
	constexpr Vector2i operator-(const Vector2i &p_v) const { return Vector2i(x - p_v.x, y - p_v.y); }
	constexpr Vector2i operator*(const Vector2i &p_v) const { return Vector2i(x * p_v.x, y * p_v.y); }
	constexpr Vector2i operator/(const Vector2i &p_v) const { return Vector2i(x / p_v.x, y / p_v.y); }
	constexpr Vector2i operator%(const Vector2i &p_v) const { return Vector2i(x % p_v.x, y % p_v.y); }
	constexpr Vector2i operator*(int32_t p_s) const { return Vector2i(x * p_s, y * p_s); }
	constexpr Vector2i operator/(int32_t p_s) const { return Vector2i(x / p_s, y / p_s); }
	constexpr Vector2i operator%(int32_t p_s) const { return Vector2i(x % p_s, y % p_s); }
	constexpr Vector2i operator-() const { return Vector2i(-x, -y); }
	Vector2i &operator+=(const Vector2i &p_v) { return *this = *this + p_v; }
	Vector2i &operator-=(const Vector2i &p_v) { return *this = *this - p_v; }
	Vector2i &operator*=(const Vector2i &p_v) { return *this = *this * p_v; }
	Vector2i &operator/=(const Vector2i &p_v) { return *this = *this / p_v; }
	Vector2i &operator*=(int32_t p_s) { return *this = *this * p_s; }
	Vector2i &operator/=(int32_t p_s) { return *this = *this / p_s; }
	constexpr bool operator==(const Vector2i &p_v) const { return x == p_v.x && y == p_v.y; }
	constexpr bool operator!=(const Vector2i &p_v) const { return !(*this == p_v); }
	constexpr bool operator<(const Vector2i &p_v) const { return x != p_v.x ? x < p_v.x : y < p_v.y; }

	int64_t length_squared() const { return int64_t(x) * x + int64_t(y) * y; }
	double length() const { return std::sqrt(static_cast<double>(length_squared())); }
	Vector2i abs() const { return Vector2i(Math::abs(x), Math::abs(y)); }
	Vector2i sign() const { return Vector2i(SIGN(x), SIGN(y)); }
	Vector2i min(const Vector2i &p_v) const { return Vector2i(MIN(x, p_v.x), MIN(y, p_v.y)); }
	Vector2i max(const Vector2i &p_v) const { return Vector2i(MAX(x, p_v.x), MAX(y, p_v.y)); }
	Vector2i clamp(const Vector2i &p_min, const Vector2i &p_max) const { return max(p_min).min(p_max); }
	operator Vector2() const { return Vector2(static_cast<real_t>(x), static_cast<real_t>(y)); }

	operator String() const;

#include <godot_cpp/variant/gen/vector2i.inc>
};

using Size2i = Vector2i;
using Point2i = Vector2i;

inline Vector2::operator Vector2i() const {
	return Vector2i(static_cast<int32_t>(x), static_cast<int32_t>(y));
}

constexpr Vector2i operator*(int32_t p_s, const Vector2i &p_v) {
	return p_v * p_s;
}

} // namespace godot
