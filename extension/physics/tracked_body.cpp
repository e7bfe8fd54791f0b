// SPDX-License-Identifier: MIT
#include "physics/tracked_body.h"

#include <algorithm>

using namespace godot;

namespace grass {

void TrackedBody::sleep(size_t p_place, const BodyTick &p_tick) {
	colliders.place(p_place);
	if (!keep_at_rest(p_tick.field)) {
		follow(motion.get_world_before(), false, p_tick);
	}
}

// Leaves its colliders where it was last read, so that they are found there once there is a slot.
void TrackedBody::put_off(size_t p_place, const BodyTick &p_tick) {
	const bool was_at_rest = colliders.state == BodyColliders::State::AT_REST;
	colliders.place(p_place);
	waited++;
	next_look = std::max(next_look - 1, 0); // it falls asleep as soon as others
	if (!colliders.are_still()) { // otherwise they are written, and nothing more of the body is read
		motion.stay();
		shapes.write(server, motion, motion.get_before(), colliders, p_tick);
	}
	colliders.state = was_at_rest ? BodyColliders::State::AT_REST : colliders.state;
}

void TrackedBody::read(size_t p_place, const BodyTick &p_tick) {
	if (has_left(p_tick.field) || !server.find(p_tick.reads)) {
		state = State::LOST;
		colliders.count = 0;
		colliders.mesh_pieces = 0;
		return;
	}
	if (server.get_kind() == ServerBody::Kind::CARRIER) {
		colliders.place(p_place);
		return;
	}
	const bool is_due = look(p_tick);
	const Transform3D world = server.find_place(p_tick.reads);
	follow_sleep(world, is_due, p_tick);
	colliders.place(p_place);
	if (is_due || world != motion.get_world_before() || !keep_at_rest(p_tick.field)) {
		follow(world, is_due, p_tick);
	}
	if (state == State::FULL || (state == State::PLAIN && is_due)) {
		state = is_plain() ? State::PLAIN : State::FULL;
	}
}

void TrackedBody::read_pose(const BodyTick &p_tick) {
	if (!server.find(p_tick.reads)) {
		state = State::LOST;
		return;
	}
	left_for = 0;
	next_look--;
	const Transform3D world = server.find_place(p_tick.reads);
	next_read = p_tick.look_every - 1;
	if (world != motion.get_world_before() || !keep_at_rest(p_tick.field)) {
		follow(world, false, p_tick);
	}
}

// Returns whether it moves as its velocity says, and has shapes, none of which needs a warning: then its pose is enough.
bool TrackedBody::is_plain() const {
	return server.get_kind() == ServerBody::Kind::DRIVEN && motion.is_known() && colliders.state != BodyColliders::State::STALE &&
			!shapes.is_empty() && !shapes.is_odd();
}

// Looks from time to time of what kind the body is. Returns whether its shapes are due for a look too.
bool TrackedBody::look(const BodyTick &p_tick) {
	if (next_look-- > 0) {
		return false;
	}
	const bool is_known = motion.is_known();
	server.look(is_known && server.get_kind() != ServerBody::Kind::STATIC, p_tick.reads);
	// Spreads the looks at bodies that appeared together over the ticks.
	const int phase = is_known ? 0 : int(server.get_rid().get_id() % p_tick.look_every);
	next_look = p_tick.look_every - 1 + phase;
	return true;
}

// Returns whether it has left. A moving body is kept for two more ticks: it passed grass on its way out, or was reported only after it had
// passed all of it.
bool TrackedBody::has_left(const FieldPath &p_field) {
	left_for = is_near() ? 0 : left_for + 1;
	return left_for > (motion.is_open() ? 2 : 0) && !p_field.has_jumped_lately();
}

void TrackedBody::follow(const Transform3D &p_world, bool p_is_due, const BodyTick &p_tick) {
	const Eigen::Affine3d now = motion.pose_of(server, p_world, p_tick.field);
	const bool is_ground = motion.stand(server, p_world, now, p_tick.field);
	shapes.fit_scale(now, colliders);
	motion.follow(server, now, waited, p_tick);
	waited = 0;
	if (is_ground) {
		shapes.clear(colliders);
	} else if ((p_is_due || shapes.is_empty()) && shapes.look(server, colliders, p_tick)) {
		next_look = 0;
	}
	shapes.write(server, motion, now, colliders, p_tick);
	motion.end(now);
	if (colliders.are_still()) {
		const bool stays = is_ground || server.get_kind() != ServerBody::Kind::STATIC;
		const bool is_at_rest = motion.is_at_rest() && !p_tick.field.has_just_jumped() && stays;
		colliders.state = is_at_rest ? BodyColliders::State::AT_REST : BodyColliders::State::STILL;
	}
}

// Follows a body that may sleep. A sleeping one is not queried, except from time to time whether it was moved, since the server does not
// wake it then. When it wakes, its node emits a signal, as it does when its shapes change.
void TrackedBody::follow_sleep(const Transform3D &p_world, bool p_is_due, const BodyTick &p_tick) {
	const bool has_stood = motion.is_known() && p_world == motion.get_world_before();
	const bool may_sleep = p_is_due && has_stood && server.get_kind() == ServerBody::Kind::DRIVEN;
	if (state == State::ASLEEP) {
		state = has_stood ? State::ASLEEP : State::FULL;
	} else if (may_sleep && server.watch_sleep(p_tick.woke, p_tick.reads)) {
		state = State::ASLEEP;
	}
	next_read = p_tick.look_every - 1;
}

// Returns, for a body that is where it was, whether everything else is as it was too: then its colliders are valid.
bool TrackedBody::keep_at_rest(const FieldPath &p_field) {
	const bool is_kept = colliders.state == BodyColliders::State::AT_REST && is_near() && !p_field.has_moved();
	waited = is_kept ? 0 : waited; // it has not moved meanwhile
	return is_kept;
}

bool TrackedBody::waits_for_slots(const TileManager &p_tiles) const {
	if (!is_near() || colliders.state == BodyColliders::State::STALE) {
		return false;
	}
	bool has_met = false;
	for (size_t i = colliders.first; i < size_t(colliders.first) + colliders.count; i++) {
		if (p_tiles.has_met_awake(i)) {
			return false;
		}
		has_met = has_met || p_tiles.has_met_grass(i);
	}
	return has_met;
}

// Bodies that are ground or asleep rest. Others may change their shapes where they are, so they are read.
bool TrackedBody::rests() const {
	const bool is_ground =
			server.get_kind() == ServerBody::Kind::STATIC && colliders.state == BodyColliders::State::AT_REST && shapes.is_empty();
	const bool is_asleep = state == State::ASLEEP && colliders.are_still();
	return is_near() && server.is_found() && (is_ground || is_asleep);
}

void TrackedBody::stir() {
	wake();
	next_look = 0;
	shapes.look_at_all_soon();
	colliders.state = std::min(colliders.state, BodyColliders::State::STILL);
}

void TrackedBody::wake() {
	state = state == State::ASLEEP ? State::FULL : state;
}

void TrackedBody::forget_motion() {
	motion.forget();
	state = State::FULL;
	colliders.state = BodyColliders::State::STALE;
	waited = 0;
}

} // namespace grass
