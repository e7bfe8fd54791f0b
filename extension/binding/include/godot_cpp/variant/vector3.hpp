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

	Vector3() : x(0), y(0), z(0) {}
	Vector3(real_t p_x, real_t p_y, real_t p_z) : x(p_x), y(p_y), z(p_z) {}

	real_t &operator[](int p_axis) { return coord[p_axis]; }
	const real_t &operator[](int p_axis) const { return coord[p_axis]; }

	Vector3 operator+(const Vector3 &p_v) const { return Vector3(x + p_v.x, y + p_v.y, z + p_v.z); }
	Vector3 operator-(const Vector3 &p_v) const { return Vector3(x - p_v.x, y - p_v.y, z - p_v.z); }
	Vector3 operator*(const Vector3 &p_v) const { return Vector3(x * p_v.x, y * p_v.y, z * p_v.z); }
	Vector3 operator/(const Vector3 &p_v) const { return Vector3(x / p_v.x, y / p_v.y, z / p_v.z); }
	Vector3 operator*(real_t p_s) const { return Vector3(x * p_s, y * p_s, z * p_s); }
	Vector3 operator/(real_t p_s) const { return Vector3(x / p_s, y / p_s, z / p_s); }
	Vector3 operator-() const { return Vector3(-x, -y, -z); }
	Vector3 &operator+=(const Vector3 &p_v) { return *this = *this + p_v; }
	Vector3 &operator-=(const Vector3 &p_v) { return *this = *this - p_v; }
	Vector3 &operator*=(real_t p_s) { return *this = *this * p_s; }
	Vector3 &operator/=(real_t p_s) { return *this = *this / p_s; }
	Vector3 &operator*=(const Vector3 &) = delete; // upstream has these, so a Variant is ambiguous
	Vector3 &operator/=(const Vector3 &) = delete;
	bool operator==(const Vector3 &p_v) const { return x == p_v.x && y == p_v.y && z == p_v.z; }
	bool operator!=(const Vector3 &p_v) const { return !(*this == p_v); }

	real_t length_squared() const { return dot(*this); }
	real_t length() const { return std::sqrt(length_squared()); }
	real_t dot(const Vector3 &p_v) const { return x * p_v.x + y * p_v.y + z * p_v.z; }
	Vector3 cross(const Vector3 &p_v) const { return Vector3(y * p_v.z - z * p_v.y, z * p_v.x - x * p_v.z, x * p_v.y - y * p_v.x); }
	Vector3 normalized() const { return length_squared() == 0 ? Vector3() : *this / length(); }
	bool is_equal_approx(const Vector3 &p_v) const {
		return Math::is_equal_approx(x, p_v.x) && Math::is_equal_approx(y, p_v.y) && Math::is_equal_approx(z, p_v.z);
	}
	bool is_finite() const { return Math::is_finite(x) && Math::is_finite(y) && Math::is_finite(z); }

	operator String() const;
};

inline Vector3 operator*(float p_s, const Vector3 &p_v) {
	return p_v * p_s;
}
inline Vector3 operator*(double p_s, const Vector3 &p_v) {
	return p_v * real_t(p_s);
}

} // namespace godot
