// SPDX-License-Identifier: MIT
#include "nodes/node_colliders.h"

#include "convert.h"

#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/core/object.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

bool NodeColliders::add(const Node3D *p_node, const Ref<Shape3D> &p_shape, const Eigen::Affine3d &p_local, uint64_t p_owner) {
	Entry entry;
	entry.node_id = p_node->get_instance_id();
	entry.owner = p_owner != 0 ? p_owner : entry.node_id;
	entry.local = p_local;
	entry.shape = p_shape;
	read_shape(p_shape->get_rid(), entry.tracked);
	if (entry.tracked.usable) {
		_entries.push_back(entry);
	}
	return entry.tracked.usable;
}

void NodeColliders::remove(uint64_t p_node_id) {
	std::erase_if(_entries, [p_node_id](const Entry &p_entry) { return p_entry.node_id == p_node_id; });
}

void NodeColliders::collect(const Transform3D &p_field, const MotionTick &p_tick, std::vector<ColliderShape> &r_colliders) {
	if (_entries.empty()) {
		return;
	}
	const Eigen::Affine3d field_from_world = to_eigen(p_field).inverse(Eigen::Isometry);
	for (size_t i = 0; i < _entries.size();) {
		Entry &entry = _entries[i];
		const Node3D *node = Object::cast_to<Node3D>(ObjectDB::get_instance(entry.node_id));
		if (node == nullptr) { // freed
			_entries.erase(_entries.begin() + std::ptrdiff_t(i));
			continue;
		}
		i++;
		read_shape(entry.shape->get_rid(), entry.tracked);
		if (!node->is_inside_tree() || !entry.tracked.usable) {
			entry.motion.forget();
			continue;
		}
		const Eigen::Affine3d now = field_from_world * to_eigen(node->get_global_transform()) * entry.local * entry.tracked.offset;
		ColliderShape collider = entry.tracked.shape;
		scale_shape(collider, now.linear());
		collider.friction = NodeMotion::FRICTION;
		collider.owner = entry.owner;
		entry.motion.pose(now, p_tick, collider);
		r_colliders.push_back(collider);
	}
}

void NodeColliders::forget_motion() {
	for (Entry &entry : _entries) {
		entry.motion.forget();
	}
}

bool pose_shape(const Ref<Shape3D> &p_shape, const Eigen::Affine3d &p_pose, ColliderShape &r_shape) {
	TrackedShape tracked;
	read_shape(p_shape->get_rid(), tracked);
	if (tracked.type == PhysicsServer3D::SHAPE_CONCAVE_POLYGON) { // has no inside
		return false;
	}
	if (tracked.usable) {
		const Eigen::Affine3d pose = p_pose * tracked.offset;
		r_shape = tracked.shape;
		scale_shape(r_shape, pose.linear());
		r_shape.set_poses(pose, pose);
	}
	return tracked.usable;
}

} // namespace grass
