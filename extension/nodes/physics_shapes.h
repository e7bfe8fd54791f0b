// SPDX-License-Identifier: MIT
// From the physics server's shapes to the solver's.
#pragma once

#include "core/bodies/body_shape.h"

#include <Eigen/Geometry>

#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cstdint>

namespace grass {

// A physics shape as the solver reads it, and what it was made from (to detect changes).
struct TrackedShape {
	godot::RID rid;
	int64_t type = -1; // PhysicsServer3D.ShapeType
	godot::Variant data; // PhysicsServer3D.shape_get_data
	ColliderShape shape;
	Eigen::Affine3d offset = Eigen::Affine3d::Identity(); // of the solver's shape in the physics shape's space
	bool usable = false;

	godot::Transform3D transform; // of the physics shape in its body
	bool enabled = false;
	Eigen::Affine3d local = Eigen::Affine3d::Identity(); // of the solver's shape in the body
	ColliderShape collider; // the shape at its scaled size, with its friction; without poses
	ColliderPose pose; // in field space, as it was handed on in the last tick
	bool has_pose = false; // it was handed on
};

// Reads shape p_shape of the physics server. Returns whether it changed. TrackedShape::usable: false if it bends no grass
// (planes, rays, height maps).
// r_calls: counts calls of the server, if given.
bool read_shape(const godot::RID &p_shape, TrackedShape &r_shape, int64_t *r_calls = nullptr);
// Applies the scale of p_basis to the shape: poses hold rotation only.
void scale_shape(ColliderShape &r_shape, const Eigen::Matrix3d &p_basis);

} // namespace grass
