// SPDX-License-Identifier: MIT
// Bodies that grass may grow on, from a scene's nodes: the pose and the box of each.
#pragma once

#include <Eigen/Geometry>

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <vector>

namespace grass {

// A body at one moment. Without shapes: it does not exist.
struct GroundBody {
	struct Shape {
		int64_t id = 0; // of its RID
		godot::Transform3D transform; // in the body
		Eigen::AlignedBox3d box; // around it, in its own space
		godot::Variant data; // PhysicsServer3D.shape_get_data
		uint64_t changes = 0; // revision of the data, when last read
		bool operator==(const Shape &p_other) const;
	};

	godot::Transform3D transform; // global
	std::vector<Shape> shapes;

	bool operator==(const GroundBody &) const = default;
	Eigen::AlignedBox3d get_box() const; // around all its shapes, global, metres; empty without shapes
};

// Returns the ids of p_root, and of nodes below it, that have such a body: static bodies, and CSG with collision.
std::vector<uint64_t> find_ground_bodies(godot::Node *p_root);
// Reads a body. p_before: the body as last read; shapes that did not change are not measured again.
GroundBody read_ground_body(const godot::Node3D *p_node, const GroundBody &p_before);

} // namespace grass
