// SPDX-License-Identifier: MIT
// How BodyTracker reads a body's shapes and makes colliders of them. Calls into the engine are most of a body's cost.
#include "physics/body_tracker.h"

#include "shared/convert.h"
#include "shared/label.h"

#include <godot_cpp/classes/animatable_body3d.hpp>
#include <godot_cpp/classes/character_body3d.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/classes/rigid_body3d.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/object.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// Blades slide along bodies more easily than bodies along each other: a share of the body's own friction.
constexpr double BLADE_FRICTION = 0.5;

// Ticks between checks of a body's shapes, and number of checks in every tick after one that found a change. More: the grass notices a
// change later.
constexpr int CHECK_EVERY = 8, LIVELY_LOOKS = 60;
// Approximate number of checks in a tick: in a crowd each body is checked less often, in one of 5,000 every 79 ticks. More: a crowd costs
// more, since these calls are its cost.
constexpr size_t LOOKS_A_TICK = 64;
// Checks between two checks of everything, including friction and disabled shapes. If such a shape touches grass, the server also notifies:
// an overlap begins or ends.
constexpr int LOOK_AT_ALL_EVERY = 2;

// Returns whether its velocity moves it. Kinematic bodies have a velocity too, but it follows from the places where they were put.
bool is_driven_by_velocity(int64_t p_mode) {
	return p_mode == PhysicsServer3D::BODY_MODE_RIGID || p_mode == PhysicsServer3D::BODY_MODE_RIGID_LINEAR;
}

// Returns whether a body of such a node stands in the grass even while a game holds it still: frozen, disabled, or made static.
bool is_made_to_move(const Object *p_node) {
	return Object::cast_to<RigidBody3D>(p_node) != nullptr || Object::cast_to<CharacterBody3D>(p_node) != nullptr ||
			Object::cast_to<AnimatableBody3D>(p_node) != nullptr;
}

// Returns which of a node's shapes are disabled, one bit for each shape. Shapes added directly in the physics server have no owner in the
// node, and are enabled.
std::vector<bool> find_disabled(const CollisionObject3D *p_node, int32_t p_count, int64_t &r_calls) {
	std::vector<bool> disabled(size_t(p_count), false);
	const PackedInt32Array owners = const_cast<CollisionObject3D *>(p_node)->get_shape_owners();
	r_calls += 1 + owners.size();
	for (int64_t i = 0; i < owners.size(); i++) {
		const uint32_t owner = uint32_t(owners[i]);
		if (!p_node->is_shape_owner_disabled(owner)) {
			continue;
		}
		for (int32_t k = 0; k < p_node->shape_owner_get_shape_count(owner); k++) {
			const int32_t index = p_node->shape_owner_get_shape_index(owner, k);
			if (index >= 0 && index < p_count) {
				disabled[size_t(index)] = true;
			}
		}
	}
	return disabled;
}

} // namespace

int BodyTracker::look_every(size_t p_bodies) {
	return std::max(CHECK_EVERY, int((p_bodies + LOOKS_A_TICK - 1) / LOOKS_A_TICK));
}

// Checks from time to time what kind of body it is. Returns whether its shapes are due for a check too.
bool BodyTracker::look(Body &r_body) {
	if (r_body.next_look-- > 0) {
		return false;
	}
	const int64_t mode = PhysicsServer3D::get_singleton()->body_get_mode(r_body.rid);
	_reads.engine_calls += mode == PhysicsServer3D::BODY_MODE_KINEMATIC || mode == PhysicsServer3D::BODY_MODE_STATIC ? 2 : 1;
	r_body.is_driven = is_driven_by_velocity(mode);
	r_body.is_character = mode == PhysicsServer3D::BODY_MODE_KINEMATIC &&
			Object::cast_to<CharacterBody3D>(ObjectDB::get_instance(r_body.instance_id)) != nullptr;
	r_body.node = find_leader(r_body, mode, _reads);
	const bool was_moving = r_body.has_before && !r_body.is_static;
	r_body.is_static =
			mode == PhysicsServer3D::BODY_MODE_STATIC && !was_moving && !is_made_to_move(ObjectDB::get_instance(r_body.instance_id));
	// Spreads the checks of bodies that appeared together over the ticks.
	const int phase = r_body.has_before ? 0 : int(r_body.rid.get_id() % _look_every);
	r_body.next_look = _look_every - 1 + phase;
	return true;
}

