// SPDX-License-Identifier: MIT
#include "nodes/body_tracker.h"

#include "convert.h"

#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

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
// For so many ticks after a jump of the field, bodies that the server reports as gone are kept: kinematic ones follow late.
constexpr int JUMP_TICKS = 6;
// Bodies from the one at hand to that whose memory is fetched next: as long as a fetch takes.
constexpr size_t FETCH_AHEAD = 4;

// p_bytes from p_place on.
void prefetch(const void *p_place, size_t p_bytes) {
#ifdef __GNUC__
	constexpr size_t LINE = 64; // of the cache
	for (size_t i = 0; i < p_bytes; i += LINE) {
		__builtin_prefetch(static_cast<const char *>(p_place) + i);
	}
#else
	(void)p_place;
	(void)p_bytes;
#endif
}

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
	_line.clear();
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
			_line.clear();
			found->second.rid = p_body;
			found->second.instance_id = uint64_t(p_instance_id);
			found->second.turn = int(key % WAITING_TICKS);
		}
		found->second.overlaps++;
	} else if (found != _bodies.end()) {
		found->second.overlaps--;
	}
	if (found != _bodies.end()) {
		found->second.next_look = found->second.next_look_at_all = 0; // its shapes may have changed
		found->second.is_asleep = found->second.is_at_rest = false;
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

// One that moves is kept for two ticks more: it passed grass on its way out, or was reported only when it had passed all of it.
bool BodyTracker::has_left(Body &r_body) const {
	r_body.left_for = r_body.overlaps > 0 ? 0 : r_body.left_for + 1;
	return r_body.left_for > (r_body.motion.is_open() ? 2 : 0) && _ticks_since_jump >= JUMP_TICKS;
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

// A body that is where it was: whether all else is as it was, too. Its colliders then lie ready.
bool BodyTracker::keep_at_rest(Body &r_body, const FieldPose &p_field) {
	const bool is_kept = r_body.is_at_rest && r_body.overlaps > 0 && r_body.first_collider == _written && !p_field.has_moved;
	if (is_kept) {
		r_body.waited = 0; // it went nowhere meanwhile
		_written += r_body.colliders;
		_mesh_pieces += r_body.mesh_pieces;
	}
	return is_kept;
}

// What following body p_index reads, from pointer to pointer: each of them three times as far ahead as what it points to. The memory of a
// crowd is more than the caches hold.
void BodyTracker::fetch_ahead(size_t p_index, const std::vector<ColliderShape> &p_colliders) const {
	if (const size_t far = p_index + 3 * FETCH_AHEAD; far < _line.size()) {
		prefetch(_line[far], offsetof(Body, rid));
	}
	const auto is_read = [this](const Body &p_body) { return !p_body.is_asleep && (p_body.waited == 0 || is_its_turn(p_body)); };
	if (const size_t near = p_index + 2 * FETCH_AHEAD; near < _line.size() && is_read(*_line[near])) {
		const Body &body = *_line[near];
		prefetch(body.state, 1);
		for (const TrackedShape &shape : body.shapes) {
			prefetch(&shape, offsetof(TrackedShape, rid));
		}
		prefetch(p_colliders.data() + body.first_collider, body.colliders * sizeof(ColliderShape));
	}
	if (const size_t next = p_index + FETCH_AHEAD; next < _line.size() && is_read(*_line[next])) {
		const Body &body = *_line[next];
		for (const TrackedShape &shape : body.shapes) {
			for (const ShapePart &part : shape.parts) {
				prefetch(&part, ShapePart::HOT);
			}
		}
	}
}

void BodyTracker::collect(
		const Transform3D &p_field, const MotionTick &p_tick, const TileManager &p_tiles, std::vector<ColliderShape> &r_colliders) {
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
	_tick = (_tick + 1) % WAITING_TICKS;
	MotionTick tick = p_tick;
	tick.watched = Eigen::AlignedBox3d(-to_eigen(_box_extents), to_eigen(_box_extents));
	line_up();
	_look_every = look_every(_line.size());
	bool has_lost = false;
	for (size_t i = 0; i < _line.size(); i++) {
		fetch_ahead(i, r_colliders);
		Body &body = *_line[i];
		if (body.is_asleep && body.overlaps > 0 && !field.has_moved && body.next_read-- > 0) {
			if (!keep_at_rest(body, field)) {
				follow(body, body.world_before, field, tick, false, r_colliders);
			}
			continue;
		}
		if (!is_its_turn(body) && !field.has_moved && waits_for_slots(body, p_tiles)) {
			wait(body, r_colliders);
			continue;
		}
		if (has_left(body) || !find_state(body)) {
			watch_sleep(body, false);
			has_lost = true;
			body.is_lost = true;
			continue;
		}
		_reads.poses++;
		_reads.engine_calls++;
		const bool is_due = look(body);
		const Transform3D world = body.state->get_transform();
		follow_sleep(body, world, is_due);
		if (is_due || world != body.world_before || !keep_at_rest(body, field)) {
			follow(body, world, field, tick, is_due, r_colliders);
		}
	}
	if (has_lost) {
		std::erase_if(_bodies, [](const auto &p_entry) { return p_entry.second.is_lost; });
		_line.clear();
	}
	r_colliders.resize(_written);
}

void BodyTracker::follow(Body &r_body, const Transform3D &p_world, const FieldPose &p_field, const MotionTick &p_tick, bool p_is_due,
		std::vector<ColliderShape> &r_colliders) {
	const Eigen::Affine3d now = pose_of(r_body, p_world, p_field);
	const bool is_carried =
			_ticks_since_jump <= 1 && r_body.has_before && (now.translation() - r_body.before.translation()).norm() < FIELD_JUMP;
	const bool ground = is_ground(r_body, p_world, is_carried);
	const bool has_waited = r_body.waited > 0;
	if (has_waited) {
		catch_up(r_body, now);
		r_body.waited = 0;
	}
	judge_motion(r_body, now, p_tick);
	r_body.was_put = r_body.was_put || has_waited;
	if (ground && !r_body.shapes.empty()) {
		r_body.shapes.clear(); // unused, and a terrain's are large
		r_body.is_written = r_body.is_written_still = false;
	} else if (!ground && (p_is_due || r_body.shapes.empty())) {
		look_at_shapes(r_body);
	}
	write_shapes(r_body, now, r_colliders);
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
		body.has_before = body.is_asleep = body.is_at_rest = body.is_written = body.is_written_still = false;
		body.waited = 0;
	}
}

} // namespace grass
