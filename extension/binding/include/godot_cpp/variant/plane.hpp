// SPDX-License-Identifier: MIT
// A plane: the points p with dot(normal, p) == d. "Over" is the side the normal points to.
#pragma once

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

struct Plane {
	Vector3 normal;
	real_t d = 0;

	constexpr Plane() = default;
	constexpr Plane(real_t p_a, real_t p_b, real_t p_c, real_t p_d) : normal(p_a, p_b, p_c), d(p_d) {}
	constexpr Plane(const Vector3 &p_normal, real_t p_d = 0) : normal(p_normal), d(p_d) {}
	Plane(const Vector3 &p_normal, const Vector3 &p_point) : normal(p_normal), d(p_normal.dot(p_point)) {}
	Plane(const Vector3 &p_a, const Vector3 &p_b, const Vector3 &p_c, ClockDirection p_direction = CLOCKWISE) {
		normal = (p_direction == CLOCKWISE ? (p_a - p_c).cross(p_a - p_b) : (p_a - p_b).cross(p_a - p_c)).normalized();
		d = normal.dot(p_a);
	}

	Vector3 get_normal() const { return normal; }
	void set_normal(const Vector3 &p_normal) { normal = p_normal; }
	Vector3 get_center() const { return normal * d; }
	real_t distance_to(const Vector3 &p_point) const { return normal.dot(p_point) - d; }
	bool is_point_over(const Vector3 &p_point) const { return normal.dot(p_point) > d; }
	Vector3 project(const Vector3 &p_point) const { return p_point - normal * distance_to(p_point); }
	bool has_point(const Vector3 &p_point, real_t p_tolerance = real_t(CMP_EPSILON)) const {
		return Math::abs(distance_to(p_point)) <= p_tolerance;
	}
	// The point goes to r_point where there is one. A ray has one direction, a segment two ends.
	bool intersect_3(const Plane &p_b, const Plane &p_c, Vector3 *r_point = nullptr) const;
	bool intersects_ray(const Vector3 &p_from, const Vector3 &p_direction, Vector3 *r_point) const;
	bool intersects_segment(const Vector3 &p_from, const Vector3 &p_to, Vector3 *r_point) const;
	void normalize() { *this = normalized(); }
	Plane normalized() const {
		const real_t length = normal.length();
		return length == 0 ? Plane() : Plane(normal / length, d / length);
	}
	Plane operator-() const { return Plane(-normal, -d); }
	bool operator==(const Plane &p_other) const { return normal == p_other.normal && d == p_other.d; }
	bool operator!=(const Plane &p_other) const { return !(*this == p_other); }

	operator String() const;

#include <godot_cpp/variant/gen/plane.inc>
};

inline bool Plane::intersect_3(const Plane &p_b, const Plane &p_c, Vector3 *r_point) const {
	const Vector3 bc = p_b.normal.cross(p_c.normal);
	const real_t volume = normal.dot(bc);
	if (Math::is_zero_approx(volume)) {
		return false;
	}
	if (r_point) {
		*r_point = (bc * d + p_c.normal.cross(normal) * p_b.d + normal.cross(p_b.normal) * p_c.d) / volume;
	}
	return true;
}

inline bool Plane::intersects_ray(const Vector3 &p_from, const Vector3 &p_direction, Vector3 *r_point) const {
	const real_t slope = normal.dot(p_direction);
	const real_t along = -distance_to(p_from) / slope;
	if (Math::is_zero_approx(slope) || along < -real_t(CMP_EPSILON)) {
		return false;
	}
	*r_point = p_from + p_direction * along;
	return true;
}

inline bool Plane::intersects_segment(const Vector3 &p_from, const Vector3 &p_to, Vector3 *r_point) const {
	const real_t slope = normal.dot(p_to - p_from);
	const real_t along = -distance_to(p_from) / slope;
	if (Math::is_zero_approx(slope) || along < -real_t(CMP_EPSILON) || along > 1 + real_t(CMP_EPSILON)) {
		return false;
	}
	*r_point = p_from + (p_to - p_from) * along;
	return true;
}

} // namespace godot
