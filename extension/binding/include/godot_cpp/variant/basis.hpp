// SPDX-License-Identifier: MIT
// A 3 x 3 matrix: rotation, scale and shear. Stored by rows; its columns are the images of the axes.
#pragma once

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/variant/quaternion.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

struct Basis {
	Vector3 rows[3] = { Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1) };

	constexpr Basis() = default;
	constexpr Basis(real_t p_xx, real_t p_xy, real_t p_xz, real_t p_yx, real_t p_yy, real_t p_yz, real_t p_zx, real_t p_zy, real_t p_zz) :
			rows{ Vector3(p_xx, p_xy, p_xz), Vector3(p_yx, p_yy, p_yz), Vector3(p_zx, p_zy, p_zz) } {}
	// The columns.
	constexpr Basis(const Vector3 &p_x, const Vector3 &p_y, const Vector3 &p_z) :
			rows{ Vector3(p_x.x, p_y.x, p_z.x), Vector3(p_x.y, p_y.y, p_z.y), Vector3(p_x.z, p_y.z, p_z.z) } {}
	Basis(const Quaternion &p_rotation) { set_quaternion(p_rotation); }
	Basis(const Quaternion &p_rotation, const Vector3 &p_scale) { *this = Basis(p_rotation) * from_scale(p_scale); }
	// The axis must be of length 1.
	Basis(const Vector3 &p_axis, real_t p_angle) { set_quaternion(Quaternion(p_axis, p_angle)); }

	Vector3 &operator[](int p_row) { return rows[p_row]; }
	const Vector3 &operator[](int p_row) const { return rows[p_row]; }
	Vector3 get_column(int p_index) const { return Vector3(rows[0][p_index], rows[1][p_index], rows[2][p_index]); }
	void set_column(int p_index, const Vector3 &p_value) {
		rows[0][p_index] = p_value.x;
		rows[1][p_index] = p_value.y;
		rows[2][p_index] = p_value.z;
	}
	void set_columns(const Vector3 &p_x, const Vector3 &p_y, const Vector3 &p_z) { *this = Basis(p_x, p_y, p_z); }
	Vector3 get_main_diagonal() const { return Vector3(rows[0].x, rows[1].y, rows[2].z); }
	real_t tdotx(const Vector3 &p_v) const { return get_column(0).dot(p_v); }
	real_t tdoty(const Vector3 &p_v) const { return get_column(1).dot(p_v); }
	real_t tdotz(const Vector3 &p_v) const { return get_column(2).dot(p_v); }

	Vector3 xform(const Vector3 &p_v) const { return Vector3(rows[0].dot(p_v), rows[1].dot(p_v), rows[2].dot(p_v)); }
	// By the transpose: the inverse of a rotation.
	Vector3 xform_inv(const Vector3 &p_v) const { return rows[0] * p_v.x + rows[1] * p_v.y + rows[2] * p_v.z; }
	Vector3 operator*(const Vector3 &p_v) const { return xform(p_v); }
	Basis operator*(const Basis &p_b) const;
	Basis operator+(const Basis &p_b) const { return from_rows(rows[0] + p_b.rows[0], rows[1] + p_b.rows[1], rows[2] + p_b.rows[2]); }
	Basis operator-(const Basis &p_b) const { return from_rows(rows[0] - p_b.rows[0], rows[1] - p_b.rows[1], rows[2] - p_b.rows[2]); }
	Basis operator*(real_t p_s) const { return from_rows(rows[0] * p_s, rows[1] * p_s, rows[2] * p_s); }
	Basis operator/(real_t p_s) const { return *this * (1 / p_s); }
	Basis &operator*=(const Basis &p_b) { return *this = *this * p_b; }
	Basis &operator+=(const Basis &p_b) { return *this = *this + p_b; }
	Basis &operator-=(const Basis &p_b) { return *this = *this - p_b; }
	Basis &operator*=(real_t p_s) { return *this = *this * p_s; }
	bool operator==(const Basis &p_b) const { return rows[0] == p_b.rows[0] && rows[1] == p_b.rows[1] && rows[2] == p_b.rows[2]; }
	bool operator!=(const Basis &p_b) const { return !(*this == p_b); }

	real_t determinant() const { return rows[0].dot(rows[1].cross(rows[2])); }
	Basis transposed() const { return Basis(rows[0], rows[1], rows[2]); }
	void transpose() { *this = transposed(); }
	// A matrix without an inverse gives itself back.
	Basis inverse() const;
	void invert() { *this = inverse(); }
	// Gram and Schmidt over the columns: a rotation (or reflection).
	Basis orthonormalized() const;
	void orthonormalize() { *this = orthonormalized(); }
	// The scale goes first (rows) or last (columns) in what the matrix does.
	Basis scaled(const Vector3 &p_scale) const { return from_rows(rows[0] * p_scale.x, rows[1] * p_scale.y, rows[2] * p_scale.z); }
	void scale(const Vector3 &p_scale) { *this = scaled(p_scale); }
	Basis scaled_local(const Vector3 &p_scale) const { return *this * from_scale(p_scale); }
	void scale_local(const Vector3 &p_scale) { *this = scaled_local(p_scale); }
	Vector3 get_scale_abs() const { return Vector3(get_column(0).length(), get_column(1).length(), get_column(2).length()); }
	Vector3 get_scale() const { return get_scale_abs() * SIGN(determinant()); }
	static constexpr Basis from_scale(const Vector3 &p_scale) { return Basis(p_scale.x, 0, 0, 0, p_scale.y, 0, 0, 0, p_scale.z); }
	Basis rotated(const Vector3 &p_axis, real_t p_angle) const { return Basis(p_axis, p_angle) * *this; }
	Basis rotated(const Quaternion &p_rotation) const { return Basis(p_rotation) * *this; }
	void rotate(const Vector3 &p_axis, real_t p_angle) { *this = rotated(p_axis, p_angle); }
	void rotate(const Quaternion &p_rotation) { *this = rotated(p_rotation); }
	void set_quaternion(const Quaternion &p_rotation);
	Quaternion get_quaternion() const { return get_rotation_quaternion(); }
	void set_axis_angle(const Vector3 &p_axis, real_t p_angle) { *this = Basis(p_axis, p_angle); }
	void get_axis_angle(Vector3 &r_axis, real_t &r_angle) const { get_quaternion().get_axis_angle(r_axis, r_angle); }
	Basis lerp(const Basis &p_to, real_t p_weight) const { return *this + (p_to - *this) * p_weight; }
	void set_euler(const Vector3 &p_euler, EulerOrder p_order = EULER_ORDER_YXZ) { *this = from_euler(p_euler, p_order); }
	bool is_equal_approx(const Basis &p_b) const {
		return rows[0].is_equal_approx(p_b.rows[0]) && rows[1].is_equal_approx(p_b.rows[1]) && rows[2].is_equal_approx(p_b.rows[2]);
	}
	bool is_finite() const { return rows[0].is_finite() && rows[1].is_finite() && rows[2].is_finite(); }

	operator Quaternion() const { return get_quaternion(); }
	operator String() const;