// Returns the node that is ahead of the server whenever it moves; nullptr for a body that the server moves, and for one that has none.
// With sync_to_physics the node waits for the server. Nodes that are no CollisionObject3D, such as terrains, put their bodies anywhere.
const CollisionObject3D *BodyTracker::find_leader(const Body &p_body, int64_t p_mode, BodyReads &r_reads) {
	if (p_mode != PhysicsServer3D::BODY_MODE_KINEMATIC && p_mode != PhysicsServer3D::BODY_MODE_STATIC) {
		return nullptr;
	}
	const Object *object = ObjectDB::get_instance(p_body.instance_id);
	const AnimatableBody3D *animatable = Object::cast_to<AnimatableBody3D>(object);
	r_reads.engine_calls += animatable != nullptr ? 1 : 0;
	if (animatable != nullptr && animatable->is_sync_to_physics_enabled()) {
		return nullptr;
	}
	const CollisionObject3D *node = Object::cast_to<CollisionObject3D>(object);
	r_reads.engine_calls += node != nullptr ? 1 : 0;
	return node != nullptr && node->get_rid() == p_body.rid ? node : nullptr;
}

// A sleeping body is not queried, except from time to time whether it was moved, since the server does not wake it then. When it wakes, its
// node emits a signal, as it does when its shapes change.
void BodyTracker::follow_sleep(Body &r_body, const Transform3D &p_world, bool p_is_due) {
	const bool has_stood = r_body.has_before && p_world == r_body.world_before;
	if (r_body.is_asleep) {
		r_body.is_asleep = has_stood;
	} else if (p_is_due && has_stood && r_body.is_driven) {
		_reads.engine_calls++;
		if (r_body.state->is_sleeping()) {
			watch_sleep(r_body, true);
			r_body.is_asleep = r_body.is_watched;
		}
	}
	r_body.next_read = _look_every - 1;
}

// Listens to the node, since the server does not report it.
void BodyTracker::watch_sleep(Body &r_body, bool p_watch) {
	if (r_body.is_watched == p_watch) {
		return;
	}
	RigidBody3D *node = Object::cast_to<RigidBody3D>(ObjectDB::get_instance(r_body.instance_id));
	if (node == nullptr) {
		return;
	}
	const Callable woke = _woke.bind(int64_t(r_body.rid.get_id()));
	if (p_watch) {
		node->connect("sleeping_state_changed", woke);
	} else {
		node->disconnect("sleeping_state_changed", woke);
	}
	r_body.is_watched = p_watch;
}

// Notices changes of shapes and friction.
void BodyTracker::look_at_shapes(Body &r_body) {
	const bool was_known = !r_body.shapes.empty();
	const bool has_changed = read_shapes(r_body) && was_known;
	r_body.lively_looks = has_changed ? LIVELY_LOOKS : std::max(r_body.lively_looks - 1, 0);
	r_body.next_look = r_body.lively_looks > 0 ? 0 : r_body.next_look;
}

// Reads what seldom changes, and does not change with the shapes themselves.
void BodyTracker::read_traits(Body &r_body, int32_t p_count) {
	const CollisionObject3D *node = Object::cast_to<CollisionObject3D>(ObjectDB::get_instance(r_body.instance_id));
	const double friction = PhysicsServer3D::get_singleton()->body_get_param(r_body.rid, PhysicsServer3D::BODY_PARAM_FRICTION);
	_reads.engine_calls += 2;
	r_body.friction = std::clamp(BLADE_FRICTION * friction, 0.0, 1.0);
	r_body.disabled = node == nullptr ? std::vector<bool>(size_t(p_count), false) : find_disabled(node, p_count, _reads.engine_calls);
}

