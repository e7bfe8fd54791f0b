// SPDX-License-Identifier: MIT
// Three numbers: a point or direction of space.
#pragma once

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/forward.hpp>

namespace godot {

struct Vector3 {
	enum Axis {
		AXIS_X,
		AXIS_Y,
		AXIS_Z,
	};

	union {
		struct {
			real_t x, y, z;
		};
		real_t coord[3];
	};

	constexpr Vector3() : x(0), y(0), z(0) {}
	constexpr Vector3(real_t p_x, real_t p_y, real_t p_z) : x(p_x), y(p_y), z(p_z) {}

	real_t &operator[](int p_axis) { return coord[p_axis]; }
	const real_t &operator[](int p_axis) const { return coord[p_axis]; }

	constexpr Vector3 operator+(const Vector3 &p_v) const { return Vector3(x + p_v.x, y + p_v.y, z + p_v.z); }
	constexpr Vector3 operator-(const Vector3 &p_v) const { return Vector3(x - p_v.x, y - p_v.y, z - p_v.z); }
	constexpr Vector3 operator*(const Vector3 &p_v) const { return Vector3(x * p_v.x, y * p_v.y, z * p_v.z); }
	constexpr Vector3 operator/(const Vector3 &p_v) const { return Vector3(x / p_v.x, y / p_v.y, z / p_v.z); }
	constexpr Vector3 operator*(real_t p_s) const { return Vector3(x * p_s, y * p_s, z * p_s); }
	constexpr Vector3 operator/(real_t p_s) const { return Vector3(x / p_s, y / p_s, z / p_s); }
	constexpr Vector3 operator-() const { return Vector3(-x, -y, -z); }
	Vector3 &operator+=(const Vector3 &p_v) { return *this = *this + p_v; }
	Vector3 &operator-=(const Vector3 &p_v) { return *this = *this - p_v; }
	Vector3 &operator*=(const Vector3 &p_v) { return *this = *this * p_v; }
	Vector3 &operator/=(const Vector3 &p_v) { return *this = *this / p_v; }
	Vector3 &operator*=(real_t p_s) { return *this = *this * p_s; }
	Vector3 &operator/=(real_t p_s) { return *this = *this / p_s; }
	constexpr bool operator==(const Vector3 &p_v) const { return x == p_v.x && y == p_v.y && z == p_v.z; }
	constexpr bool operator!=(const Vector3 &p_v) const { return !(*this == p_v); }
	constexpr bool operator<(const Vector3 &p_v) const { return x != p_v.x ? x < p_v.x : (y != p_v.y ? y < p_v.y : z < p_v.z); }

	real_t length_squared() const { return x * x + y * y + z * z; }
	real_t length() const { return std::sqrt(length_squared()); }
	real_t dot(const Vector3 &p_v) const { return x * p_v.x + y * p_v.y + z * p_v.z; }
	Vector3 cross(const Vector3 &p_v) const { return Vector3(y * p_v.z - z * p_v.y, z * p_v.x - x * p_v.z, x * p_v.y - y * p_v.x); }
	real_t distance_to(const Vector3 &p_v) const { return (p_v - *this).length(); }
	real_t distance_squared_to(const Vector3 &p_v) const { return (p_v - *this).length_squared(); }
	void zero() { *this = Vector3(); }
	void normalize() { *this = normalized(); }
	Vector3 normalized() const;
	bool is_normalized() const { return Math::is_equal_approx(length_squared(), real_t(1), real_t(UNIT_EPSILON)); }
	Vector3 inverse() const { return Vector3(1 / x, 1 / y, 1 / z); }
	Vector3 direction_to(const Vector3 &p_to) const { return (p_to - *this).normalized(); }
	Vector3 lerp(const Vector3 &p_to, real_t p_weight) const { return *this + (p_to - *this) * p_weight; }
	Vector3 project(const Vector3 &p_to) const { return p_to * (dot(p_to) / p_to.length_squared()); }
	Vector3 slide(const Vector3 &p_normal) const { return *this - p_normal * dot(p_normal); }
	Vector3 abs() const { return Vector3(Math::abs(x), Math::abs(y), Math::abs(z)); }
	Vector3 sign() const { return Vector3(SIGN(x), SIGN(y), SIGN(z)); }
	Vector3 floor() const { return Vector3(std::floor(x), std::floor(y), std::floor(z)); }
	Vector3 ceil() const { return Vector3(std::ceil(x), std::ceil(y), std::ceil(z)); }
	Vector3 round() const { return Vector3(std::round(x), std::round(y), std::round(z)); }
	Vector3 min(const Vector3 &p_v) const { return Vector3(MIN(x, p_v.x), MIN(y, p_v.y), MIN(z, p_v.z)); }
	Vector3 max(const Vector3 &p_v) const { return Vector3(MAX(x, p_v.x), MAX(y, p_v.y), MAX(z, p_v.z)); }
	Vector3 minf(real_t p_s) const { return min(Vector3(p_s, p_s, p_s)); }
	Vector3 maxf(real_t p_s) const { return max(Vector3(p_s, p_s, p_s)); }
	Vector3 clamp(const Vector3 &p_min, const Vector3 &p_max) const;
	Vector3 clampf(real_t p_min, real_t p_max) const { return clamp(Vector3(p_min, p_min, p_min), Vector3(p_max, p_max, p_max)); }
	Axis min_axis_index() const { return x < y ? (x < z ? AXIS_X : AXIS_Z) : (y < z ? AXIS_Y : AXIS_Z); }
	Axis max_axis_index() const { return x < y ? (y < z ? AXIS_Z : AXIS_Y) : (x < z ? AXIS_Z : AXIS_X); }
	bool is_equal_approx(const Vector3 &p_v) const {
		return Math::is_equal_approx(x, p_v.x) && Math::is_equal_approx(y, p_v.y) && Math::is_equal_approx(z, p_v.z);
	}
	bool is_zero_approx() const { return Math::is_zero_approx(x) && Math::is_zero_approx(y) && Math::is_zero_approx(z); }
	bool is_finite() const { return Math::is_finite(x) && Math::is_finite(y) && Math::is_finite(z); }

	operator String() const;
	operator Vector3i() const;

#include <godot_cpp/variant/gen/vector3.inc>
};

constexpr Vector3 operator*(float p_s, const Vector3 &p_v) {
	return p_v * p_s;
}
constexpr Vector3 operator*(double p_s, const Vector3 &p_v) {
	return p_v * real_t(p_s);
}
constexpr Vector3 operator*(int32_t p_s, const Vector3 &p_v) {
	return p_v * real_t(p_s);
}
constexpr Vector3 operator*(int64_t p_s, const Vector3 &p_v) {
	return p_v * real_t(p_s);
}

inline Vector3 Vector3::normalized() const {
	const real_t squared = length_squared();
	return squared == 0 ? Vector3() : *this / std::sqrt(squared);
}

inline Vector3 Vector3::clamp(const Vector3 &p_min, const Vector3 &p_max) const {
	return Vector3(CLAMP(x, p_min.x, p_max.x), CLAMP(y, p_min.y, p_max.y), CLAMP(z, p_min.z, p_max.z));
}

inline Vector3 vec3_cross(const Vector3 &p_a, const Vector3 &p_b) {
	return p_a.cross(p_b);
}

} // namespace godot