#include <godot_cpp/variant/gen/basis.inc>

private:
	static constexpr Basis from_rows(const Vector3 &p_a, const Vector3 &p_b, const Vector3 &p_c) {
		return Basis(p_a.x, p_a.y, p_a.z, p_b.x, p_b.y, p_b.z, p_c.x, p_c.y, p_c.z);
	}
};

inline Basis Basis::operator*(const Basis &p_b) const {
	return from_rows(p_b.xform_inv(rows[0]), p_b.xform_inv(rows[1]), p_b.xform_inv(rows[2]));
}

inline Basis Basis::inverse() const {
	const Vector3 x = rows[1].cross(rows[2]);
	const Vector3 y = rows[2].cross(rows[0]);
	const Vector3 z = rows[0].cross(rows[1]);
	const real_t d = rows[0].dot(x);
	return d == 0 ? *this : Basis(x / d, y / d, z / d);
}

inline Basis Basis::orthonormalized() const {
	const Vector3 x = get_column(0).normalized();
	Vector3 y = get_column(1);
	Vector3 z = get_column(2);
	y = (y - x * x.dot(y)).normalized();
	z = (z - x * x.dot(z) - y * y.dot(z)).normalized();
	return Basis(x, y, z);
}

inline void Basis::set_quaternion(const Quaternion &p_rotation) {
	const Quaternion &q = p_rotation;
	const real_t s = 2 / q.length_squared();
	const Vector3 v = Vector3(q.x, q.y, q.z) * s;
	*this = Basis(1 - (q.y * v.y + q.z * v.z), q.x * v.y - q.w * v.z, q.x * v.z + q.w * v.y, q.x * v.y + q.w * v.z,
			1 - (q.x * v.x + q.z * v.z), q.y * v.z - q.w * v.x, q.x * v.z - q.w * v.y, q.y * v.z + q.w * v.x, 1 - (q.x * v.x + q.y * v.y));
}

} // namespace godot
