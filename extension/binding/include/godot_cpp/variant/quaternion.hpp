// SPDX-License-Identifier: MIT
// A rotation as a unit quaternion x, y, z, w.
#pragma once

#include <godot_cpp/variant/vector3.hpp>

namespace godot {

struct Quaternion {
	union {
		struct {
			real_t x, y, z, w;
		};
		real_t components[4];
	};

	constexpr Quaternion() : x(0), y(0), z(0), w(1) {}
	constexpr Quaternion(real_t p_x, real_t p_y, real_t p_z, real_t p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}
	// The axis must be of length 1.
	Quaternion(const Vector3 &p_axis, real_t p_angle) {
		const Vector3 v = p_axis * std::sin(p_angle / 2);
		*this = Quaternion(v.x, v.y, v.z, std::cos(p_angle / 2));
	}
	// The shortest rotation between two unit vectors.
	Quaternion(const Vector3 &p_from, const Vector3 &p_to);

	real_t &operator[](int p_index) { return components[p_index]; }
	const real_t &operator[](int p_index) const { return components[p_index]; }

	constexpr Quaternion operator+(const Quaternion &p_q) const { return Quaternion(x + p_q.x, y + p_q.y, z + p_q.z, w + p_q.w); }
	constexpr Quaternion operator-(const Quaternion &p_q) const { return Quaternion(x - p_q.x, y - p_q.y, z - p_q.z, w - p_q.w); }
	constexpr Quaternion operator*(real_t p_s) const { return Quaternion(x * p_s, y * p_s, z * p_s, w * p_s); }
	constexpr Quaternion operator/(real_t p_s) const { return *this * (1 / p_s); }
	constexpr Quaternion operator-() const { return Quaternion(-x, -y, -z, -w); }
	constexpr Quaternion operator*(const Quaternion &p_q) const {
		return Quaternion(w * p_q.x + x * p_q.w + y * p_q.z - z * p_q.y, w * p_q.y + y * p_q.w + z * p_q.x - x * p_q.z,
				w * p_q.z + z * p_q.w + x * p_q.y - y * p_q.x, w * p_q.w - x * p_q.x - y * p_q.y - z * p_q.z);
	}
	Quaternion &operator+=(const Quaternion &p_q) { return *this = *this + p_q; }
	Quaternion &operator-=(const Quaternion &p_q) { return *this = *this - p_q; }
	Quaternion &operator*=(const Quaternion &p_q) { return *this = *this * p_q; }
	Quaternion &operator*=(real_t p_s) { return *this = *this * p_s; }
	Quaternion &operator/=(real_t p_s) { return *this = *this / p_s; }
	constexpr bool operator==(const Quaternion &p_q) const { return x == p_q.x && y == p_q.y && z == p_q.z && w == p_q.w; }
	constexpr bool operator!=(const Quaternion &p_q) const { return !(*this == p_q); }

	real_t dot(const Quaternion &p_q) const { return x * p_q.x + y * p_q.y + z * p_q.z + w * p_q.w; }
	real_t length_squared() const { return dot(*this); }
	real_t length() const { return std::sqrt(length_squared()); }
	void normalize() { *this = normalized(); }
	Quaternion normalized() const { return *this / length(); }
	bool is_normalized() const { return Math::is_equal_approx(length_squared(), real_t(1), real_t(UNIT_EPSILON)); }
	Quaternion inverse() const { return Quaternion(-x, -y, -z, w); }
	Vector3 xform(const Vector3 &p_v) const {
		const Vector3 u(x, y, z);
		const Vector3 uv = u.cross(p_v);
		return p_v + (uv * w + u.cross(uv)) * 2;
	}
	Vector3 xform_inv(const Vector3 &p_v) const { return inverse().xform(p_v); }
	Vector3 operator*(const Vector3 &p_v) const { return xform(p_v); }
	void get_axis_angle(Vector3 &r_axis, real_t &r_angle) const {
		r_axis = get_axis();
		r_angle = get_angle();
	}
	bool is_equal_approx(const Quaternion &p_q) const {
		return Math::is_equal_approx(x, p_q.x) && Math::is_equal_approx(y, p_q.y) && Math::is_equal_approx(z, p_q.z) &&
				Math::is_equal_approx(w, p_q.w);
	}
	bool is_finite() const { return Math::is_finite(x) && Math::is_finite(y) && Math::is_finite(z) && Math::is_finite(w); }

	operator String() const;

#include <godot_cpp/variant/gen/quaternion.inc>
};

constexpr Quaternion operator*(real_t p_s, const Quaternion &p_q) {
	return p_q * p_s;
}

inline Quaternion::Quaternion(const Vector3 &p_from, const Vector3 &p_to) {
	const Vector3 axis = p_from.cross(p_to);
	const real_t cosine = p_from.dot(p_to);
	if (cosine < -1 + real_t(CMP_EPSILON)) { // opposite: any axis across
		const Vector3 side = (Math::abs(p_from.x) <= Math::abs(p_from.y) && Math::abs(p_from.x) <= Math::abs(p_from.z) ? Vector3(1, 0, 0)
																													   : Vector3(0, 1, 0));
		const Vector3 v = p_from.cross(side).normalized();
		*this = Quaternion(v.x, v.y, v.z, 0);
	} else {
		const real_t s = std::sqrt((1 + cosine) * 2);
		*this = Quaternion(axis.x / s, axis.y / s, axis.z / s, s / 2);
	}
}

} // namespace godot
