// SPDX-License-Identifier: MIT
// Four numbers.
#pragma once

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/forward.hpp>

namespace godot {

struct Vector4 {
	enum Axis {
		AXIS_X,
		AXIS_Y,
		AXIS_Z,
		AXIS_W,
	};

	union {
		struct {
			real_t x, y, z, w;
		};
		real_t coord[4];
	};

	constexpr Vector4() : x(0), y(0), z(0), w(0) {}
	constexpr Vector4(real_t p_x, real_t p_y, real_t p_z, real_t p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}

	real_t &operator[](int p_axis) { return coord[p_axis]; }
	const real_t &operator[](int p_axis) const { return coord[p_axis]; }

	constexpr Vector4 operator+(const Vector4 &p_v) const { return Vector4(x + p_v.x, y + p_v.y, z + p_v.z, w + p_v.w); }
	constexpr Vector4 operator-(const Vector4 &p_v) const { return Vector4(x - p_v.x, y - p_v.y, z - p_v.z, w - p_v.w); }
	constexpr Vector4 operator*(const Vector4 &p_v) const { return Vector4(x * p_v.x, y * p_v.y, z * p_v.z, w * p_v.w); }
	constexpr Vector4 operator/(const Vector4 &p_v) const { return Vector4(x / p_v.x, y / p_v.y, z / p_v.z, w / p_v.w); }
	constexpr Vector4 operator*(real_t p_s) const { return Vector4(x * p_s, y * p_s, z * p_s, w * p_s); }
	constexpr Vector4 operator/(real_t p_s) const { return Vector4(x / p_s, y / p_s, z / p_s, w / p_s); }
	constexpr Vector4 operator-() const { return Vector4(-x, -y, -z, -w); }
	Vector4 &operator+=(const Vector4 &p_v) { return *this = *this + p_v; }
	Vector4 &operator-=(const Vector4 &p_v) { return *this = *this - p_v; }
	Vector4 &operator*=(const Vector4 &p_v) { return *this = *this * p_v; }
	Vector4 &operator/=(const Vector4 &p_v) { return *this = *this / p_v; }
	Vector4 &operator*=(real_t p_s) { return *this = *this * p_s; }
	Vector4 &operator/=(real_t p_s) { return *this = *this / p_s; }
	constexpr bool operator==(const Vector4 &p_v) const { return x == p_v.x && y == p_v.y && z == p_v.z && w == p_v.w; }
	constexpr bool operator!=(const Vector4 &p_v) const { return !(*this == p_v); }
	constexpr bool operator<(const Vector4 &p_v) const {
		return x != p_v.x ? x < p_v.x : (y != p_v.y ? y < p_v.y : (z != p_v.z ? z < p_v.z : w < p_v.w));
	}

	real_t length_squared() const { return x * x + y * y + z * z + w * w; }
	real_t length() const { return std::sqrt(length_squared()); }
	real_t dot(const Vector4 &p_v) const { return x * p_v.x + y * p_v.y + z * p_v.z + w * p_v.w; }
	Vector4 lerp(const Vector4 &p_to, real_t p_weight) const { return *this + (p_to - *this) * p_weight; }
	Vector4 normalized() const { return length_squared() == 0 ? Vector4() : *this / length(); }
	void normalize() { *this = normalized(); }
	bool is_finite() const { return Math::is_finite(x) && Math::is_finite(y) && Math::is_finite(z) && Math::is_finite(w); }

	operator String() const;

#include <godot_cpp/variant/gen/vector4.inc>
};

constexpr Vector4 operator*(real_t p_s, const Vector4 &p_v) {
	return p_v * p_s;
}

} // namespace godot
