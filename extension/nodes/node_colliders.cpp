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
	if (!entry.tracked.parts.empty()) {
		_entries.push_back(entry);
	}
	return !entry.tracked.parts.empty();
}

void NodeColliders::remove(uint64_t p_node_id) {
	std::erase_if(_entries, [p_node_id](const Entry &p_entry) { return p_entry.node_id == p_node_id; });
}

void NodeColliders::collect(const Transform3D &p_field, const MotionTick &p_tick, std::vector<ColliderShape> &r_colliders) {
	_mesh_pieces = 0;
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
		const bool was_bound = entry.tracked.is_bound;
		read_shape(entry.shape->get_rid(), entry.tracked);
		split_mesh(entry.tracked);
		if (entry.tracked.is_bound && !was_bound) {
			WARN_PRINT(vformat("GrassField: %s", why_bound(vformat("'%s'", node->get_name()))));
		}
		if (!node->is_inside_tree()) {
			entry.motions.clear();
			continue;
		}
		write(entry, field_from_world * to_eigen(node->get_global_transform()) * entry.local, p_tick, r_colliders);
	}
}

// p_shape: where the shape stands, field space.
void NodeColliders::write(
		Entry &r_entry, const Eigen::Affine3d &p_shape, const MotionTick &p_tick, std::vector<ColliderShape> &r_colliders) {
	const std::vector<ShapePart> &parts = r_entry.tracked.parts;
	if (parts.size() != r_entry.motions.size()) { // other ones
		r_entry.motions.assign(parts.size(), NodeMotion());
	}
	_mesh_pieces += r_entry.tracked.is_split && !r_entry.tracked.is_bound ? int64_t(parts.size()) : 0;
	for (size_t i = 0; i < parts.size(); i++) {
		const Eigen::Affine3d now = p_shape * parts[i].offset;
		ColliderShape collider = parts[i].shape;
		collider.scale(ColliderShape::scale_of(now.linear()));
		collider.friction = NodeMotion::FRICTION;
		collider.owner = r_entry.owner;
		r_entry.motions[i].pose(now, p_tick, collider);
		r_colliders.push_back(collider);
	}
}

void NodeColliders::forget_motion() {
	for (Entry &entry : _entries) {
		entry.motions.clear();
	}
}

bool pose_shape(const Ref<Shape3D> &p_shape, const Eigen::Affine3d &p_pose, ColliderShape &r_shape) {
	TrackedShape tracked;
	read_shape(p_shape->get_rid(), tracked);
	if (tracked.type == PhysicsServer3D::SHAPE_CONCAVE_POLYGON) { // has no inside
		return false;
	}
	if (tracked.parts.empty()) {
		return false;
	}
	const Eigen::Affine3d pose = p_pose * tracked.parts[0].offset;
	r_shape = tracked.parts[0].shape;
	r_shape.scale(ColliderShape::scale_of(pose.linear()));
	r_shape.set_poses(pose, pose);
	return true;
}

} // namespace grass
