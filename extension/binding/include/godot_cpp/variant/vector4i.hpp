// SPDX-License-Identifier: MIT
// Four whole numbers.
#pragma once

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/forward.hpp>

namespace godot {

struct Vector4i {
	enum Axis {
		AXIS_X,
		AXIS_Y,
		AXIS_Z,
		AXIS_W,
	};

	union {
		struct {
			int32_t x, y, z, w;
		};
		int32_t coord[4];
	};

	constexpr Vector4i() : x(0), y(0), z(0), w(0) {}
	constexpr Vector4i(int32_t p_x, int32_t p_y, int32_t p_z, int32_t p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}

	int32_t &operator[](int p_axis) { return coord[p_axis]; }
	const int32_t &operator[](int p_axis) const { return coord[p_axis]; }

	constexpr Vector4i operator+(const Vector4i &p_v) const { return Vector4i(x + p_v.x, y + p_v.y, z + p_v.z, w + p_v.w); }
	constexpr Vector4i operator-(const Vector4i &p_v) const { return Vector4i(x - p_v.x, y - p_v.y, z - p_v.z, w - p_v.w); }
	constexpr Vector4i operator*(const Vector4i &p_v) const { return Vector4i(x * p_v.x, y * p_v.y, z * p_v.z, w * p_v.w); }
	constexpr Vector4i operator/(const Vector4i &p_v) const { return Vector4i(x / p_v.x, y / p_v.y, z / p_v.z, w / p_v.w); }
	constexpr Vector4i operator%(const Vector4i &p_v) const { return Vector4i(x % p_v.x, y % p_v.y, z % p_v.z, w % p_v.w); }
	constexpr Vector4i operator*(int32_t p_s) const { return Vector4i(x * p_s, y * p_s, z * p_s, w * p_s); }
	constexpr Vector4i operator/(int32_t p_s) const { return Vector4i(x / p_s, y / p_s, z / p_s, w / p_s); }
	constexpr Vector4i operator%(int32_t p_s) const { return Vector4i(x % p_s, y % p_s, z % p_s, w % p_s); }
	constexpr Vector4i operator-() const { return Vector4i(-x, -y, -z, -w); }
	Vector4i &operator+=(const Vector4i &p_v) { return *this = *this + p_v; }
	Vector4i &operator-=(const Vector4i &p_v) { return *this = *this - p_v; }
	Vector4i &operator*=(const Vector4i &p_v) { return *this = *this * p_v; }
	Vector4i &operator/=(const Vector4i &p_v) { return *this = *this / p_v; }
	Vector4i &operator*=(int32_t p_s) { return *this = *this * p_s; }
	Vector4i &operator/=(int32_t p_s) { return *this = *this / p_s; }
	constexpr bool operator==(const Vector4i &p_v) const { return x == p_v.x && y == p_v.y && z == p_v.z && w == p_v.w; }
	constexpr bool operator!=(const Vector4i &p_v) const { return !(*this == p_v); }
	constexpr bool operator<(const Vector4i &p_v) const {
		return x != p_v.x ? x < p_v.x : (y != p_v.y ? y < p_v.y : (z != p_v.z ? z < p_v.z : w < p_v.w));
	}

	int64_t length_squared() const { return int64_t(x) * x + int64_t(y) * y + int64_t(z) * z + int64_t(w) * w; }
	double length() const { return std::sqrt(static_cast<double>(length_squared())); }
	Vector4i abs() const { return Vector4i(Math::abs(x), Math::abs(y), Math::abs(z), Math::abs(w)); }
	Vector4i sign() const { return Vector4i(SIGN(x), SIGN(y), SIGN(z), SIGN(w)); }
	Vector4i min(const Vector4i &p_v) const { return Vector4i(MIN(x, p_v.x), MIN(y, p_v.y), MIN(z, p_v.z), MIN(w, p_v.w)); }
	Vector4i max(const Vector4i &p_v) const { return Vector4i(MAX(x, p_v.x), MAX(y, p_v.y), MAX(z, p_v.z), MAX(w, p_v.w)); }
	Vector4i clamp(const Vector4i &p_min, const Vector4i &p_max) const { return max(p_min).min(p_max); }

	operator String() const;

#include <godot_cpp/variant/gen/vector4i.inc>
};

constexpr Vector4i operator*(int32_t p_s, const Vector4i &p_v) {
	return p_v * p_s;
}

} // namespace godot