bool BodyTracker::read_shapes(Body &r_body) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	const int32_t count = int32_t(server->body_get_shape_count(r_body.rid));
	_reads.engine_calls++;
	bool has_changed = size_t(count) != r_body.shapes.size();
	if (has_changed) {
		r_body.is_written = r_body.is_written_still = false;
	}
	if (has_changed || r_body.next_look_at_all-- <= 0) {
		r_body.next_look_at_all = LOOK_AT_ALL_EVERY - 1;
		read_traits(r_body, count);
	}
	r_body.shapes.resize(size_t(count));
	for (int32_t index = 0; index < count; index++) {
		TrackedShape &shape = r_body.shapes[size_t(index)];
		_reads.shapes++;
		const bool is_enabled = !r_body.disabled[size_t(index)];
		const Transform3D transform = server->body_get_shape_transform(r_body.rid, index);
		const bool was_changed = read_shape(server->body_get_shape(r_body.rid, index), shape, &_reads.engine_calls);
		const bool was_split = split_mesh(shape);
		const bool is_same =
				!was_changed && transform == shape.transform && shape.enabled == is_enabled && shape.friction == r_body.friction;
		_reads.engine_calls += 2;
		if (is_same && !was_split) {
			continue;
		}
		if (is_enabled && shape.is_simplified) {
			warn_of(r_body, shape);
		}
		if (!is_same) { // a split into pieces is not a change by the game
			has_changed = true;
			r_body.next_look_at_all = 0;
		}
		r_body.is_written = r_body.is_written_still = false;
		shape.transform = transform;
		shape.enabled = is_enabled;
		shape.friction = r_body.friction;
		for (ShapePart &part : shape.parts) {
			part.local = to_eigen(transform) * part.offset;
			fit_part(r_body, part);
		}
	}
	return has_changed;
}

// Scales and mirrors the part as the body, and the shape's transform in it, require.
void BodyTracker::fit_part(const Body &p_body, ShapePart &r_part) {
	r_part.has_pose = false;
	r_part.collider = r_part.shape;
	r_part.collider.scale(ColliderShape::scale_of(p_body.scale.asDiagonal() * r_part.local.linear()));
	r_part.collider.friction = p_body.friction;
}

// Updates the scale of the body itself, which its pose contains in every tick.
void BodyTracker::fit_scale(Body &r_body, const Eigen::Affine3d &p_now) {
	constexpr double SAME_SCALE = 1e-4;
	const Eigen::Vector3d scale = ColliderShape::scale_of(p_now.linear());
	if (r_body.scale.isApprox(scale, SAME_SCALE) || !scale.allFinite()) {
		return;
	}
	r_body.scale = scale;
	r_body.is_written = r_body.is_written_still = false;
	for (TrackedShape &shape : r_body.shapes) {
		for (ShapePart &part : shape.parts) {
			fit_part(r_body, part);
		}
	}
}

// Warns once for each field and kind: the user may expect that a moving body bends grass, and with its own form.
void BodyTracker::warn_of(const Body &p_body, const TrackedShape &p_shape) {
	bool &has_warned = _has_warned[p_shape.type == PhysicsServer3D::SHAPE_HEIGHTMAP ? 0 : p_shape.is_bound ? 1 : 2];
	if (has_warned) {
		return;
	}
	const Node *node = Object::cast_to<Node>(ObjectDB::get_instance(p_body.instance_id));
	const String words = why_other(p_shape, node == nullptr ? String("A body without a node") : label_of(*node));
	if (!words.is_empty()) {
		has_warned = true;
		WARN_PRINT(words);
	}
}

// Writes all enabled shapes to the places from first_collider on. Those far from the grass meet no tile.
void BodyTracker::write_shapes(Body &r_body, const Eigen::Affine3d &p_now, const Following &p_following) {
	const bool stands_still = r_body.before.matrix() == p_now.matrix();
	if (stands_still && r_body.is_written_still && !r_body.was_put) {
		return;
	}
	size_t next = r_body.first_collider;
	r_body.mesh_pieces = 0;
	for (TrackedShape &shape : r_body.shapes) {
		if (shape.enabled && !stands_still && is_odd(shape)) {
			warn_of(r_body, shape);
		}
		for (ShapePart &part : shape.parts) {
			if (!shape.enabled) {
				part.has_pose = false;
				continue;
			}
			if (next == p_following.colliders.size()) {
				p_following.colliders.emplace_back();
			}
			ColliderShape &collider = p_following.colliders[next++]; // reuses the memory of the old collider
			if (!r_body.is_written) {
				collider = part.collider;
				collider.owner = r_body.instance_id;
			}
			// It usually starts where it ended in the tick before.
			collider.before = part.has_pose && !r_body.was_put ? part.pose : ColliderShape::make_pose(r_body.before * part.local);
			collider.now = stands_still ? collider.before : ColliderShape::make_pose(p_now * part.local);
			collider.stamp = stands_still ? ++p_following.stamps : 0;
			part.pose = collider.now;
			part.has_pose = true;
		}
		r_body.mesh_pieces += shape.enabled && shape.is_split && !shape.is_bound ? int64_t(shape.parts.size()) : 0;
	}
	r_body.colliders = uint32_t(next) - r_body.first_collider;
	r_body.is_written = true;
	r_body.is_written_still = stands_still;
}

} // namespace grass
