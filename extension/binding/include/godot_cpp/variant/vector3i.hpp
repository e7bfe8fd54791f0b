// SPDX-License-Identifier: MIT
// Three whole numbers.
#pragma once

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

struct Vector3i {
	enum Axis {
		AXIS_X,
		AXIS_Y,
		AXIS_Z,
	};

	union {
		struct {
			int32_t x, y, z;
		};
		int32_t coord[3];
	};

	constexpr Vector3i() : x(0), y(0), z(0) {}
	constexpr Vector3i(int32_t p_x, int32_t p_y, int32_t p_z) : x(p_x), y(p_y), z(p_z) {}

	int32_t &operator[](int p_axis) { return coord[p_axis]; }
	const int32_t &operator[](int p_axis) const { return coord[p_axis]; }

	constexpr Vector3i operator+(const Vector3i &p_v) const { return Vector3i(x + p_v.x, y + p_v.y, z + p_v.z); }
	constexpr Vector3i operator-(const Vector3i &p_v) const { return Vector3i(x - p_v.x, y - p_v.y, z - p_v.z); }
	constexpr Vector3i operator*(const Vector3i &p_v) const { return Vector3i(x * p_v.x, y * p_v.y, z * p_v.z); }
	constexpr Vector3i operator/(const Vector3i &p_v) const { return Vector3i(x / p_v.x, y / p_v.y, z / p_v.z); }
	constexpr Vector3i operator%(const Vector3i &p_v) const { return Vector3i(x % p_v.x, y % p_v.y, z % p_v.z); }
	constexpr Vector3i operator*(int32_t p_s) const { return Vector3i(x * p_s, y * p_s, z * p_s); }
	constexpr Vector3i operator/(int32_t p_s) const { return Vector3i(x / p_s, y / p_s, z / p_s); }
	constexpr Vector3i operator%(int32_t p_s) const { return Vector3i(x % p_s, y % p_s, z % p_s); }
	constexpr Vector3i operator-() const { return Vector3i(-x, -y, -z); }
	Vector3i &operator+=(const Vector3i &p_v) { return *this = *this + p_v; }
	Vector3i &operator-=(const Vector3i &p_v) { return *this = *this - p_v; }
	Vector3i &operator*=(const Vector3i &p_v) { return *this = *this * p_v; }
	Vector3i &operator/=(const Vector3i &p_v) { return *this = *this / p_v; }
	Vector3i &operator*=(int32_t p_s) { return *this = *this * p_s; }
	Vector3i &operator/=(int32_t p_s) { return *this = *this / p_s; }
	constexpr bool operator==(const Vector3i &p_v) const { return x == p_v.x && y == p_v.y && z == p_v.z; }
	constexpr bool operator!=(const Vector3i &p_v) const { return !(*this == p_v); }
	constexpr bool operator<(const Vector3i &p_v) const { return x != p_v.x ? x < p_v.x : (y != p_v.y ? y < p_v.y : z < p_v.z); }

	int64_t length_squared() const { return int64_t(x) * x + int64_t(y) * y + int64_t(z) * z; }
	double length() const { return std::sqrt(static_cast<double>(length_squared())); }
	Vector3i abs() const { return Vector3i(Math::abs(x), Math::abs(y), Math::abs(z)); }
	Vector3i sign() const { return Vector3i(SIGN(x), SIGN(y), SIGN(z)); }
	Vector3i min(const Vector3i &p_v) const { return Vector3i(MIN(x, p_v.x), MIN(y, p_v.y), MIN(z, p_v.z)); }
	Vector3i max(const Vector3i &p_v) const { return Vector3i(MAX(x, p_v.x), MAX(y, p_v.y), MAX(z, p_v.z)); }
	Vector3i clamp(const Vector3i &p_min, const Vector3i &p_max) const { return max(p_min).min(p_max); }
	operator Vector3() const { return Vector3(static_cast<real_t>(x), static_cast<real_t>(y), static_cast<real_t>(z)); }

	operator String() const;

#include <godot_cpp/variant/gen/vector3i.inc>
};

inline Vector3::operator Vector3i() const {
	return Vector3i(static_cast<int32_t>(x), static_cast<int32_t>(y), static_cast<int32_t>(z));
}

constexpr Vector3i operator*(int32_t p_s, const Vector3i &p_v) {
	return p_v * p_s;
}

} // namespace godot
