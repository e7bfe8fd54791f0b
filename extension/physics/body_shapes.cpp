// SPDX-License-Identifier: MIT
#include "physics/body_shapes.h"

#include "shared/convert.h"
#include "shared/label.h"

#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/object.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// Looks at a body's shapes in every tick after one that found a change. More: a changing shape is noticed at once for longer.
constexpr int LIVELY_LOOKS = 60;
// Looks between two looks at everything, including friction and disabled shapes. If such a shape touches grass, the server also notifies:
// an overlap begins or ends.
constexpr int LOOK_AT_ALL_EVERY = 2;

bool is_odd_shape(const TrackedShape &p_shape) {
	return p_shape.is_bound || p_shape.type == PhysicsServer3D::SHAPE_HEIGHTMAP;
}

} // namespace

void ShapeWarnings::warn_of(const ServerBody &p_body, const TrackedShape &p_shape) {
	bool &has_warned = _has_warned[p_shape.type == PhysicsServer3D::SHAPE_HEIGHTMAP ? 0 : p_shape.is_bound ? 1 : 2];
	if (has_warned) {
		return;
	}
	const Node *node = Object::cast_to<Node>(ObjectDB::get_instance(p_body.get_instance_id()));
	const String words = why_other(p_shape, node == nullptr ? String("A body without a node") : label_of(*node));
	if (!words.is_empty()) {
		has_warned = true;
		WARN_PRINT(words);
	}
}

void BodyShapes::clear(BodyColliders &r_colliders) {
	if (!_shapes.empty()) {
		_shapes.clear(); // a terrain's are large
		r_colliders.state = BodyColliders::State::STALE;
	}
}

bool BodyShapes::is_odd() const {
	return std::ranges::any_of(_shapes, is_odd_shape);
}

bool BodyShapes::look(const ServerBody &p_body, BodyColliders &r_colliders, const BodyTick &p_tick) {
	const bool was_known = !_shapes.empty();
	const bool has_changed = read(p_body, r_colliders, p_tick) && was_known;
	_lively_looks = has_changed ? LIVELY_LOOKS : std::max(_lively_looks - 1, 0);
	return _lively_looks > 0;
}

// Returns whether the game has changed one.
bool BodyShapes::read(const ServerBody &p_body, BodyColliders &r_colliders, const BodyTick &p_tick) {
	const int32_t count = int32_t(PhysicsServer3D::get_singleton()->body_get_shape_count(p_body.get_rid()));
	p_tick.reads.engine_calls++;
	bool has_changed = size_t(count) != _shapes.size();
	if (has_changed) {
		r_colliders.state = BodyColliders::State::STALE;
	}
	if (has_changed || _next_look_at_all-- <= 0) {
		_next_look_at_all = LOOK_AT_ALL_EVERY - 1;
		_friction = p_body.find_friction(p_tick.reads);
		_disabled = p_body.find_disabled(count, p_tick.reads);
	}
	_shapes.resize(size_t(count));
	for (int32_t index = 0; index < count; index++) {
		if (read_one(p_body, index, r_colliders, p_tick)) {
			has_changed = true;
			_next_look_at_all = 0;
		}
	}
	return has_changed;
}

bool BodyShapes::read_one(const ServerBody &p_body, int32_t p_index, BodyColliders &r_colliders, const BodyTick &p_tick) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	TrackedShape &shape = _shapes[size_t(p_index)];
	p_tick.reads.shapes++;
	p_tick.reads.engine_calls += 2;
	const bool is_enabled = !_disabled[size_t(p_index)];
	const Transform3D transform = server->body_get_shape_transform(p_body.get_rid(), p_index);
	const bool was_changed = read_shape(server->body_get_shape(p_body.get_rid(), p_index), shape, &p_tick.reads.engine_calls);
	const bool was_split = split_mesh(shape); // into pieces, which is not a change by the game
	const bool is_same = !was_changed && transform == shape.transform && shape.enabled == is_enabled && shape.friction == _friction;
	if (is_same && !was_split) {
		return false;
	}
	if (is_enabled && shape.is_simplified) {
		p_tick.warnings.warn_of(p_body, shape);
	}
	r_colliders.state = BodyColliders::State::STALE;
	shape.transform = transform;
	shape.enabled = is_enabled;
	shape.friction = _friction;
	for (ShapePart &part : shape.parts) {
		part.local = to_eigen(transform) * part.offset;
		fit_part(part);
	}
	return !is_same;
}

// Scales and mirrors the part as the body, and the shape's transform in it, require.
void BodyShapes::fit_part(ShapePart &r_part) const {
	r_part.has_pose = false;
	r_part.collider = r_part.shape;
	r_part.collider.scale(ColliderShape::scale_of(_scale.asDiagonal() * r_part.local.linear()));
	r_part.collider.friction = _friction;
}

void BodyShapes::fit_scale(const Eigen::Affine3d &p_now, BodyColliders &r_colliders) {
	constexpr double SAME_SCALE = 1e-4;
	const Eigen::Vector3d scale = ColliderShape::scale_of(p_now.linear());
	if (_scale.isApprox(scale, SAME_SCALE) || !scale.allFinite()) {
		return;
	}
	_scale = scale;
	r_colliders.state = BodyColliders::State::STALE;
	for (TrackedShape &shape : _shapes) {
		for (ShapePart &part : shape.parts) {
			fit_part(part);
		}
	}
}

void BodyShapes::write(const ServerBody &p_body, const BodyMotion &p_motion, const Eigen::Affine3d &p_now, BodyColliders &r_colliders,
		const BodyTick &p_tick) {
	const Eigen::Affine3d &before = p_motion.get_before();
	const bool stands_still = before.matrix() == p_now.matrix();
	if (stands_still && r_colliders.are_still() && !p_motion.was_put()) {
		return;
	}
	size_t next = r_colliders.first;
	r_colliders.mesh_pieces = 0;
	for (TrackedShape &shape : _shapes) {
		if (shape.enabled && !stands_still && is_odd_shape(shape)) {
			p_tick.warnings.warn_of(p_body, shape);
		}
		for (ShapePart &part : shape.parts) {
			if (!shape.enabled) {
				part.has_pose = false;
				continue;
			}
			if (next == p_tick.colliders.size()) {
				p_tick.colliders.emplace_back();
			}
			ColliderShape &collider = p_tick.colliders[next++]; // reuses the memory of the old collider
			if (r_colliders.state == BodyColliders::State::STALE) {
				collider = part.collider;
				collider.owner = p_body.get_instance_id();
			}
			// It usually starts where it ended in the tick before.
			collider.before = part.has_pose && !p_motion.was_put() ? part.pose : ColliderShape::make_pose(before * part.local);
			collider.now = stands_still ? collider.before : ColliderShape::make_pose(p_now * part.local);
			collider.stamp = stands_still ? ++p_tick.stamps : 0;
			part.pose = collider.now;
			part.has_pose = true;
		}
		r_colliders.mesh_pieces += shape.enabled && shape.is_split && !shape.is_bound ? int64_t(shape.parts.size()) : 0;
	}
	r_colliders.count = uint32_t(next) - r_colliders.first;
	r_colliders.state = stands_still ? BodyColliders::State::STILL : BodyColliders::State::MOVING;
}

} // namespace grass
