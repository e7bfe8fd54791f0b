// SPDX-License-Identifier: MIT
#include "physics/body_motion.h"

#include <algorithm>
#include <cmath>

using namespace godot;

namespace grass {

namespace {

// Ticks without motion after which a static body is ground again.
constexpr int STILL_TICKS = 120;

// How far a body carried by a field may deviate from its place in the field: metres, plus the same for each metre from its centre.
constexpr double RIDES_WITHIN = 1e-3;

} // namespace

// Returns whether it is where it was in the field.
bool BodyMotion::rides(const Eigen::Affine3d &p_now) const {
	return (p_now.matrix() - _before.matrix()).norm() < RIDES_WITHIN;
}

// Returns whether a body is one tick behind the field. The server moves kinematic bodies late. So one that a field carries, and that has no
// node to query, is where it was relative to the field of the tick before. If the field has just begun to move, this holds for every such
// body that does not move yet.
bool BodyMotion::follows_late(const ServerBody &p_body, const Transform3D &p_world, const FieldPath &p_field) const {
	return p_field.has_moved() && is_known() && p_body.get_kind() != ServerBody::Kind::DRIVEN && !p_body.has_leader() &&
			(p_field.has_begun() || p_world != _world_before) && rides(p_field.get_from_world_before() * to_eigen(p_world));
}

// Returns the pose in field space. Bodies that follow a jump of the field in the next tick (a world shifted about its origin, with
// kinematic bodies in it) keep their place in the field, instead of being far away.
Eigen::Affine3d BodyMotion::pose_of(const ServerBody &p_body, const Transform3D &p_world, const FieldPath &p_field) const {
	const Eigen::Affine3d world = to_eigen(p_world);
	const Eigen::Affine3d now = p_field.get_from_world() * world;
	const Eigen::Affine3d late = p_field.get_from_world_before() * world;
	if (follows_late(p_body, p_world, p_field)) {
		return late;
	}
	if (!p_field.has_jumped() || !is_known()) {
		return now;
	}
	const Eigen::Vector3d before = _before.translation();
	return (late.translation() - before).norm() < (now.translation() - before).norm() ? late : now;
}

// Returns whether the body is ground. A static body bends grass from its first motion on, until it has rested for a while. It is carried if
// the field jumped together with it, in the same tick or the next, since nodes pass their transform to the server when they are updated.
bool BodyMotion::stand(const ServerBody &p_body, const Transform3D &p_world, const Eigen::Affine3d &p_now, const FieldPath &p_field) {
	const bool has_moved = p_world != _world_before;
	_world_before = p_world;
	if (p_body.get_kind() != ServerBody::Kind::STATIC) {
		_still_ticks = 0;
		return false;
	}
	if (!is_known()) {
		_still_ticks = STILL_TICKS;
		return true;
	}
	const bool is_carried = (p_field.has_just_jumped() && (p_now.translation() - _before.translation()).norm() < FieldPath::JUMP) ||
			(p_field.has_moved() && rides(p_now));
	if (!is_carried) {
		_still_ticks = has_moved ? 0 : std::min(_still_ticks + 1, STILL_TICKS);
	}
	return _still_ticks >= STILL_TICKS;
}

// Skips the motion while it waited, which bends nothing: its path in this tick begins where an even motion would have put it a tick ago.
void BodyMotion::catch_up(const Eigen::Affine3d &p_now, int p_waited) {
	const Eigen::Vector3d way = p_now.translation() - _before.translation();
	_before.translation() += way * (double(p_waited) / double(p_waited + 1));
	_before.linear() = p_now.linear();
}

// Removes motion that was done to the body in this tick rather than by it, and adds what it did before it was known.
void BodyMotion::follow(const ServerBody &p_body, const Eigen::Affine3d &p_now, int p_waited, const BodyTick &p_tick) {
	if (p_waited > 0) {
		catch_up(p_now, p_waited);
	}
	judge(p_body, p_now, p_tick);
	_past = p_waited > 0 ? Past::PUT : _past;
}

void BodyMotion::judge(const ServerBody &p_body, const Eigen::Affine3d &p_now, const BodyTick &p_tick) {
	const MotionTick &tick = p_tick.tick;
	const FieldPath &field = p_tick.field;
	const Eigen::Matrix3d from_world = field.get_from_world().linear();
	const Eigen::Vector3d place = to_eigen(_world_before.origin);
	// The velocity with which resting bodies pass a moving field, metres per second.
	const Eigen::Vector3d passing = field.has_jumped()
			? Eigen::Vector3d(0, 0, 0)
			: Eigen::Vector3d((field.get_from_world() * place - field.get_from_world_before() * place) / tick.delta);
	if (!is_known()) {
		begin(p_body, p_now, passing, p_tick);
		return;
	}
	const Eigen::Vector3d now = p_now.translation(), before = _before.translation(), step = now - before;
	Eigen::Vector3d own = Eigen::Vector3d::Zero();
	if (!_motion.expects(step, tick)) {
		own = from_world * p_body.find_own_velocity(from_world.transpose() * (step / tick.delta - passing), p_tick.reads) + passing;
	}
	const Eigen::Vector3d from = _motion.follow(before, now, own, tick);
	if (from == now && step != Eigen::Vector3d::Zero()) {
		_before = p_now;
		_past = Past::PUT;
		return;
	}
	_before.translation() = from;
	_past = from != before ? Past::PUT : Past::FOLLOWED;
	judge_turn(p_body, p_now, p_tick);
}

// p_passing: the velocity with which resting bodies pass the field.
void BodyMotion::begin(const ServerBody &p_body, const Eigen::Affine3d &p_now, const Eigen::Vector3d &p_passing, const BodyTick &p_tick) {
	const Eigen::Affine3d &from_world = p_tick.field.get_from_world();
	const Eigen::Vector3d seen = p_body.find_server_velocity(p_tick.reads);
	const bool is_driven = p_body.get_kind() == ServerBody::Kind::DRIVEN;
	const Eigen::Vector3d own = from_world.linear() * (is_driven ? seen : p_body.find_own_velocity(seen, p_tick.reads)) + p_passing;
	const Eigen::Vector3d now = p_now.translation();
	const Eigen::Vector3d reached = p_body.has_leader() ? from_world * to_eigen(p_body.find_server_place(p_tick.reads)) : now;
	_past = Past::PUT;
	_before = p_now;
	_before.translation() = _motion.start(reached, from_world.linear() * seen + p_passing, own, p_tick.tick);
	if (reached != now) {
		const Eigen::Vector3d from = _motion.follow(reached, now, own, p_tick.tick);
		_before.translation() = from == reached ? _before.translation() : from;
	}
}

void BodyMotion::judge_turn(const ServerBody &p_body, const Eigen::Affine3d &p_now, const BodyTick &p_tick) {
	const double cosine = 0.5 * ((_before.linear().transpose() * p_now.linear()).trace() - 1.0);
	const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
	double own = 0.0;
	if (p_body.get_kind() == ServerBody::Kind::DRIVEN && angle > Motion::PLAUSIBLE_TURN) {
		own = p_body.find_turning(p_tick.reads).norm() * p_tick.tick.delta;
	}
	const bool is_mirrored = ColliderShape::mirrors(_before.linear()) != ColliderShape::mirrors(p_now.linear());
	if (!_motion.follow_turn(angle, own) || is_mirrored) {
		_before.linear() = p_now.linear();
		_past = Past::PUT;
	}
}

} // namespace grass
