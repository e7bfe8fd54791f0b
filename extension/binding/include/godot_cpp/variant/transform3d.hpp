// SPDX-License-Identifier: MIT
// An affine map of space: p -> basis * p + origin.
#pragma once

#include <godot_cpp/variant/aabb.hpp>
#include <godot_cpp/variant/basis.hpp>
#include <godot_cpp/variant/plane.hpp>

namespace godot {

struct Transform3D {
	Basis basis;
	Vector3 origin;

	constexpr Transform3D() = default;
	constexpr Transform3D(const Basis &p_basis, const Vector3 &p_origin = Vector3()) : basis(p_basis), origin(p_origin) {}
	constexpr Transform3D(const Vector3 &p_x, const Vector3 &p_y, const Vector3 &p_z, const Vector3 &p_origin) :
			basis(p_x, p_y, p_z), origin(p_origin) {}
	// The matrix by rows, then the origin.
	constexpr Transform3D(real_t p_xx, real_t p_xy, real_t p_xz, real_t p_yx, real_t p_yy, real_t p_yz, real_t p_zx, real_t p_zy,
			real_t p_zz, real_t p_ox, real_t p_oy, real_t p_oz) :
			basis(p_xx, p_xy, p_xz, p_yx, p_yy, p_yz, p_zx, p_zy, p_zz), origin(p_ox, p_oy, p_oz) {}

	const Basis &get_basis() const { return basis; }
	void set_basis(const Basis &p_basis) { basis = p_basis; }
	const Vector3 &get_origin() const { return origin; }
	void set_origin(const Vector3 &p_origin) { origin = p_origin; }

	Vector3 xform(const Vector3 &p_v) const { return basis.xform(p_v) + origin; }
	// By the transpose: the inverse of a rotation with a translation.
	Vector3 xform_inv(const Vector3 &p_v) const { return basis.xform_inv(p_v - origin); }
	Vector3 operator*(const Vector3 &p_v) const { return xform(p_v); }
	AABB xform(const AABB &p_box) const;
	AABB operator*(const AABB &p_box) const { return xform(p_box); }
	Plane xform(const Plane &p_plane) const;
	Plane operator*(const Plane &p_plane) const { return xform(p_plane); }
	Transform3D operator*(const Transform3D &p_t) const { return Transform3D(basis * p_t.basis, xform(p_t.origin)); }
	Transform3D &operator*=(const Transform3D &p_t) { return *this = *this * p_t; }
	Transform3D operator*(real_t p_s) const { return Transform3D(basis * p_s, origin * p_s); }
	bool operator==(const Transform3D &p_t) const { return basis == p_t.basis && origin == p_t.origin; }
	bool operator!=(const Transform3D &p_t) const { return !(*this == p_t); }

	// Of rotations and translations only.
	Transform3D inverse() const {
		const Basis back = basis.transposed();
		return Transform3D(back, back.xform(-origin));
	}
	void invert() { *this = inverse(); }
	Transform3D affine_inverse() const {
		const Basis back = basis.inverse();
		return Transform3D(back, back.xform(-origin));
	}
	void affine_invert() { *this = affine_inverse(); }
	Transform3D orthonormalized() const { return Transform3D(basis.orthonormalized(), origin); }
	void orthonormalize() { *this = orthonormalized(); }
	Transform3D translated(const Vector3 &p_offset) const { return Transform3D(basis, origin + p_offset); }
	Transform3D translated_local(const Vector3 &p_offset) const { return Transform3D(basis, xform(p_offset)); }
	void translate_local(const Vector3 &p_offset) { *this = translated_local(p_offset); }
	Transform3D scaled(const Vector3 &p_scale) const { return Transform3D(basis.scaled(p_scale), origin * p_scale); }
	Transform3D scaled_local(const Vector3 &p_scale) const { return Transform3D(basis.scaled_local(p_scale), origin); }
	void scale(const Vector3 &p_scale) { *this = scaled(p_scale); }
	void scale_basis(const Vector3 &p_scale) { basis.scale(p_scale); }
	Transform3D rotated(const Vector3 &p_axis, real_t p_angle) const {
		const Basis turn(p_axis, p_angle);
		return Transform3D(turn * basis, turn.xform(origin));
	}
	Transform3D rotated_local(const Vector3 &p_axis, real_t p_angle) const { return Transform3D(basis * Basis(p_axis, p_angle), origin); }
	void rotate(const Vector3 &p_axis, real_t p_angle) { *this = rotated(p_axis, p_angle); }
	bool is_equal_approx(const Transform3D &p_t) const { return basis.is_equal_approx(p_t.basis) && origin.is_equal_approx(p_t.origin); }
	bool is_finite() const { return basis.is_finite() && origin.is_finite(); }

	operator String() const;

#include <godot_cpp/variant/gen/transform3d.inc>
};

// The box around the image of a box: each column of the matrix adds its extent to one side or the other.
inline AABB Transform3D::xform(const AABB &p_box) const {
	Vector3 low = origin;
	Vector3 high = origin;
	const Vector3 end = p_box.get_end();
	for (int column = 0; column < 3; column++) {
		const Vector3 a = basis.get_column(column) * p_box.position[column];
		const Vector3 b = basis.get_column(column) * end[column];
		low += a.min(b);
		high += a.max(b);
	}
	return AABB(low, high - low);
}

inline Plane Transform3D::xform(const Plane &p_plane) const {
	const Vector3 normal = basis.inverse().transposed().xform(p_plane.normal).normalized();
	return Plane(normal, normal.dot(xform(p_plane.normal * p_plane.d)));
}

} // namespace godot
