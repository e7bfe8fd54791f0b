// SPDX-License-Identifier: MIT
// Where a world is, and places in it.
#pragma once

#include "shared/convert.h"

#include <godot_cpp/classes/node3d.hpp>

namespace grass {

// Returns the world's global transform without scale. Always finite.
inline godot::Transform3D transform_of(const godot::Node3D &p_world) {
	const godot::Transform3D transform = p_world.get_global_transform();
	if (transform.is_finite() && transform.basis.determinant() != 0.0) {
		return transform.orthonormalized();
	}
	return godot::Transform3D(godot::Basis(), transform.origin.is_finite() ? transform.origin : godot::Vector3());
}

// Returns x and z in metres from the world's centre.
inline Eigen::Vector2d place_in(const godot::Node3D &p_world, const godot::Vector3 &p_global) {
	const Eigen::Vector3d place = to_eigen(transform_of(p_world)).inverse(Eigen::Isometry) * to_eigen(p_global);
	return { place.x(), place.z() };
}

} // namespace grass
