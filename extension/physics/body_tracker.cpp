// SPDX-License-Identifier: MIT
#include "physics/body_tracker.h"

#include "shared/convert.h"

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// Ticks between looks at a body's shapes. More: the grass notices a change later.
constexpr int LOOK_EVERY = 8;
// Approximate number of looks in a tick: in a crowd each body is looked at less often, in one of 5,000 every 79 ticks. More: a crowd costs
// more, since these calls are its cost.
constexpr size_t LOOKS_A_TICK = 64;

int look_every(size_t p_bodies) {
	return std::max(LOOK_EVERY, int((p_bodies + LOOKS_A_TICK - 1) / LOOKS_A_TICK));
}

} // namespace

void BodyTracker::line_up() {
	if (_line.size() == _bodies.size()) {
		return;
	}
	_line.clear();
	for (auto &[id, body] : _bodies) {
		_line.push_back(&body);
	}
}

void BodyTracker::collect(const Transform3D &p_field, const MotionTick &p_tick, const TileManager &p_tiles,
		const ParallelFor &p_parallel_for, std::vector<ColliderShape> &r_colliders) {
	_field.move_to(p_field);
	MotionTick motion_tick = p_tick;
	motion_tick.watched = Eigen::AlignedBox3d(-to_eigen(_box.get_half_extents()), to_eigen(_box.get_half_extents()));
	_written = 0;
	_mesh_pieces = 0;
	_has_lost = false;
	_tick = (_tick + 1) % WAITING_TICKS;
	line_up();
	const BodyTick tick{ _field, motion_tick, r_colliders, _reads, _stamps, _warnings, _woke, look_every(_line.size()) };
	_crowd.clear();
	for (TrackedBody *body : _line) {
		visit(*body, p_tiles, tick);
	}
	follow_crowd(tick, p_parallel_for);
	r_colliders.resize(_written);
	if (_has_lost) {
		drop([](const TrackedBody &p_body) { return p_body.state == TrackedBody::State::LOST; });
	}
}

// Follows a body, unless it is plain: the crowd follows those, once all have their places.
void BodyTracker::visit(TrackedBody &r_body, const TileManager &p_tiles, const BodyTick &p_tick) {
	const bool is_its_turn = _tick == r_body.turn, may_keep = !_field.has_moved();
	if (r_body.state == TrackedBody::State::ASLEEP && r_body.is_near() && may_keep && r_body.next_read-- > 0) {
		r_body.sleep(_written, p_tick);
	} else if (!is_its_turn && may_keep && r_body.waits_for_slots(p_tiles)) {
		r_body.put_off(_written, p_tick);
	} else if (r_body.is_plain_now()) {
		join_crowd(r_body, p_tick);
	} else {
		r_body.read(_written, p_tick);
		_has_lost = _has_lost || r_body.state == TrackedBody::State::LOST;
	}
	_written += r_body.colliders.count;
	_mesh_pieces += r_body.colliders.mesh_pieces;
}

// Forgets the bodies that p_is_gone chooses.
template <typename F> void BodyTracker::drop(F &&p_is_gone) {
	const size_t before = _bodies.size();
	for (auto entry = _bodies.begin(); entry != _bodies.end();) {
		if (p_is_gone(entry->second)) {
			entry->second.server.stop_watching(_woke);
			entry = _bodies.erase(entry);
		} else {
			++entry;
		}
	}
	if (_bodies.size() != before) {
		_line.clear();
	}
}

void BodyTracker::forget_left() {
	drop([](const TrackedBody &p_body) { return !p_body.is_near(); });
}

void BodyTracker::forget_motion() {
	_field.forget();
	for (auto &[id, body] : _bodies) {
		body.forget_motion();
	}
}

bool BodyTracker::find_resting(std::vector<RestingBody> &r_bodies) const {
	if (!_field.rests()) {
		return false;
	}
	for (const auto &[id, body] : _bodies) {
		if (body.server.get_kind() == ServerBody::Kind::CARRIER) {
			continue;
		}
		if (!body.rests()) {
			return false;
		}
		r_bodies.push_back({ body.server.get_mover(), body.motion.get_world_before() });
	}
	return true;
}

} // namespace grass
