// SPDX-License-Identifier: MIT
#include "physics/server_body.h"

#include "shared/convert.h"

#include <godot_cpp/classes/animatable_body3d.hpp>
#include <godot_cpp/classes/character_body3d.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/classes/rigid_body3d.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// Blades slide along bodies more easily than bodies along each other: a share of the body's own friction.
constexpr double BLADE_FRICTION = 0.5;

// Returns whether a body of such a node bends grass even while a game holds it still: frozen, disabled, or made static.
bool is_made_to_move(const Object *p_node) {
	return Object::cast_to<RigidBody3D>(p_node) != nullptr || Object::cast_to<CharacterBody3D>(p_node) != nullptr ||
			Object::cast_to<AnimatableBody3D>(p_node) != nullptr;
}

// Returns how a body moves that is found in this mode.
ServerBody::Kind kind_of(int64_t p_mode, uint64_t p_instance_id, bool p_has_moved) {
	const Object *node = ObjectDB::get_instance(p_instance_id);
	switch (p_mode) {
		case PhysicsServer3D::BODY_MODE_RIGID:
		case PhysicsServer3D::BODY_MODE_RIGID_LINEAR:
			return ServerBody::Kind::DRIVEN;
		case PhysicsServer3D::BODY_MODE_KINEMATIC:
			return Object::cast_to<CharacterBody3D>(node) != nullptr ? ServerBody::Kind::CHARACTER : ServerBody::Kind::PUT;
		default:
			return p_has_moved || is_made_to_move(node) ? ServerBody::Kind::PUT : ServerBody::Kind::STATIC;
	}
}

} // namespace

bool ServerBody::find(BodyReads &r_reads) {
	if (_state_id == 0) {
		r_reads.engine_calls += 3;
		if (_instance_id != 0 && !UtilityFunctions::is_instance_id_valid(int64_t(_instance_id))) {
			return false;
		}
		_state = PhysicsServer3D::get_singleton()->body_get_direct_state(_rid);
		_state_id = _state == nullptr ? 0 : _state->get_instance_id();
		return _state != nullptr;
	}
	r_reads.engine_calls++;
	return UtilityFunctions::is_instance_id_valid(int64_t(get_mover()));
}

void ServerBody::look(bool p_has_moved, BodyReads &r_reads) {
	const int64_t mode = PhysicsServer3D::get_singleton()->body_get_mode(_rid);
	r_reads.engine_calls += mode == PhysicsServer3D::BODY_MODE_KINEMATIC || mode == PhysicsServer3D::BODY_MODE_STATIC ? 2 : 1;
	_node = find_leader(mode, r_reads);
	_kind = kind_of(mode, _instance_id, p_has_moved);
}

// Returns the node that is ahead of the server whenever it moves; nullptr for a body that the server moves, and for one that has none.
// With sync_to_physics the node waits for the server. Nodes that are no CollisionObject3D, such as terrains, put their bodies anywhere.
const CollisionObject3D *ServerBody::find_leader(int64_t p_mode, BodyReads &r_reads) const {
	if (p_mode != PhysicsServer3D::BODY_MODE_KINEMATIC && p_mode != PhysicsServer3D::BODY_MODE_STATIC) {
		return nullptr;
	}
	const Object *object = ObjectDB::get_instance(_instance_id);
	const AnimatableBody3D *animatable = Object::cast_to<AnimatableBody3D>(object);
	r_reads.engine_calls += animatable != nullptr ? 1 : 0;
	if (animatable != nullptr && animatable->is_sync_to_physics_enabled()) {
		return nullptr;
	}
	const CollisionObject3D *node = Object::cast_to<CollisionObject3D>(object);
	r_reads.engine_calls += node != nullptr ? 1 : 0;
	return node != nullptr && node->get_rid() == _rid ? node : nullptr;
}

Transform3D ServerBody::find_place(BodyReads &r_reads) const {
	r_reads.poses++;
	r_reads.engine_calls += _node != nullptr ? 2 : 1;
	return _node != nullptr && _node->is_inside_tree() ? _node->get_global_transform() : _state->get_transform();
}

Vector3 ServerBody::find_server_place(BodyReads &r_reads) const {
	r_reads.engine_calls++;
	return _state->get_transform().origin;
}

Eigen::Vector3d ServerBody::find_server_velocity(BodyReads &r_reads) const {
	r_reads.engine_calls++;
	return to_eigen(_state->get_linear_velocity());
}

Eigen::Vector3d ServerBody::find_turning(BodyReads &r_reads) const {
	r_reads.engine_calls++;
	return to_eigen(_state->get_angular_velocity());
}

Eigen::Vector3d ServerBody::find_own_velocity(const Eigen::Vector3d &p_motion, BodyReads &r_reads) const {
	if (_kind == Kind::DRIVEN) {
		return find_server_velocity(r_reads);
	}
	const CharacterBody3D *character =
			_kind == Kind::CHARACTER ? Object::cast_to<CharacterBody3D>(ObjectDB::get_instance(_instance_id)) : nullptr;
	if (character == nullptr) {
		return Eigen::Vector3d::Zero();
	}
	r_reads.engine_calls += 2;
	const Eigen::Vector3d wanted = to_eigen(character->get_velocity()), real = to_eigen(character->get_real_velocity());
	return (real - p_motion).norm() < (wanted - p_motion).norm() ? real : wanted;
}

double ServerBody::find_friction(BodyReads &r_reads) const {
	r_reads.engine_calls += 2;
	const double friction = PhysicsServer3D::get_singleton()->body_get_param(_rid, PhysicsServer3D::BODY_PARAM_FRICTION);
	return std::clamp(BLADE_FRICTION * friction, 0.0, 1.0);
}

// Shapes added directly in the physics server have no owner in the node, and are enabled.
std::vector<bool> ServerBody::find_disabled(int32_t p_count, BodyReads &r_reads) const {
	std::vector<bool> disabled(size_t(p_count), false);
	CollisionObject3D *node = Object::cast_to<CollisionObject3D>(ObjectDB::get_instance(_instance_id));
	if (node == nullptr) {
		return disabled;
	}
	const PackedInt32Array owners = node->get_shape_owners();
	r_reads.engine_calls += 1 + owners.size();
	for (int64_t i = 0; i < owners.size(); i++) {
		const uint32_t owner = uint32_t(owners[i]);
		if (!node->is_shape_owner_disabled(owner)) {
			continue;
		}
		for (int32_t k = 0; k < node->shape_owner_get_shape_count(owner); k++) {
			const int32_t index = node->shape_owner_get_shape_index(owner, k);
			if (index >= 0 && index < p_count) {
				disabled[size_t(index)] = true;
			}
		}
	}
	return disabled;
}

bool ServerBody::watch_sleep(const Callable &p_woke, BodyReads &r_reads) {
	r_reads.engine_calls++;
	if (!_state->is_sleeping()) {
		return false;
	}
	RigidBody3D *node = Object::cast_to<RigidBody3D>(ObjectDB::get_instance(_instance_id));
	if (!_is_watched && node != nullptr) {
		node->connect("sleeping_state_changed", p_woke.bind(int64_t(_rid.get_id())));
		_is_watched = true;
	}
	return _is_watched;
}

void ServerBody::stop_watching(const Callable &p_woke) {
	RigidBody3D *node = _is_watched ? Object::cast_to<RigidBody3D>(ObjectDB::get_instance(_instance_id)) : nullptr;
	if (node != nullptr) {
		node->disconnect("sleeping_state_changed", p_woke.bind(int64_t(_rid.get_id())));
		_is_watched = false;
	}
}

} // namespace grass
