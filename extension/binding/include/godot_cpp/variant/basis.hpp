// SPDX-License-Identifier: MIT
// A 3 x 3 matrix: rotation, scale and shear. Stored by rows; its columns are the images of the axes.
#pragma once

#include <godot_cpp/variant/vector3.hpp>

namespace godot {

struct Basis {
	Vector3 rows[3] = { Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1) };

	Basis() = default;
	Basis(real_t p_xx, real_t p_xy, real_t p_xz, real_t p_yx, real_t p_yy, real_t p_yz, real_t p_zx, real_t p_zy, real_t p_zz) :
			rows{ Vector3(p_xx, p_xy, p_xz), Vector3(p_yx, p_yy, p_yz), Vector3(p_zx, p_zy, p_zz) } {}
	// The columns.
	Basis(const Vector3 &p_x, const Vector3 &p_y, const Vector3 &p_z) :
			rows{ Vector3(p_x.x, p_y.x, p_z.x), Vector3(p_x.y, p_y.y, p_z.y), Vector3(p_x.z, p_y.z, p_z.z) } {}

	// Upstream's other constructors, which make a Variant ambiguous.
	Basis(const Quaternion &) = delete;
	Basis(const Vector3 &, real_t, const Vector3 &) = delete;

	Vector3 &operator[](int p_row) { return rows[p_row]; }
	const Vector3 &operator[](int p_row) const { return rows[p_row]; }
	Vector3 get_column(int p_index) const { return Vector3(rows[0][p_index], rows[1][p_index], rows[2][p_index]); }

	Vector3 xform(const Vector3 &p_v) const { return Vector3(rows[0].dot(p_v), rows[1].dot(p_v), rows[2].dot(p_v)); }
	Basis operator*(const Basis &p_b) const { return Basis(xform(p_b.get_column(0)), xform(p_b.get_column(1)), xform(p_b.get_column(2))); }
	Basis operator*(real_t) const = delete; // upstream has it, so a Variant is ambiguous
	bool operator==(const Basis &p_b) const { return rows[0] == p_b.rows[0] && rows[1] == p_b.rows[1] && rows[2] == p_b.rows[2]; }
	bool operator!=(const Basis &p_b) const { return !(*this == p_b); }

	real_t determinant() const { return rows[0].dot(rows[1].cross(rows[2])); }
	// A matrix without an inverse gives itself back.
	Basis inverse() const;
	// Gram and Schmidt over the columns: a rotation (or reflection).
	Basis orthonormalized() const;
	Vector3 get_scale() const {
		return Vector3(get_column(0).length(), get_column(1).length(), get_column(2).length()) * SIGN(determinant());
	}
	// The scale goes first in what the matrix does.
	void scale_local(const Vector3 &p_scale) {
		*this = Basis(get_column(0) * p_scale.x, get_column(1) * p_scale.y, get_column(2) * p_scale.z);
	}
	bool is_finite() const { return rows[0].is_finite() && rows[1].is_finite() && rows[2].is_finite(); }

	operator String() const;
};

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

} // namespace godot
