// SPDX-License-Identifier: MIT
// A 4 x 4 matrix by columns: what a camera does.
#pragma once

#include <godot_cpp/variant/plane.hpp>
#include <godot_cpp/variant/rect2.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/vector4.hpp>

namespace godot {

struct Projection {
	enum Planes {
		PLANE_NEAR,
		PLANE_FAR,
		PLANE_LEFT,
		PLANE_TOP,
		PLANE_RIGHT,
		PLANE_BOTTOM,
	};

	Vector4 columns[4] = { Vector4(1, 0, 0, 0), Vector4(0, 1, 0, 0), Vector4(0, 0, 1, 0), Vector4(0, 0, 0, 1) };

	constexpr Projection() = default;
	constexpr Projection(const Vector4 &p_x, const Vector4 &p_y, const Vector4 &p_z, const Vector4 &p_w) : columns{ p_x, p_y, p_z, p_w } {}
	Projection(const Transform3D &p_transform);

	Vector4 &operator[](int p_column) { return columns[p_column]; }
	const Vector4 &operator[](int p_column) const { return columns[p_column]; }
	Vector4 xform(const Vector4 &p_v) const { return columns[0] * p_v.x + columns[1] * p_v.y + columns[2] * p_v.z + columns[3] * p_v.w; }
	// With the division by w.
	Vector3 xform(const Vector3 &p_v) const {
		const Vector4 v = xform(Vector4(p_v.x, p_v.y, p_v.z, 1));
		return Vector3(v.x, v.y, v.z) / v.w;
	}
	Vector4 operator*(const Vector4 &p_v) const { return xform(p_v); }
	Projection operator*(const Projection &p_m) const { return Projection(xform(p_m[0]), xform(p_m[1]), xform(p_m[2]), xform(p_m[3])); }
	bool operator==(const Projection &p_m) const {
		return columns[0] == p_m[0] && columns[1] == p_m[1] && columns[2] == p_m[2] && columns[3] == p_m[3];
	}
	bool operator!=(const Projection &p_m) const { return !(*this == p_m); }

	operator Transform3D() const;
	operator String() const;

#include <godot_cpp/variant/gen/projection.inc>
};

inline Projection::Projection(const Transform3D &p_transform) {
	for (int column = 0; column < 3; column++) {
		const Vector3 v = p_transform.basis.get_column(column);
		columns[column] = Vector4(v.x, v.y, v.z, 0);
	}
	columns[3] = Vector4(p_transform.origin.x, p_transform.origin.y, p_transform.origin.z, 1);
}

inline Projection::operator Transform3D() const {
	const auto part = [this](int p_column) { return Vector3(columns[p_column].x, columns[p_column].y, columns[p_column].z); };
	return Transform3D(part(0), part(1), part(2), part(3));
}

} // namespace godot
