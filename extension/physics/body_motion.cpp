// SPDX-License-Identifier: MIT
// Where BodyTracker takes a body to be, how it tells motion from being put somewhere, and in which ticks it checks a body.
#include "physics/body_tracker.h"

#include "shared/convert.h"

#include <godot_cpp/classes/character_body3d.hpp>
#include <godot_cpp/core/object.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace grass {

// Ticks without motion after which a static body is ground again.
constexpr int STILL_TICKS = 120;

// How far a body carried by a field may deviate from its place in the field: metres, plus the same for each metre from its centre.
constexpr double RIDES_WITHIN = 1e-3;

// Returns where it is in this tick. A node that a script moves tells the server after the field's tick, and the server moves the body later
// still: the body that is drawn is where its node is.
Transform3D BodyTracker::find_place(const Body &p_body, BodyReads &r_reads) {
	r_reads.poses++;
	r_reads.engine_calls += p_body.node != nullptr ? 2 : 1;
	return p_body.node != nullptr && p_body.node->is_inside_tree() ? p_body.node->get_global_transform() : p_body.state->get_transform();
}

// Returns whether it is where it was in the field.
bool BodyTracker::rides(const Body &p_body, const Eigen::Affine3d &p_now) {
	return (p_now.matrix() - p_body.before.matrix()).norm() < RIDES_WITHIN;
}

// The server moves kinematic bodies late. So one that is carried by a field, and has no node to ask, is one tick behind: it is where it was
// relative to the field of the tick before. If the field has just begun to move, this holds for every such body that does not move yet.
bool BodyTracker::follows_late(const Body &p_body, const Transform3D &p_world, const FieldPose &p_field) {
	return p_field.has_moved && p_body.has_before && !p_body.is_driven && p_body.node == nullptr &&
			(p_field.has_begun || p_world != p_body.world_before) && rides(p_body, p_field.from_world_before * to_eigen(p_world));
}

// Returns the pose in field space. Bodies that follow a jump of the field in the next tick (a world shifted about its origin, with
// kinematic bodies in it) keep their place in the field, instead of being far away.
Eigen::Affine3d BodyTracker::pose_of(const Body &p_body, const Transform3D &p_world, const FieldPose &p_field) const {
	const Eigen::Affine3d world = to_eigen(p_world);
	const Eigen::Affine3d now = p_field.from_world * world;
	const Eigen::Affine3d late = p_field.from_world_before * world;
	if (follows_late(p_body, p_world, p_field)) {
		return late;
	}
	if (!p_field.has_jumped || !p_body.has_before) {
		return now;
	}
	const Eigen::Vector3d before = p_body.before.translation();
	return (late.translation() - before).norm() < (now.translation() - before).norm() ? late : now;
}

// Returns where the server has it, in field space. Its velocity led there, and its node may be a tick ahead. p_now: its pose in this tick.
Eigen::Vector3d BodyTracker::server_place(const Body &p_body, const Eigen::Affine3d &p_now, const Following &p_following) {
	if (p_body.node == nullptr) {
		return p_now.translation();
	}
	p_following.reads.engine_calls++;
	return p_following.field.from_world * to_eigen(p_body.state->get_transform().origin);
}

// Returns the velocity in the world, metres per second. A kinematic body's velocity follows from the places where it was put, including
// teleports.
Eigen::Vector3d BodyTracker::server_velocity(const Body &p_body, BodyReads &r_reads) {
	r_reads.engine_calls++;
	return to_eigen(p_body.state->get_linear_velocity());
}

// Returns the velocity that moves it, in the world; zero if unknown. p_motion: its motion in this tick, to choose between the velocity that
// a character wanted and the one that was possible.
Eigen::Vector3d BodyTracker::own_velocity(const Body &p_body, const Eigen::Vector3d &p_motion, BodyReads &r_reads) {
	if (p_body.is_driven) {
		return server_velocity(p_body, r_reads);
	}
	const CharacterBody3D *character =
			p_body.is_character ? Object::cast_to<CharacterBody3D>(ObjectDB::get_instance(p_body.instance_id)) : nullptr;
	if (character == nullptr) {
		return Eigen::Vector3d::Zero();
	}
	r_reads.engine_calls += 2;
	const Eigen::Vector3d wanted = to_eigen(character->get_velocity()), real = to_eigen(character->get_real_velocity());
	return (real - p_motion).norm() < (wanted - p_motion).norm() ? real : wanted;
}

