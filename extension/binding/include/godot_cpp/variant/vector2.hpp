// SPDX-License-Identifier: MIT
// Two numbers: a point or direction of a plane.
#pragma once

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/forward.hpp>

namespace godot {

struct Vector2 {
	enum Axis {
		AXIS_X,
		AXIS_Y,
	};

	union {
		struct {
			real_t x, y;
		};
		struct {
			real_t width, height;
		};
		real_t coord[2];
	};

	constexpr Vector2() : x(0), y(0) {}
	constexpr Vector2(real_t p_x, real_t p_y) : x(p_x), y(p_y) {}

	real_t &operator[](int p_axis) { return coord[p_axis]; }
	const real_t &operator[](int p_axis) const { return coord[p_axis]; }

	constexpr Vector2 operator+(const Vector2 &p_v) const { return Vector2(x + p_v.x, y + p_v.y); }
	constexpr Vector2 operator-(const Vector2 &p_v) const { return Vector2(x - p_v.x, y - p_v.y); }
	constexpr Vector2 operator*(const Vector2 &p_v) const { return Vector2(x * p_v.x, y * p_v.y); }
	constexpr Vector2 operator/(const Vector2 &p_v) const { return Vector2(x / p_v.x, y / p_v.y); }
	constexpr Vector2 operator*(real_t p_s) const { return Vector2(x * p_s, y * p_s); }
	constexpr Vector2 operator/(real_t p_s) const { return Vector2(x / p_s, y / p_s); }
	constexpr Vector2 operator-() const { return Vector2(-x, -y); }
	Vector2 &operator+=(const Vector2 &p_v) { return *this = *this + p_v; }
	Vector2 &operator-=(const Vector2 &p_v) { return *this = *this - p_v; }
	Vector2 &operator*=(const Vector2 &p_v) { return *this = *this * p_v; }
	Vector2 &operator/=(const Vector2 &p_v) { return *this = *this / p_v; }
	Vector2 &operator*=(real_t p_s) { return *this = *this * p_s; }
	Vector2 &operator/=(real_t p_s) { return *this = *this / p_s; }
	constexpr bool operator==(const Vector2 &p_v) const { return x == p_v.x && y == p_v.y; }
	constexpr bool operator!=(const Vector2 &p_v) const { return !(*this == p_v); }
	constexpr bool operator<(const Vector2 &p_v) const { return x == p_v.x ? y < p_v.y : x < p_v.x; }

	real_t length_squared() const { return x * x + y * y; }
	real_t length() const { return std::sqrt(length_squared()); }
	real_t dot(const Vector2 &p_v) const { return x * p_v.x + y * p_v.y; }
	real_t cross(const Vector2 &p_v) const { return x * p_v.y - y * p_v.x; }
	real_t distance_to(const Vector2 &p_v) const { return (p_v - *this).length(); }
	real_t distance_squared_to(const Vector2 &p_v) const { return (p_v - *this).length_squared(); }
	real_t angle() const { return std::atan2(y, x); }
	real_t aspect() const { return width / height; }
	void normalize() { *this = normalized(); }
	Vector2 normalized() const;
	Vector2 rotated(real_t p_angle) const;
	Vector2 orthogonal() const { return Vector2(y, -x); }
	Vector2 lerp(const Vector2 &p_to, real_t p_weight) const { return *this + (p_to - *this) * p_weight; }
	Vector2 abs() const { return Vector2(Math::abs(x), Math::abs(y)); }
	Vector2 floor() const { return Vector2(std::floor(x), std::floor(y)); }
	Vector2 ceil() const { return Vector2(std::ceil(x), std::ceil(y)); }
	Vector2 round() const { return Vector2(std::round(x), std::round(y)); }
	Vector2 min(const Vector2 &p_v) const { return Vector2(MIN(x, p_v.x), MIN(y, p_v.y)); }
	Vector2 max(const Vector2 &p_v) const { return Vector2(MAX(x, p_v.x), MAX(y, p_v.y)); }
	Vector2 clamp(const Vector2 &p_min, const Vector2 &p_max) const {
		return Vector2(CLAMP(x, p_min.x, p_max.x), CLAMP(y, p_min.y, p_max.y));
	}
	bool is_equal_approx(const Vector2 &p_v) const { return Math::is_equal_approx(x, p_v.x) && Math::is_equal_approx(y, p_v.y); }
	bool is_zero_approx() const { return Math::is_zero_approx(x) && Math::is_zero_approx(y); }
	bool is_finite() const { return Math::is_finite(x) && Math::is_finite(y); }

	operator String() const;
	operator Vector2i() const;

#include <godot_cpp/variant/gen/vector2.inc>
};

using Size2 = Vector2;
using Point2 = Vector2;

constexpr Vector2 operator*(float p_s, const Vector2 &p_v) {
	return p_v * p_s;
}
constexpr Vector2 operator*(double p_s, const Vector2 &p_v) {
	return p_v * real_t(p_s);
}
constexpr Vector2 operator*(int32_t p_s, const Vector2 &p_v) {
	return p_v * real_t(p_s);
}
constexpr Vector2 operator*(int64_t p_s, const Vector2 &p_v) {
	return p_v * real_t(p_s);
}

inline Vector2 Vector2::normalized() const {
	const real_t squared = length_squared();
	return squared == 0 ? Vector2() : *this / std::sqrt(squared);
}

inline Vector2 Vector2::rotated(real_t p_angle) const {
	const real_t sine = std::sin(p_angle);
	const real_t cosine = std::cos(p_angle);
	return Vector2(x * cosine - y * sine, x * sine + y * cosine);
}

} // namespace godot
