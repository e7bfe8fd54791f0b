// SPDX-License-Identifier: MIT
#include "physics/body_tracker.h"

#include "shared/convert.h"

#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// A field that moves farther in a tick jumps, and the bodies in it may follow a tick late. Metres.
constexpr double FIELD_JUMP = 2.0;

} // namespace

bool BodyTracker::carries(uint64_t p_instance_id) const {
	return std::ranges::find(_carriers, p_instance_id) != _carriers.end();
}

int64_t BodyTracker::body_count() const {
	return std::count_if(_bodies.begin(), _bodies.end(), [](const auto &p_entry) { return p_entry.second.overlaps > 0; });
}

// Returns false once the body is freed: it may stay listed until the server's next report.
bool BodyTracker::find_state(Body &r_body, BodyReads &r_reads) {
	if (r_body.state_id == 0) {
		r_reads.engine_calls += 3;
		if (r_body.instance_id != 0 && !UtilityFunctions::is_instance_id_valid(int64_t(r_body.instance_id))) {
			return false;
		}
		r_body.state = PhysicsServer3D::get_singleton()->body_get_direct_state(r_body.rid);
		r_body.state_id = r_body.state == nullptr ? 0 : r_body.state->get_instance_id();
		return r_body.state != nullptr;
	}
	r_reads.engine_calls++;
	return UtilityFunctions::is_instance_id_valid(int64_t(r_body.node != nullptr ? r_body.instance_id : r_body.state_id));
}

// A moving body is kept for two more ticks: it passed grass on its way out, or was reported only after it had passed all of it.
bool BodyTracker::has_left(Body &r_body) const {
	r_body.left_for = r_body.overlaps > 0 ? 0 : r_body.left_for + 1;
	return r_body.left_for > (r_body.motion.is_open() ? 2 : 0) && _ticks_since_jump >= JUMP_TICKS;
}

std::vector<uint64_t> BodyTracker::find_instances(size_t p_most) const {
	std::vector<uint64_t> instances;
	for (auto body = _bodies.begin(); body != _bodies.end() && instances.size() < p_most; ++body) {
		if (body->second.overlaps > 0) {
			instances.push_back(body->second.instance_id);
		}
	}
	return instances;
}

void BodyTracker::line_up() {
	if (_line.size() == _bodies.size()) {
		return;
	}
	_line.clear();
	for (auto &[id, body] : _bodies) {
		_line.push_back(&body);
	}
}

// Gives it the next places. If its colliders are elsewhere, they must be written again.
void BodyTracker::place(Body &r_body) const {
	if (r_body.first_collider != _written) {
		r_body.is_written = r_body.is_written_still = false;
		r_body.first_collider = uint32_t(_written);
	}
}

// For a body that is where it was: returns whether everything else is as it was too. Its colliders are valid then.
bool BodyTracker::keep_at_rest(Body &r_body, const FieldPose &p_field) {
	const bool is_kept = r_body.is_at_rest && r_body.overlaps > 0 && r_body.is_written_still && !p_field.has_moved;
	r_body.waited = is_kept ? 0 : r_body.waited; // it has not moved meanwhile
	return is_kept;
}

// Computes where the field is now, and how it moved since the last tick.
BodyTracker::FieldPose BodyTracker::pose_field(const Transform3D &p_field) {
	FieldPose field;
	field.from_world = to_eigen(p_field).inverse(Eigen::Isometry);
	field.from_world_before = _has_field_before ? _from_world_before : field.from_world;
	const Eigen::Vector3d origin = to_eigen(p_field.origin);
	field.has_jumped = (field.from_world_before * origin).norm() > FIELD_JUMP;
	field.has_moved = field.from_world.matrix() != field.from_world_before.matrix();
	field.has_begun = field.has_moved && !_has_field_moved;
	_from_world_before = field.from_world;
	_has_field_before = true;
	_has_field_moved = field.has_moved;
	_ticks_since_jump = field.has_jumped ? 0 : std::min(_ticks_since_jump, JUMP_TICKS) + 1;
	return field;
}

