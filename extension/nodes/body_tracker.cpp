// SPDX-License-Identifier: MIT
#include "nodes/body_tracker.h"

#include "convert.h"

#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/core/object.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// Blades slide along bodies more easily than bodies along each other: a share of the body's own friction.
constexpr double BLADE_FRICTION = 0.5;

// Shapes that were added in the physics server itself have no owner in the node.
bool is_disabled(const CollisionObject3D *p_node, int32_t p_shape) {
	const PackedInt32Array owners = const_cast<CollisionObject3D *>(p_node)->get_shape_owners();
	for (int64_t i = 0; i < owners.size(); i++) {
		const uint32_t owner = uint32_t(owners[i]);
		for (int32_t k = 0; k < p_node->shape_owner_get_shape_count(owner); k++) {
			if (p_node->shape_owner_get_shape_index(owner, k) == p_shape) {
				return p_node->is_shape_owner_disabled(owner);
			}
		}
	}
	return false;
}

// A body that covers more than this in one tick, beyond what its motion explains, was put there: grass
// between the two places is not swept. Metres. Smaller: fast animated bodies miss grass. Larger: a teleport mows.
constexpr double TELEPORT_DISTANCE = 2.0;
// Bodies are known from this far outside of the grass on, since the server reports them a tick late. Metres, what
// the fastest body covers in a tick or two. Smaller: its first metres of grass stay up. Larger: more bodies to look at.
constexpr double APPROACH = 3.0;

// Moves as its velocity says. Kinematic bodies have one too, but it is made from the places where they were put.
bool is_driven_by_velocity(int64_t p_mode) {
	return p_mode == PhysicsServer3D::BODY_MODE_RIGID || p_mode == PhysicsServer3D::BODY_MODE_RIGID_LINEAR;
}

} // namespace

void scale_shape(ColliderShape &r_shape, const Eigen::Matrix3d &p_basis) {
	const Eigen::Vector3d scale = p_basis.colwise().norm();
	if (scale.isApproxToConstant(1.0, 1e-4) || !scale.allFinite()) {
		return;
	}
	if (r_shape.type == GRASS_BOX || r_shape.type == GRASS_HULL) {
		r_shape.size = r_shape.size.cwiseProduct(scale);
	} else { // round about y: radius, half length along y
		r_shape.size = { r_shape.size.x() * std::max(scale.x(), scale.z()), r_shape.size.y() * scale.y(), 0.0 };
	}
	for (Eigen::Vector4f &plane : r_shape.planes) {
		const Eigen::Vector3f normal = plane.head<3>().cwiseQuotient(scale.cast<float>());
		plane = Eigen::Vector4f(normal.x(), normal.y(), normal.z(), plane.w()) / normal.norm();
	}
}

void BodyTracker::start(const RID &p_space, const Callable &p_changed, uint32_t p_mask) {
	stop();
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	_mask = p_mask;
	_box = server->box_shape_create();
	_area = server->area_create();
	server->area_add_shape(_area, _box);
	server->area_set_collision_layer(_area, 0);
	server->area_set_collision_mask(_area, p_mask);
	server->area_set_monitorable(_area, false);
	server->area_set_monitor_callback(_area, p_changed);
	server->area_set_space(_area, p_space);
}

void BodyTracker::set_box(const Transform3D &p_transform, const Vector3 &p_half_extents) {
	if (_area.is_valid()) {
		PhysicsServer3D *server = PhysicsServer3D::get_singleton();
		server->shape_set_data(_box, p_half_extents + real_t(APPROACH) * Vector3(1, 1, 1));
		server->area_set_transform(_area, p_transform);
	}
}

void BodyTracker::set_mask(uint32_t p_mask) {
	_mask = p_mask;
	if (_area.is_valid()) {
		PhysicsServer3D::get_singleton()->area_set_collision_mask(_area, p_mask);
	}
}

void BodyTracker::stop() {
	if (_area.is_valid()) {
		PhysicsServer3D *server = PhysicsServer3D::get_singleton();
		server->free_rid(_area);
		server->free_rid(_box);
	}
	_area = _box = RID();
	_bodies.clear();
}

