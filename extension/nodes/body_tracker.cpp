// SPDX-License-Identifier: MIT
#include "nodes/body_tracker.h"

#include "convert.h"

#include <godot_cpp/classes/character_body3d.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace grass {

namespace {

// A field that goes farther in a tick jumps, and the bodies in it may follow a tick late. Metres.
constexpr double FIELD_JUMP = 2.0;
// The server reports bodies that overlap the watched box at the end of a tick. It reaches so far beyond the grass that every body
// up to this speed is in it at least once on its way, however small the field. Metres per second. Slower: faster bodies
// fly through small fields unseen. Faster: more bodies to look at.
constexpr double FASTEST = 600.0;
// It reaches this far at least, since bodies are reported a tick late. Metres.
constexpr double APPROACH_MIN = 3.0;
// Ticks after which a static body that moved is ground again.
constexpr int STILL_TICKS = 120;
// For so many ticks after a jump of the field, bodies that the server reports as gone are kept: kinematic ones follow late.
constexpr int JUMP_TICKS = 6;

} // namespace

void BodyTracker::start(
		const RID &p_space, const Callable &p_changed, const Callable &p_area_changed, const Callable &p_woke, uint32_t p_mask) {
	stop();
	_woke = p_woke;
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	_mask = p_mask;
	_box = server->box_shape_create();
	_area = server->area_create();
	server->area_add_shape(_area, _box);
	server->area_set_collision_layer(_area, 0);
	server->area_set_collision_mask(_area, p_mask);
	server->area_set_monitorable(_area, false);
	server->area_set_monitor_callback(_area, p_changed);
	server->area_set_area_monitor_callback(_area, p_area_changed);
	server->area_set_space(_area, p_space);
}