void BodyTracker::collect(const Transform3D &p_field, const MotionTick &p_tick, const TileManager &p_tiles,
		const ParallelFor &p_parallel_for, std::vector<ColliderShape> &r_colliders) {
	const FieldPose field = pose_field(p_field);
	MotionTick tick = p_tick;
	tick.watched = Eigen::AlignedBox3d(-to_eigen(_box.get_half_extents()), to_eigen(_box.get_half_extents()));
	_written = 0;
	_mesh_pieces = 0;
	_has_lost = false;
	_tick = (_tick + 1) % WAITING_TICKS;
	line_up();
	_look_every = look_every(_line.size());
	const Following following{ field, tick, r_colliders, _reads, _stamps };
	_crowd.clear();
	for (Body *body : _line) {
		visit(*body, p_tiles, following);
	}
	follow_crowd(following, p_parallel_for);
	r_colliders.resize(_written);
	if (_has_lost) {
		std::erase_if(_bodies, [](const auto &p_entry) { return p_entry.second.is_lost; });
		_line.clear();
	}
}

// Gives its colliders their places, and follows it, unless it is plain: the crowd follows those.
void BodyTracker::visit(Body &r_body, const TileManager &p_tiles, const Following &p_following) {
	const FieldPose &field = p_following.field;
	if (r_body.is_asleep && r_body.overlaps > 0 && !field.has_moved && r_body.next_read-- > 0) {
		place(r_body);
		if (!keep_at_rest(r_body, field)) {
			follow(r_body, r_body.world_before, false, p_following);
		}
	} else if (!is_its_turn(r_body) && !field.has_moved && waits_for_slots(r_body, p_tiles)) {
		place(r_body);
		wait(r_body, p_following);
	} else if (is_plain_now(r_body)) {
		place(r_body);
		join_crowd(r_body, p_following);
	} else {
		read(r_body, p_following);
	}
	_written += r_body.colliders;
	_mesh_pieces += r_body.mesh_pieces;
}

void BodyTracker::read(Body &r_body, const Following &p_following) {
	if (has_left(r_body) || !find_state(r_body, _reads)) {
		watch_sleep(r_body, false);
		_has_lost = r_body.is_lost = true;
		r_body.colliders = 0;
		r_body.mesh_pieces = 0;
		return;
	}
	if (r_body.is_carrier) {
		place(r_body);
		return;
	}
	const bool is_due = look(r_body);
	const Transform3D world = find_place(r_body, _reads);
	follow_sleep(r_body, world, is_due);
	place(r_body);
	if (is_due || world != r_body.world_before || !keep_at_rest(r_body, p_following.field)) {
		follow(r_body, world, is_due, p_following);
	}
	if (is_due || !r_body.is_plain) {
		r_body.is_plain = is_plain(r_body);
	}
}

void BodyTracker::follow(Body &r_body, const Transform3D &p_world, bool p_is_due, const Following &p_following) {
	const Eigen::Affine3d now = pose_of(r_body, p_world, p_following.field);
	const bool is_carried = r_body.has_before &&
			((_ticks_since_jump <= 1 && (now.translation() - r_body.before.translation()).norm() < FIELD_JUMP) ||
					(p_following.field.has_moved && rides(r_body, now)));
	const bool ground = is_ground(r_body, p_world, is_carried);
	const bool has_waited = r_body.waited > 0;
	if (has_waited) {
		catch_up(r_body, now);
		r_body.waited = 0;
	}
	fit_scale(r_body, now);
	judge_motion(r_body, now, p_following);
	r_body.was_put = r_body.was_put || has_waited;
	if (ground && !r_body.shapes.empty()) {
		r_body.shapes.clear(); // unused, and a terrain's are large
		r_body.is_written = r_body.is_written_still = false;
	} else if (!ground && (p_is_due || r_body.shapes.empty())) {
		look_at_shapes(r_body);
	}
	write_shapes(r_body, now, p_following);
	r_body.before = now;
	r_body.is_at_rest = r_body.is_written_still && r_body.motion.is_at_rest() && _ticks_since_jump > 1 && (ground || !r_body.is_static);
}

void BodyTracker::forget_left() {
	const size_t before = _bodies.size();
	for (auto entry = _bodies.begin(); entry != _bodies.end();) {
		if (entry->second.overlaps > 0) {
			++entry;
		} else {
			watch_sleep(entry->second, false);
			entry = _bodies.erase(entry);
		}
	}
	if (_bodies.size() != before) {
		_line.clear();
	}
}

void BodyTracker::forget_motion() {
	_has_field_before = false;
	for (auto &[id, body] : _bodies) {
		body.has_before = body.is_asleep = body.is_at_rest = body.is_plain = body.is_written = body.is_written_still = false;
		body.waited = 0;
	}
}

} // namespace grass
