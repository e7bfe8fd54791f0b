// SPDX-License-Identifier: MIT
#include "physics/node_colliders.h"

#include "shared/convert.h"
#include "shared/label.h"

#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/core/object.hpp>

#include <utility>

using namespace godot;

namespace grass {

namespace {

// Ticks between checks of the shape of a node far from the grass. More: one that grows into the grass bends it later.
constexpr int FAR_LOOK_EVERY = 8;

} // namespace

bool NodeColliders::add(const Node3D *p_node, const Ref<Shape3D> &p_shape, const Eigen::Affine3d &p_local, uint64_t p_owner) {
	Entry entry;
	entry.node_id = p_node->get_instance_id();
	entry.owner = p_owner != 0 ? p_owner : entry.node_id;
	entry.local = p_local;
	entry.shape = p_shape;
	read_shape(p_shape->get_rid(), entry.tracked);
	if (!entry.tracked.parts.empty()) {
		if (entry.tracked.is_simplified) {
			WARN_PRINT(why_other(entry.tracked, label_of(*p_node)));
		}
		_entries.push_back(entry);
	}
	return !entry.tracked.parts.empty();
}

void NodeColliders::remove(uint64_t p_node_id) {
	std::erase_if(_entries, [p_node_id](const Entry &p_entry) { return p_entry.node_id == p_node_id; });
}

void NodeColliders::collect(const FieldReach &p_reach, const MotionTick &p_tick, std::vector<ColliderShape> &r_colliders) {
	_mesh_pieces = 0;
	for (size_t i = 0; i < _entries.size();) {
		Entry &entry = _entries[i];
		const Node3D *node = Object::cast_to<Node3D>(ObjectDB::get_instance(entry.node_id));
		_reads.engine_calls++;
		if (node == nullptr) { // freed
			_entries.erase(_entries.begin() + std::ptrdiff_t(i));
			continue;
		}
		i++;
		if (entry.next_look-- <= 0) {
			entry.next_look = FAR_LOOK_EVERY - 1;
			look(entry, *node);
		}
		_reads.engine_calls++;
		if (!node->is_inside_tree()) {
			entry.motions.clear();
			continue;
		}
		_reads.poses++;
		_reads.engine_calls++;
		write(entry, p_reach.from_world * to_eigen(node->get_global_transform()) * entry.local, p_reach, p_tick, r_colliders);
	}
}

void NodeColliders::look(Entry &r_entry, const Node3D &p_node) {
	const bool was_other = r_entry.tracked.is_bound || r_entry.tracked.is_simplified;
	_reads.shapes++;
	_reads.engine_calls++;
	read_shape(r_entry.shape->get_rid(), r_entry.tracked, &_reads.engine_calls);
	split_mesh(r_entry.tracked);
	if (!was_other && (r_entry.tracked.is_bound || r_entry.tracked.is_simplified)) {
		WARN_PRINT(why_other(r_entry.tracked, label_of(p_node)));
	}
}

// Writes a shape's colliders. p_shape: its transform, field space. A shape far from the grass is only followed.
void NodeColliders::write(Entry &r_entry, const Eigen::Affine3d &p_shape, const FieldReach &p_reach, const MotionTick &p_tick,
		std::vector<ColliderShape> &r_colliders) {
	const std::vector<ShapePart> &parts = r_entry.tracked.parts;
	if (parts.size() != r_entry.motions.size()) { // the parts have changed
		r_entry.motions.assign(parts.size(), NodeMotion());
	}
	bool is_near = false;
	for (size_t i = 0; i < parts.size(); i++) {
		const Eigen::Affine3d now = p_shape * parts[i].offset;
		ColliderShape collider = parts[i].shape;
		collider.scale(ColliderShape::scale_of(now.linear()));
		collider.friction = NodeMotion::FRICTION;
		collider.owner = r_entry.owner;
		r_entry.motions[i].pose(now, p_tick, collider);
		const bool reaches = p_reach.is_near(collider.get_swept_bounds());
		is_near = is_near || reaches;
		if (reaches) {
			r_colliders.push_back(std::move(collider));
		}
	}
	r_entry.next_look = is_near ? 0 : r_entry.next_look;
	_mesh_pieces += is_near && r_entry.tracked.is_split && !r_entry.tracked.is_bound ? int64_t(parts.size()) : 0;
}

void NodeColliders::forget_motion() {
	for (Entry &entry : _entries) {
		entry.motions.clear();
	}
}

bool pose_shape(const Ref<Shape3D> &p_shape, const Eigen::Affine3d &p_pose, ColliderShape &r_shape) {
	TrackedShape tracked;
	read_shape(p_shape->get_rid(), tracked);
	if (tracked.type == PhysicsServer3D::SHAPE_CONCAVE_POLYGON) { // it has no inside
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
