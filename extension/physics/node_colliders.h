// SPDX-License-Identifier: MIT
// Nodes without physics that bend grass because a game registered them with a shape.
#pragma once

#include "core/bodies/body_reads.h"
#include "physics/field_reach.h"
#include "physics/node_motion.h"
#include "physics/physics_shapes.h"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/shape3d.hpp>

namespace grass {

class NodeColliders {
public:
	// Adds a shape. Returns false, and adds nothing, if the shape cannot bend grass. p_local: the shape's transform in the node; p_owner:
	// id of its owner, 0: the node.
	bool add(const godot::Node3D *p_node, const godot::Ref<godot::Shape3D> &p_shape,
			const Eigen::Affine3d &p_local = Eigen::Affine3d::Identity(), uint64_t p_owner = 0);
	void remove(uint64_t p_node_id); // removes all its shapes
	void clear() { _entries.clear(); }
	// Appends every shape near the grass, posed in the field's space.
	void collect(const FieldReach &p_reach, const MotionTick &p_tick, std::vector<ColliderShape> &r_colliders);
	void forget_motion(); // see BodyTracker
	bool is_empty() const { return _entries.empty(); }
	int64_t get_count() const { return int64_t(_entries.size()); }
	int64_t get_mesh_pieces() const { return _mesh_pieces; } // see BodyTracker
	const BodyReads &get_reads() const { return _reads; }

private:
	struct Entry {
		uint64_t node_id, owner;
		Eigen::Affine3d local; // of the shape in the node
		godot::Ref<godot::Shape3D> shape;
		TrackedShape tracked;
		std::vector<NodeMotion> motions; // one for each part
		int next_look = 0; // ticks until the next check of its shape
	};

	void look(Entry &r_entry, const godot::Node3D &p_node);
	void write(Entry &r_entry, const Eigen::Affine3d &p_shape, const FieldReach &p_reach, const MotionTick &p_tick,
			std::vector<ColliderShape> &r_colliders);

	std::vector<Entry> _entries; // in the order of registration
	int64_t _mesh_pieces = 0;
	BodyReads _reads;
};

// Converts a shape at a pose in the field's space (with scale, without shear) to the solver's. Returns false if it cannot bend grass.
bool pose_shape(const godot::Ref<godot::Shape3D> &p_shape, const Eigen::Affine3d &p_pose, ColliderShape &r_shape);

} // namespace grass