void BodyTracker::set_box(const Transform3D &p_transform, const Vector3 &p_half_extents, double p_delta) {
	if (!_area.is_valid()) {
		return;
	}
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	// Never shrinks, so that a game which slows down and speeds up does not change the box in every tick.
	_approach = std::max({ _approach, APPROACH_MIN, 0.5 * FASTEST * p_delta });
	const Vector3 extents = p_half_extents + real_t(_approach) * Vector3(1, 1, 1);
	if (_box_extents != extents) {
		_box_extents = extents;
		server->shape_set_data(_box, extents);
	}
	if (_box_transform != p_transform) {
		_box_transform = p_transform;
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
	_box_extents = Vector3();
	_approach = 0.0;
	_box_transform = Transform3D();
	_has_field_before = false;
	for (auto &[id, body] : _bodies) {
		watch_sleep(body, false);
	}
	_bodies.clear();
	_woke = Callable();
}

// Counts overlaps without regard to the shape: indices shift when shapes come and go, and the server reports the end of
// an overlap under the old index.
void BodyTracker::body_changed(int64_t p_status, const RID &p_body, int64_t p_instance_id) {
	const uint64_t key = uint64_t(p_body.get_id());
	auto found = _bodies.find(key);
	if (p_status == PhysicsServer3D::AREA_BODY_ADDED) {
		if (found == _bodies.end()) {
			found = _bodies.emplace(key, Body()).first;
			found->second.rid = p_body;
			found->second.instance_id = uint64_t(p_instance_id);
		}
		found->second.overlaps++;
	} else if (found != _bodies.end()) {
		found->second.overlaps--;
	}
	if (found != _bodies.end()) {
		found->second.next_look = found->second.next_look_at_all = 0; // its shapes may have changed
		found->second.is_asleep = false;
	}
}

void BodyTracker::body_woke(int64_t p_body) {
	const auto found = _bodies.find(uint64_t(p_body));
	if (found != _bodies.end()) {
		found->second.is_asleep = false;
	}
}

int64_t BodyTracker::body_count() const {
	return std::count_if(_bodies.begin(), _bodies.end(), [](const auto &p_entry) { return p_entry.second.overlaps > 0; });
}

// False once the body is freed: it may stay listed until the server's next report.
bool BodyTracker::find_state(Body &r_body) {
	if (r_body.state_id == 0) {
		_reads.engine_calls += 3;
		if (r_body.instance_id != 0 && !UtilityFunctions::is_instance_id_valid(int64_t(r_body.instance_id))) {
			return false;
		}
		r_body.state = PhysicsServer3D::get_singleton()->body_get_direct_state(r_body.rid);
		r_body.state_id = r_body.state == nullptr ? 0 : r_body.state->get_instance_id();
		return r_body.state != nullptr;
	}
	_reads.engine_calls++;
	return UtilityFunctions::is_instance_id_valid(int64_t(r_body.state_id));
}

// In field space. Bodies that follow a jump of the field in the next tick (a world shifted about its origin, with
// kinematic bodies in it) are where they were beside the field, not far away from it.
Eigen::Affine3d BodyTracker::pose_of(const Body &p_body, const Transform3D &p_world, const FieldPose &p_field) const {
	const Eigen::Affine3d world = to_eigen(p_world);
	const Eigen::Affine3d now = p_field.from_world * world;
	if (!p_field.has_jumped || !p_body.has_before) {
		return now;
	}
	const Eigen::Affine3d late = p_field.from_world_before * world;
	const Eigen::Vector3d before = p_body.before.translation();
	return (late.translation() - before).norm() < (now.translation() - before).norm() ? late : now;
}

// In the world, metres per second. A kinematic body's follows from the places where it was put, teleports included.
Eigen::Vector3d BodyTracker::server_velocity(const Body &p_body) {
	_reads.engine_calls++;
	return to_eigen(p_body.state->get_linear_velocity());
}

// The velocity that moves it, in the world; zero if unknown. p_motion: its motion in this tick, to choose between what a character wanted
// and what it could do.
Eigen::Vector3d BodyTracker::own_velocity(const Body &p_body, const Eigen::Vector3d &p_motion) {
	if (p_body.is_driven) {
		return server_velocity(p_body);
	}
	const CharacterBody3D *character =
			p_body.is_character ? Object::cast_to<CharacterBody3D>(ObjectDB::get_instance(p_body.instance_id)) : nullptr;
	if (character == nullptr) {
		return Eigen::Vector3d::Zero();
	}
	_reads.engine_calls += 2;
	const Eigen::Vector3d wanted = to_eigen(character->get_velocity()), real = to_eigen(character->get_real_velocity());
	return (real - p_motion).norm() < (wanted - p_motion).norm() ? real : wanted;
}

// Removes motion that was done to the body in this tick and not by it, and adds what it did before it was known.
void BodyTracker::judge_motion(Body &r_body, const Eigen::Affine3d &p_now, const MotionTick &p_tick) {
	const Eigen::Matrix3d from_world = _from_world_before.linear();
	const Eigen::Vector3d now = p_now.translation();
	r_body.was_put = !r_body.has_before;
	if (!r_body.has_before) {
		const Eigen::Vector3d seen = server_velocity(r_body);
		const Eigen::Vector3d own = r_body.is_driven ? seen : own_velocity(r_body, seen);
		r_body.has_before = true;
		r_body.before = p_now;
		r_body.before.translation() = r_body.motion.start(now, from_world * seen, from_world * own, p_tick);
		return;
	}
	const Eigen::Vector3d before = r_body.before.translation(), step = now - before;
	Eigen::Vector3d own = Eigen::Vector3d::Zero();
	if (!r_body.motion.expects(step, p_tick)) {
		own = from_world * own_velocity(r_body, from_world.transpose() * step / p_tick.delta);
	}
	const Eigen::Vector3d from = r_body.motion.follow(before, now, own, p_tick);
	if (from == now && step != Eigen::Vector3d::Zero()) {
		r_body.before = p_now;
		r_body.was_put = true;
		return;
	}
	r_body.before.translation() = from;
	r_body.was_put = from != before;
	judge_turn(r_body, p_now, p_tick.delta);
}

void BodyTracker::judge_turn(Body &r_body, const Eigen::Affine3d &p_now, double p_delta) {
	const double cosine = 0.5 * ((r_body.before.linear().transpose() * p_now.linear()).trace() - 1.0);
	const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
	double own = 0.0;
	if (r_body.is_driven && angle > Motion::PLAUSIBLE_TURN) {
		own = to_eigen(r_body.state->get_angular_velocity()).norm() * p_delta;
		_reads.engine_calls++;
	}
	if (!r_body.motion.follow_turn(angle, own)) {
		r_body.before.linear() = p_now.linear();
		r_body.was_put = true;
	}
}

// One that moves is kept for two ticks more: it passed grass on its way out, or was reported only when it had passed all of it.
bool BodyTracker::has_left(Body &r_body) const {
	r_body.left_for = r_body.overlaps > 0 ? 0 : r_body.left_for + 1;
	return r_body.left_for > (r_body.motion.is_open() ? 2 : 0) && _ticks_since_jump >= JUMP_TICKS;
}

// A static body bends grass from its first motion on, until it has stood still for a while. p_is_carried: the field
// jumped and the body with it, in the same tick or the next: nodes pass on either to the server when they are updated.
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

void BodyTracker::collect(const Transform3D &p_field, const MotionTick &p_tick, std::vector<ColliderShape> &r_colliders) {
	FieldPose field;
	field.from_world = to_eigen(p_field).inverse(Eigen::Isometry);
	field.from_world_before = _has_field_before ? _from_world_before : field.from_world;
	const Eigen::Vector3d origin = to_eigen(p_field.origin);
	field.has_jumped = (field.from_world_before * origin).norm() > FIELD_JUMP;
	field.has_moved = field.from_world.matrix() != field.from_world_before.matrix();
	_from_world_before = field.from_world;
	_has_field_before = true;
	_ticks_since_jump = field.has_jumped ? 0 : std::min(_ticks_since_jump, JUMP_TICKS) + 1;
	_written = 0;
	_mesh_pieces = 0;
	MotionTick tick = p_tick;
	tick.watched = Eigen::AlignedBox3d(-to_eigen(_box_extents), to_eigen(_box_extents));
	for (auto entry = _bodies.begin(); entry != _bodies.end();) {
		Body &body = entry->second;
		const bool is_asleep = body.is_asleep && !field.has_moved && body.next_read-- > 0;
		if (has_left(body) || (!is_asleep && !find_state(body))) {
			watch_sleep(body, false);
			entry = _bodies.erase(entry);
			continue;
		}
		++entry;
		bool is_due = false;
		Transform3D world = body.world_before;
		if (!is_asleep) {
			_reads.poses++;
			_reads.engine_calls++;
			is_due = look(body);
			world = body.state->get_transform();
			follow_sleep(body, world, is_due);
		}
		const Eigen::Affine3d now = pose_of(body, world, field);
		const bool is_carried =
				_ticks_since_jump <= 1 && body.has_before && (now.translation() - body.before.translation()).norm() < FIELD_JUMP;
		const bool ground = is_ground(body, world, is_carried);
		judge_motion(body, now, tick);
		if (ground) {
			body.shapes.clear(); // unused, and a terrain's are large
		} else {
			if (is_due || body.shapes.empty()) {
				look_at_shapes(body);
			}
			write_shapes(body, now, r_colliders);
		}
		body.before = now;
	}
	r_colliders.resize(_written);
}

void BodyTracker::forget_left() {
	for (auto entry = _bodies.begin(); entry != _bodies.end();) {
		if (entry->second.overlaps > 0) {
			++entry;
		} else {
			watch_sleep(entry->second, false);
			entry = _bodies.erase(entry);
		}
	}
}

void BodyTracker::forget_motion() {
	_has_field_before = false;
	for (auto &[id, body] : _bodies) {
		body.has_before = false;
		body.is_asleep = false;
	}
}

} // namespace grass
