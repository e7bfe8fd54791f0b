// SPDX-License-Identifier: MIT
#include "world/world_eyes.h"

#include "field/field_view.h"
#include "shared/convert.h"
#include "shared/scene_watch.h"

#include <godot_cpp/classes/character_body3d.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/classes/rigid_body3d.hpp>
#include <godot_cpp/core/object.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// Bodies checked in a tick, one call into the engine each. More: ticks take longer. Fewer: in a crowd a body is noticed later.
constexpr size_t LOOKS_A_FRAME = 64;
// Ticks for which a body moved by script stays awake, and metres that count as motion.
constexpr int64_t STAYS_AWAKE = 120;
constexpr real_t MOTION = 0.01f;

} // namespace

void WorldEyes::start(const RID &p_space, const Callable &p_changed, uint32_t p_mask) {
	stop();
	_box.start(p_space, p_mask, p_changed);
}

void WorldEyes::stop() {
	_box.stop();
	_bodies.clear();
}

void WorldEyes::body_changed(int64_t p_status, const RID &p_body, int64_t p_instance_id) {
	const uint64_t key = uint64_t(p_body.get_id());
	Body &body = _bodies[key];
	body.instance_id = uint64_t(p_instance_id);
	body.overlaps += p_status == PhysicsServer3D::AREA_BODY_ADDED ? 1 : -1;
	if (body.overlaps <= 0) {
		_bodies.erase(key);
	}
}

void WorldEyes::tick(const Transform3D &p_world, const Vector3 &p_half_extents) {
	_ticks++;
	_box.place(p_world, p_half_extents);
	const Transform3D to_world_space = p_world.affine_inverse();
	for (size_t i = std::min(LOOKS_A_FRAME, _bodies.size()); i > 0; i--) {
		auto body = _bodies.lower_bound(_next);
		if (body == _bodies.end()) {
			body = _bodies.begin();
		}
		look(body->second, to_world_space);
		_next = body->first + 1;
	}
}

void WorldEyes::look(Body &r_body, const Transform3D &p_to_world_space) {
	const Node3D *node = Object::cast_to<Node3D>(ObjectDB::get_instance(r_body.instance_id));
	if (node == nullptr || !node->is_inside_tree()) {
		r_body.is_awake = false;
		return;
	}
	const Vector3 place = p_to_world_space.xform(node->get_global_position());
	if (r_body.has_place && (place - r_body.place).length() > MOTION) {
		r_body.awake_until = _ticks + STAYS_AWAKE;
	}
	r_body.place = place;
	r_body.has_place = true;
	const RigidBody3D *rigid = Object::cast_to<RigidBody3D>(node);
	r_body.is_awake =
			Object::cast_to<CharacterBody3D>(node) != nullptr || (rigid != nullptr && !rigid->is_sleeping()) || _ticks < r_body.awake_until;
}

std::vector<Eigen::Vector2d> WorldEyes::find_cameras(const Node3D &p_world, uint32_t p_layers) const {
	SceneWatch::get_singleton()->start(const_cast<Node3D *>(&p_world));
	return find_eyes_on_ground(&p_world, p_layers, to_eigen(p_world.get_global_transform()));
}

std::vector<Eigen::Vector2d> WorldEyes::find_bodies() const {
	std::vector<Eigen::Vector2d> bodies;
	for (const auto &[key, body] : _bodies) {
		if (body.is_awake && body.place.is_finite()) {
			bodies.emplace_back(body.place.x, body.place.z);
		}
	}
	return bodies;
}

} // namespace grass
