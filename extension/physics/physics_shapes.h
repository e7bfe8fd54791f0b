// SPDX-License-Identifier: MIT
// Converts the physics server's shapes to the solver's.
#pragma once

#include "core/bodies/body_shape.h"
#include "core/bodies/mesh_pieces.h"

#include <Eigen/Geometry>

#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cstdint>
#include <vector>

namespace grass {

// One shape of the solver.
struct ShapePart {
	// First the members that a tick reads of a moving body.
	Eigen::Affine3d local = Eigen::Affine3d::Identity(); // of the solver's shape in the body
	ColliderPose pose; // in field space, as passed on in the last tick
	bool has_pose = false; // it was passed on

	ColliderShape shape;
	Eigen::Affine3d offset = Eigen::Affine3d::Identity(); // of the solver's shape in the physics shape's space
	ColliderShape collider; // the shape at its scaled size, with its friction; without poses
};

// A physics shape in the solver's form, and the data that it was made from (to detect changes).
struct TrackedShape {
	std::vector<ShapePart> parts; // one, except for a trimesh; none: it bends no grass
	int64_t type = -1; // PhysicsServer3D.ShapeType
	bool enabled = false;
	bool is_split = false; // a trimesh whose pieces were due
	bool is_bound = false; // it has no pieces: its box remains
	bool is_simplified = false; // a convex polygon with too many points or faces

	godot::RID rid;
	godot::Variant data; // PhysicsServer3D.shape_get_data
	MeshPieces::Future pieces; // of a trimesh, while the box around it is its only part
	uint64_t pieces_due = 0; // physics tick of the engine in which they replace the box
	godot::Transform3D transform; // of the physics shape in its body
	double friction = 0.0;
};

// Reads shape p_shape of the physics server. Returns whether it changed. Planes, rays and height maps have no parts; a trimesh has the box
// around it. r_calls, if given, counts calls of the server.
bool read_shape(const godot::RID &p_shape, TrackedShape &r_shape, int64_t *r_calls = nullptr);
// Starts a thread that splits a trimesh into convex pieces, which replace its box a fixed number of ticks later. Returns true if they
// replace it now; then it waits for the thread, so that every replay is the same. Must be called for a moving trimesh, after each read.
bool split_mesh(TrackedShape &r_shape);
// Returns a warning if grass meets a form that differs from the shape, or meets nothing; otherwise empty. p_name: the shape's owner.
godot::String why_other(const TrackedShape &p_shape, const godot::String &p_name);

} // namespace grass