// Counts overlaps, and leaves aside which shape it is: indices shift when shapes come and go, and the server reports
// the end of an overlap under an index of before.
void BodyTracker::body_changed(int64_t p_status, const RID &p_body, int64_t p_instance_id) {
	const uint64_t key = uint64_t(p_body.get_id());
	if (p_status == PhysicsServer3D::AREA_BODY_ADDED) {
		Body &body = _bodies[key];
		body.rid = p_body;
		body.instance_id = uint64_t(p_instance_id);
		body.overlaps++;
		return;
	}
	auto found = _bodies.find(key);
	if (found != _bodies.end() && --found->second.overlaps <= 0) {
		_bodies.erase(found);
	}
}

// The body's pose in field space. False while the body counts as ground.
bool BodyTracker::pose_of(
		Body &p_body, const CollisionObject3D *p_node, const Eigen::Affine3d &p_field_from_world, double p_delta, Eigen::Affine3d &r_now) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	const Transform3D world = server->body_get_state(p_body.rid, PhysicsServer3D::BODY_STATE_TRANSFORM);
	const int64_t mode = server->body_get_mode(p_body.rid);
	Eigen::Vector3d step = Eigen::Vector3d::Zero(); // metres that its velocity takes it in a tick
	if (is_driven_by_velocity(mode)) {
		const Vector3 velocity = server->body_get_state(p_body.rid, PhysicsServer3D::BODY_STATE_LINEAR_VELOCITY);
		step = p_field_from_world.linear() * to_eigen(velocity) * p_delta;
	}
	r_now = p_field_from_world * to_eigen(world);
	if (!p_body.has_before) { // the tick in which it was found counts too
		p_body.before = r_now;
		p_body.before.translation() -= step;
		p_body.world_found = world;
		p_body.has_before = true;
	}
	if (mode == PhysicsServer3D::BODY_MODE_STATIC && !(p_node != nullptr && p_node->is_class("RigidBody3D"))) { // a frozen one is no ground
		p_body.has_moved = p_body.has_moved || !world.is_equal_approx(p_body.world_found);
		if (!p_body.has_moved) {
			return false;
		}
	}
	const double moved = (r_now.translation() - p_body.before.translation()).norm();
	const double explained = std::max(step.norm(), p_body.last_step);
	p_body.last_step = moved;
	if (moved > TELEPORT_DISTANCE + 1.5 * explained) {
		p_body.before = r_now;
		p_body.last_step = 0.0;
	}
	return true;
}

void BodyTracker::collect(const Transform3D &p_field, double p_delta, std::vector<ColliderShape> &r_colliders) {
	const Eigen::Affine3d field_from_world = to_eigen(p_field).inverse(Eigen::Isometry);
	for (auto entry = _bodies.begin(); entry != _bodies.end();) {
		Body &body = entry->second;
		const CollisionObject3D *node = nullptr;
		if (body.instance_id != 0) {
			node = Object::cast_to<CollisionObject3D>(ObjectDB::get_instance(body.instance_id));
			if (node == nullptr) { // freed, but listed until the server's next report
				entry = _bodies.erase(entry);
				continue;
			}
		}
		++entry;
		Eigen::Affine3d now;
		if (pose_of(body, node, field_from_world, p_delta, now)) {
			collect_shapes(body, node, now, r_colliders);
		}
		body.before = now;
	}
}

// All shapes that are enabled. Those far from the grass find no tile.
void BodyTracker::collect_shapes(
		Body &p_body, const CollisionObject3D *p_node, const Eigen::Affine3d &p_now, std::vector<ColliderShape> &r_colliders) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	const int32_t count = int32_t(server->body_get_shape_count(p_body.rid));
	const double friction = server->body_get_param(p_body.rid, PhysicsServer3D::BODY_PARAM_FRICTION);
	p_body.shapes.resize(size_t(count));
	for (int32_t index = 0; index < count; index++) {
		if (p_node != nullptr && is_disabled(p_node, index)) {
			continue;
		}
		TrackedShape &tracked = p_body.shapes[size_t(index)];
		if (!read_shape(server->body_get_shape(p_body.rid, index), tracked)) {
			continue;
		}
		const Eigen::Affine3d local = to_eigen(server->body_get_shape_transform(p_body.rid, index)) * tracked.offset;
		ColliderShape collider = tracked.shape;
		scale_shape(collider, (p_now * local).linear());
		collider.owner = p_body.instance_id;
		collider.friction = std::clamp(BLADE_FRICTION * friction, 0.0, 1.0);
		collider.set_poses(p_body.before * local, p_now * local);
		r_colliders.push_back(collider);
	}
}

} // namespace grass
