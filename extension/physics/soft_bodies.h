// SPDX-License-Identifier: MIT
// Makes colliders of a field from the soft bodies of a world. The physics server's areas do not report these, so each is checked in every
// tick.
#pragma once

#include "core/bodies/body_reads.h"
#include "core/bodies/body_shape.h"
#include "core/bodies/soft_parts.h"
#include "physics/field_reach.h"
#include "physics/node_motion.h"

#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/classes/soft_body3d.hpp>
#include <godot_cpp/variant/aabb.hpp>

#include <map>
#include <vector>

namespace grass {

class SoftBodies {
public:
	// Appends the parts of every soft body near the grass, posed in the field's space.
	void collect(const FieldReach &p_reach, const MotionTick &p_tick, std::vector<ColliderShape> &r_colliders);
	void forget_motion() { _bodies.clear(); } // see BodyTracker
	// Returns the box around a soft body's points, global; empty while these cannot be read.
	Eigen::AlignedBox3d find_box(const godot::SoftBody3D *p_node);

	int64_t get_count() const { return int64_t(_bodies.size()); } // in the last tick
	const BodyReads &get_reads() const { return _reads; }

private:
	struct Body {
		uint64_t mesh = 0; // id of the mesh that the parts were made from
		SoftParts parts;
		std::vector<godot::Vector3> places; // of the parts' points, global
		godot::AABB bounds;
		std::vector<NodeMotion> motions; // one for each part
	};

	// A node passes its mesh to the server when it is drawn.
	struct Shown {
		uint64_t mesh = 0; // its id
		uint64_t frame = 0; // frame of the engine in which the node was first seen with it
		bool has_points = false; // whether it had points in that frame: the server reads a mesh once
	};

	// Returns true if its points can be read in this tick.
	bool is_ready(const godot::SoftBody3D *p_node);
	void read_mesh(const godot::Ref<godot::Mesh> &p_mesh, Body &r_body);
	void read_points(const godot::RID &p_body, const godot::AABB &p_bounds, Body &r_body);
	void write(
			uint64_t p_owner, const FieldReach &p_reach, const MotionTick &p_tick, Body &r_body, std::vector<ColliderShape> &r_colliders);

	std::map<uint64_t, Body> _bodies; // by id, so that the order of colliders is the same in every run
	std::map<uint64_t, Shown> _shown; // by id, including those far away
	BodyReads _reads;
};

} // namespace grass
