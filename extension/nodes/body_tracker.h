// SPDX-License-Identifier: MIT
// Finds the physics bodies in a field, with nothing set up by the user: an area in the physics server reports
// which bodies overlap the field; every tick their shapes and poses become colliders.
#pragma once

#include "core/body_shape.h"

#include <Eigen/Geometry>

#include <godot_cpp/classes/collision_object3d.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <map>
#include <vector>

namespace grass {

// A physics shape as the solver takes it, and what it was made from (to notice changes).
struct TrackedShape {
	int64_t type = -1; // PhysicsServer3D.ShapeType
	godot::Variant data; // PhysicsServer3D.shape_get_data
	ColliderShape shape;
	Eigen::Affine3d offset = Eigen::Affine3d::Identity(); // of the solver's shape in the physics shape's space
	bool usable = false;
};

class BodyTracker {
public:
	~BodyTracker() { stop(); }

	// Watches a box, see set_box(). p_changed is called with the five arguments of
	// PhysicsServer3D.area_set_monitor_callback, and must hand the first three to body_changed().
	void start(const godot::RID &p_space, const godot::Callable &p_changed, uint32_t p_mask);
	// Watches p_half_extents (metres) around p_transform, and some metres more, so that fast bodies are known in time.
	void set_box(const godot::Transform3D &p_transform, const godot::Vector3 &p_half_extents);
	void set_mask(uint32_t p_mask);
	void stop();

	void body_changed(int64_t p_status, const godot::RID &p_body, int64_t p_instance_id);
	// Appends every shape that may touch grass in this tick, posed in the field's space.
	// p_field: the field's transform (orthonormal); p_delta: seconds since the last call.
	void collect(const godot::Transform3D &p_field, double p_delta, std::vector<ColliderShape> &r_colliders);

	int64_t body_count() const { return int64_t(_bodies.size()); }

private:
	struct Body {
		godot::RID rid;
		uint64_t instance_id = 0;
		int64_t overlaps = 0; // shapes of it that overlap the area
		std::vector<TrackedShape> shapes;
		Eigen::Affine3d before = Eigen::Affine3d::Identity(); // in field space
		godot::Transform3D world_found; // where it was when it came in: in the world, for a field may move over ground that does not
		bool has_before = false;
		bool has_moved = false; // a StaticBody3D counts from its first motion on
		double last_step = 0.0; // metres that it moved in the tick before
	};

	bool pose_of(Body &p_body, const godot::CollisionObject3D *p_node, const Eigen::Affine3d &p_field_from_world, double p_delta,
			Eigen::Affine3d &r_now);
	void collect_shapes(
			Body &p_body, const godot::CollisionObject3D *p_node, const Eigen::Affine3d &p_now, std::vector<ColliderShape> &r_colliders);

	godot::RID _area, _box;
	uint32_t _mask = 1;
	std::map<uint64_t, Body> _bodies; // by the RID's id: the order of colliders is the same in every run
};

// Reads shape p_shape of the physics server. False if it bends no grass (planes, rays, ground meshes).
bool read_shape(const godot::RID &p_shape, TrackedShape &r_shape);
// Takes the scale of p_basis into the shape: poses hold rotation only.
void scale_shape(ColliderShape &r_shape, const Eigen::Matrix3d &p_basis);

} // namespace grass
