// SPDX-License-Identifier: MIT
// The only conversions between Godot's types and Eigen's. Both use metres, y up, right-handed axes and quaternions; they differ in
// precision, storage order (Godot's bases store rows) and memory ownership.
#pragma once

#include "core/base/layout.h"

#include <Eigen/Geometry>

#include <godot_cpp/variant/aabb.hpp>
#include <godot_cpp/variant/basis.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/plane.hpp>
#include <godot_cpp/variant/projection.hpp>
#include <godot_cpp/variant/quaternion.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/vector2.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <cstring>
#include <span>
#include <vector>

namespace grass {

inline Eigen::Vector2d to_eigen(const godot::Vector2 &p_v) {
	return { p_v.x, p_v.y };
}
inline Eigen::Vector3d to_eigen(const godot::Vector3 &p_v) {
	return { p_v.x, p_v.y, p_v.z };
}
inline Eigen::Quaterniond to_eigen(const godot::Quaternion &p_q) {
	return { p_q.w, p_q.x, p_q.y, p_q.z };
}

inline Eigen::Matrix3d to_eigen(const godot::Basis &p_basis) {
	Eigen::Matrix3d m;
	for (int row = 0; row < 3; row++) {
		for (int column = 0; column < 3; column++) {
			m(row, column) = p_basis.rows[row][column];
		}
	}
	return m;
}

inline Eigen::Affine3d to_eigen(const godot::Transform3D &p_transform) {
	Eigen::Affine3d a = Eigen::Affine3d::Identity();
	a.linear() = to_eigen(p_transform.basis);
	a.translation() = to_eigen(p_transform.origin);
	return a;
}

inline Eigen::Matrix4d to_eigen(const godot::Projection &p_projection) {
	Eigen::Matrix4d m;
	for (int column = 0; column < 4; column++) {
		const godot::Vector4 &own = p_projection.columns[column];
		m.col(column) = Eigen::Vector4d(own.x, own.y, own.z, own.w);
	}
	return m;
}

// Converts a plane to n.x, n.y, n.z, d with n.x <= d on the inner side, which is also Godot's convention.
inline Eigen::Vector4d to_eigen(const godot::Plane &p_plane) {
	return { p_plane.normal.x, p_plane.normal.y, p_plane.normal.z, p_plane.d };
}

inline std::vector<Eigen::Vector3d> to_eigen(const godot::PackedVector3Array &p_points) {
	std::vector<Eigen::Vector3d> points;
	points.reserve(size_t(p_points.size()));
	for (const godot::Vector3 &point : p_points) {
		points.push_back(to_eigen(point));
	}
	return points;
}

inline godot::Vector2 to_godot(const Eigen::Vector2d &p_v) {
	return { godot::real_t(p_v.x()), godot::real_t(p_v.y()) };
}
inline godot::Vector3 to_godot(const Eigen::Vector3d &p_v) {
	return { godot::real_t(p_v.x()), godot::real_t(p_v.y()), godot::real_t(p_v.z()) };
}
inline godot::Quaternion to_godot(const Eigen::Quaterniond &p_q) {
	return { godot::real_t(p_q.x()), godot::real_t(p_q.y()), godot::real_t(p_q.z()), godot::real_t(p_q.w()) };
}

inline godot::Basis to_godot(const Eigen::Matrix3d &p_m) {
	godot::Basis basis;
	for (int row = 0; row < 3; row++) {
		basis.rows[row] = to_godot(Eigen::Vector3d(p_m.row(row)));
	}
	return basis;
}

inline godot::Transform3D to_godot(const Eigen::Affine3d &p_a) {
	return { to_godot(Eigen::Matrix3d(p_a.linear())), to_godot(Eigen::Vector3d(p_a.translation())) };
}

// Returns the nearest transform without scale and without mirroring, which would turn blades inside out. Always finite.
inline godot::Transform3D without_scale(const godot::Transform3D &p_transform) {
	const godot::Transform3D moved(godot::Basis(), p_transform.origin.is_finite() ? p_transform.origin : godot::Vector3());
	if (!p_transform.is_finite() || p_transform.basis.determinant() == 0.0) {
		return moved;
	}
	godot::Transform3D turned = p_transform.orthonormalized();
	if (turned.basis.determinant() < 0.0) {
		turned.basis.scale_local(godot::Vector3(-1, 1, 1));
	}
	return turned.is_finite() ? turned : moved;
}

// Copies an array of plain records as bytes, for RenderingDevice and Image.
template <typename T> void copy_bytes(std::span<const T> p_from, godot::PackedByteArray &r_to) {
	r_to.resize(int64_t(p_from.size_bytes()));
	if (!p_from.empty()) {
		std::memcpy(r_to.ptrw(), p_from.data(), p_from.size_bytes());
	}
}

template <typename T> godot::PackedByteArray to_bytes(std::span<const T> p_from) {
	godot::PackedByteArray bytes;
	copy_bytes(p_from, bytes);
	return bytes;
}

} // namespace grass
