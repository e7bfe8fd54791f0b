// SPDX-License-Identifier: MIT
#include "nodes/body_tracker.h"

#include "convert.h"

#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/core/object.hpp>

using namespace godot;

namespace grass {

namespace {

// A body that covers more than this in one tick, beyond what its velocity explains, was put there: grass
// between the two places is not swept. Metres. Smaller: fast animated bodies miss grass. Larger: a teleport mows.
constexpr double TELEPORT_DISTANCE = 2.0;

} // namespace

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
		server->shape_set_data(_box, p_half_extents);
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

void BodyTracker::body_changed(int64_t p_status, const RID &p_body, int64_t p_instance_id, int64_t p_body_shape) {
	const uint64_t key = uint64_t(p_body.get_id());
	if (p_status == PhysicsServer3D::AREA_BODY_ADDED) {
		Body &body = _bodies[key];
		body.rid = p_body;
		body.instance_id = uint64_t(p_instance_id);
		body.overlapping.insert(p_body_shape);
		return;
	}
	auto found = _bodies.find(key);
	if (found != _bodies.end()) {
		found->second.overlapping.erase(p_body_shape);
		found->second.shapes.erase(p_body_shape);
		if (found->second.overlapping.empty()) {
			_bodies.erase(found);
		}
	}
}

// The body's pose in field space. False while the body counts as ground.
bool BodyTracker::pose_of(Body &p_body, const Eigen::Affine3d &p_field_from_world, double p_delta, Eigen::Affine3d &r_now) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	const Transform3D world = server->body_get_state(p_body.rid, PhysicsServer3D::BODY_STATE_TRANSFORM);
	r_now = p_field_from_world * to_eigen(world);
	if (!p_body.has_before) {
		p_body.before = r_now;
		p_body.has_before = true;
	}
	const double moved = (r_now.translation() - p_body.before.translation()).norm();
	if (server->body_get_mode(p_body.rid) == PhysicsServer3D::BODY_MODE_STATIC) {
		p_body.has_moved = p_body.has_moved || !r_now.isApprox(p_body.before, 1e-6);
		if (!p_body.has_moved) {
			return false;
		}
	}
	if (moved > TELEPORT_DISTANCE) {
		const Vector3 velocity = server->body_get_state(p_body.rid, PhysicsServer3D::BODY_STATE_LINEAR_VELOCITY);
		if (moved > TELEPORT_DISTANCE + 1.5 * velocity.length() * p_delta) {
			p_body.before = r_now;
		}
	}
	return true;
}

void BodyTracker::collect(const Transform3D &p_field, double p_delta, std::vector<ColliderShape> &r_colliders) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	const Eigen::Affine3d field_from_world = to_eigen(p_field).inverse(Eigen::Isometry);
	for (auto entry = _bodies.begin(); entry != _bodies.end();) {
		Body &body = entry->second;
		// A freed body is still listed until the server's next report.
		if (body.instance_id != 0 && ObjectDB::get_instance(body.instance_id) == nullptr) {
			entry = _bodies.erase(entry);
			continue;
		}
		++entry;
		Eigen::Affine3d now;
		if (!pose_of(body, field_from_world, p_delta, now)) {
			body.before = now;
			continue;
		}
		const int64_t count = server->body_get_shape_count(body.rid);
		for (const int64_t index : body.overlapping) {
			if (index >= count) {
				continue;
			}
			TrackedShape &tracked = body.shapes[index];
			if (!read_shape(server->body_get_shape(body.rid, int32_t(index)), tracked)) {
				continue;
			}
			const Eigen::Affine3d local = to_eigen(server->body_get_shape_transform(body.rid, int32_t(index))) * tracked.offset;
			ColliderShape collider = tracked.shape;
			collider.id = (body.rid.get_id() << 8) ^ uint64_t(index);
			collider.set_poses(body.before * local, now * local);
			r_colliders.push_back(collider);
		}
		body.before = now;
	}
}

} // namespace grass
