// SPDX-License-Identifier: MIT
// An affine map of space: p -> basis * p + origin.
#pragma once

#include <godot_cpp/variant/basis.hpp>

namespace godot {

struct Transform3D {
	Basis basis;
	Vector3 origin;

	Transform3D() = default;
	Transform3D(const Basis &p_basis, const Vector3 &p_origin = Vector3()) : basis(p_basis), origin(p_origin) {}

	// The matrix by rows, then the origin.
	Transform3D(real_t p_xx, real_t p_xy, real_t p_xz, real_t p_yx, real_t p_yy, real_t p_yz, real_t p_zx, real_t p_zy, real_t p_zz,
			real_t p_ox, real_t p_oy, real_t p_oz) :
			basis(p_xx, p_xy, p_xz, p_yx, p_yy, p_yz, p_zx, p_zy, p_zz), origin(p_ox, p_oy, p_oz) {}

	Vector3 xform(const Vector3 &p_v) const { return basis.xform(p_v) + origin; }
	Transform3D operator*(const Transform3D &p_t) const { return Transform3D(basis * p_t.basis, xform(p_t.origin)); }
	Transform3D operator*(real_t) const = delete; // upstream has it, so a Variant is ambiguous
	bool operator==(const Transform3D &p_t) const { return basis == p_t.basis && origin == p_t.origin; }
	bool operator!=(const Transform3D &p_t) const { return !(*this == p_t); }

	Transform3D affine_inverse() const {
		const Basis back = basis.inverse();
		return Transform3D(back, back.xform(-origin));
	}
	Transform3D orthonormalized() const { return Transform3D(basis.orthonormalized(), origin); }
	Transform3D translated_local(const Vector3 &p_offset) const { return Transform3D(basis, xform(p_offset)); }
	bool is_finite() const { return basis.is_finite() && origin.is_finite(); }

	operator String() const;
};

} // namespace godot
