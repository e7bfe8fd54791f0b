// SPDX-License-Identifier: MIT
#include "nodes/node_colliders.h"

#include "convert.h"

#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/core/object.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// The friction of an ordinary body, as the tracker scales it.
constexpr double NODE_FRICTION = 0.5;

} // namespace

// A node has no velocity: only its motion shows it.
void NodeColliders::judge_motion(Entry &r_entry, const Eigen::Affine3d &p_now, const MotionTick &p_tick) {
	const Eigen::Vector3d nobody_knows = Eigen::Vector3d::Zero(), before = r_entry.before.translation(), now = p_now.translation();
	if (!r_entry.has_before) {
		r_entry.motion.start(now, nobody_knows, nobody_knows, p_tick);
		r_entry.before = p_now;
		r_entry.has_before = true;
		return;
	}
	const Eigen::Vector3d from = r_entry.motion.follow(before, now, nobody_knows, p_tick);
	if (from == now && from != before) { // put there
		r_entry.before.linear() = p_now.linear();
	}
	r_entry.before.translation() = from;
}

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
			entry.has_before = false;
			continue;
		}
		const Eigen::Affine3d now = field_from_world * to_eigen(node->get_global_transform()) * entry.local * entry.tracked.offset;
		judge_motion(entry, now, p_tick);
		ColliderShape collider = entry.tracked.shape;
		scale_shape(collider, now.linear());
		collider.friction = NODE_FRICTION;
		collider.owner = entry.owner;
		collider.set_poses(entry.before, now);
		r_colliders.push_back(collider);
		entry.before = now;
	}
}

void NodeColliders::forget_motion() {
	for (Entry &entry : _entries) {
		entry.has_before = false;
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