// Removes motion that was done to the body in this tick rather than by it, and adds what it did before it was known.
void BodyTracker::judge_motion(Body &r_body, const Eigen::Affine3d &p_now, const Following &p_following) {
	const MotionTick &tick = p_following.tick;
	const FieldPose &field = p_following.field;
	const Eigen::Matrix3d from_world = field.from_world.linear();
	const Eigen::Vector3d now = p_now.translation(), place = to_eigen(r_body.world_before.origin);
	// The velocity with which resting bodies pass a moving field, metres per second.
	const Eigen::Vector3d passing = field.has_jumped
			? Eigen::Vector3d(0, 0, 0)
			: Eigen::Vector3d((field.from_world * place - field.from_world_before * place) / tick.delta);
	r_body.was_put = !r_body.has_before;
	if (!r_body.has_before) {
		const Eigen::Vector3d seen = server_velocity(r_body, p_following.reads);
		const Eigen::Vector3d own = r_body.is_driven ? seen : own_velocity(r_body, seen, p_following.reads);
		r_body.has_before = true;
		r_body.before = p_now;
		const Eigen::Vector3d reached = server_place(r_body, p_now, p_following);
		r_body.before.translation() = r_body.motion.start(reached, from_world * seen + passing, from_world * own + passing, tick);
		if (reached != now) {
			const Eigen::Vector3d from = r_body.motion.follow(reached, now, from_world * own + passing, tick);
			r_body.before.translation() = from == reached ? r_body.before.translation() : from;
		}
		return;
	}
	const Eigen::Vector3d before = r_body.before.translation(), step = now - before;
	Eigen::Vector3d own = Eigen::Vector3d::Zero();
	if (!r_body.motion.expects(step, tick)) {
		own = from_world * own_velocity(r_body, from_world.transpose() * (step / tick.delta - passing), p_following.reads) + passing;
	}
	const Eigen::Vector3d from = r_body.motion.follow(before, now, own, tick);
	if (from == now && step != Eigen::Vector3d::Zero()) {
		r_body.before = p_now;
		r_body.was_put = true;
		return;
	}
	r_body.before.translation() = from;
	r_body.was_put = from != before;
	judge_turn(r_body, p_now, p_following);
}

void BodyTracker::judge_turn(Body &r_body, const Eigen::Affine3d &p_now, const Following &p_following) {
	const double cosine = 0.5 * ((r_body.before.linear().transpose() * p_now.linear()).trace() - 1.0);
	const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
	double own = 0.0;
	if (r_body.is_driven && angle > Motion::PLAUSIBLE_TURN) {
		own = to_eigen(r_body.state->get_angular_velocity()).norm() * p_following.tick.delta;
		p_following.reads.engine_calls++;
	}
	const bool is_mirrored = ColliderShape::mirrors(r_body.before.linear()) != ColliderShape::mirrors(p_now.linear());
	if (!r_body.motion.follow_turn(angle, own) || is_mirrored) {
		r_body.before.linear() = p_now.linear();
		r_body.was_put = true;
	}
}

// Returns whether it is ground. A static body bends grass from its first motion on, until it has rested for a while. p_is_carried: the
// field jumped together with the body, in the same tick or the next, since nodes pass their transform to the server when they are updated.
bool BodyTracker::is_ground(Body &r_body, const Transform3D &p_world, bool p_is_carried) const {
	if (!r_body.is_static) {
		r_body.still_ticks = 0;
		r_body.world_before = p_world;
		return false;
	}
	if (!r_body.has_before || p_is_carried) { // just found
		r_body.still_ticks = r_body.has_before ? r_body.still_ticks : STILL_TICKS;
	} else {
		r_body.still_ticks = p_world == r_body.world_before ? std::min(r_body.still_ticks + 1, STILL_TICKS) : 0;
	}
	r_body.world_before = p_world;
	return r_body.still_ticks >= STILL_TICKS;
}

// What stands as ground, or sleeps. Others may change their shapes where they are, so they are read.
bool BodyTracker::find_resting(std::vector<RestingBody> &r_bodies) const {
	if (_has_field_moved || _ticks_since_jump <= JUMP_TICKS) {
		return false;
	}
	for (const auto &[id, body] : _bodies) {
		if (body.is_carrier) {
			continue;
		}
		const bool is_ground = body.is_static && body.is_at_rest && body.shapes.empty();
		if (body.overlaps <= 0 || body.state_id == 0 || !(is_ground || (body.is_asleep && body.is_written_still))) {
			return false;
		}
		r_bodies.push_back({ body.node != nullptr ? body.instance_id : body.state_id, body.world_before });
	}
	return true;
}

// Returns whether following it would have no effect: the full pool had no slot for any tile that it met.
bool BodyTracker::waits_for_slots(const Body &p_body, const TileManager &p_tiles) {
	if (p_body.overlaps <= 0 || !p_body.is_written) {
		return false;
	}
	bool has_met = false;
	for (size_t i = p_body.first_collider; i < size_t(p_body.first_collider) + p_body.colliders; i++) {
		if (p_tiles.has_met_awake(i)) {
			return false;
		}
		has_met = has_met || p_tiles.has_met_grass(i);
	}
	return has_met;
}

// Leaves its colliders where it was last read, so that they are found there once there is a slot.
void BodyTracker::wait(Body &r_body, const Following &p_following) {
	r_body.waited++;
	r_body.next_look = std::max(r_body.next_look - 1, 0); // it falls asleep as soon as others
	if (!r_body.is_written_still) { // otherwise they are there, and nothing more of the body is read
		r_body.was_put = false;
		write_shapes(r_body, r_body.before, p_following);
	}
}

// Motion while it waited bends nothing: its path in this tick begins where an even motion would have put it a tick ago.
void BodyTracker::catch_up(Body &r_body, const Eigen::Affine3d &p_now) {
	const Eigen::Vector3d way = p_now.translation() - r_body.before.translation();
	r_body.before.translation() += way * (double(r_body.waited) / double(r_body.waited + 1));
	r_body.before.linear() = p_now.linear();
}

} // namespace grass
