// SPDX-License-Identifier: MIT
// How BodyTracker learns which bodies are near: it watches a box in the physics server, which reports who enters and leaves.
#include "physics/body_tracker.h"

#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/classes/soft_body3d.hpp>
#include <godot_cpp/core/object.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// The server reports bodies that overlap the watched box at the end of a tick. The box extends so far beyond the grass that every body up
// to this speed is inside it at least once on its way, however small the field. Metres per second. Slower: faster bodies fly through small
// fields unseen. Faster: more bodies to check.
constexpr double FASTEST = 600.0;
// The least extension of the box, since bodies are reported a tick late. Metres.
constexpr double APPROACH_MIN = 3.0;

} // namespace

void BodyTracker::start(const RID &p_space, const Callable &p_changed, const Callable &p_area_changed, const Callable &p_woke,
		uint32_t p_mask, std::vector<uint64_t> &&p_carriers) {
	stop();
	_woke = p_woke;
	_carriers = std::move(p_carriers);
	_mask = p_mask;
	_box.start(p_space, p_mask, p_changed, p_area_changed);
}

void BodyTracker::set_box(const Transform3D &p_transform, const Vector3 &p_half_extents, double p_delta) {
	// It never shrinks, so that a game which slows down and speeds up does not change the box in every tick.
	_approach = std::max({ _approach, APPROACH_MIN, 0.5 * FASTEST * p_delta });
	_box.place(p_transform, p_half_extents + real_t(_approach) * Vector3(1, 1, 1));
}

void BodyTracker::set_mask(uint32_t p_mask) {
	_mask = p_mask;
	_box.set_mask(p_mask);
}

void BodyTracker::stop() {
	_box.stop();
	_approach = 0.0;
	_field.forget();
	for (auto &[id, body] : _bodies) {
		body.server.stop_watching(_woke);
	}
	_bodies.clear();
	_line.clear();
	_woke = Callable();
}

// Counts overlaps regardless of the shape: indices shift when shapes are added or removed, and the server reports the end of an overlap
// with the old index.
void BodyTracker::body_changed(int64_t p_status, const RID &p_body, int64_t p_instance_id) {
	const uint64_t key = uint64_t(p_body.get_id());
	auto found = _bodies.find(key);
	if (p_status == PhysicsServer3D::AREA_BODY_ADDED && Object::cast_to<SoftBody3D>(ObjectDB::get_instance(uint64_t(p_instance_id)))) {
		return; // areas report them from Godot 4.7 on, and SoftBodies reads them
	}
	if (p_status == PhysicsServer3D::AREA_BODY_ADDED) {
		if (found == _bodies.end()) {
			const uint64_t id = uint64_t(p_instance_id);
			found = _bodies.emplace(key, TrackedBody(p_body, id, carries(id))).first;
			found->second.turn = int(key % WAITING_TICKS);
			_line.clear();
		}
		found->second.overlaps++;
	} else if (found != _bodies.end()) {
		found->second.overlaps--;
	}
	if (found != _bodies.end()) {
		found->second.stir(); // its shapes may have changed
	}
}

void BodyTracker::body_woke(int64_t p_body) {
	const auto found = _bodies.find(uint64_t(p_body));
	if (found != _bodies.end()) {
		found->second.wake();
	}
}

bool BodyTracker::carries(uint64_t p_instance_id) const {
	return std::ranges::find(_carriers, p_instance_id) != _carriers.end();
}

int64_t BodyTracker::body_count() const {
	return std::ranges::count_if(_bodies, [](const auto &p_entry) { return p_entry.second.is_near(); });
}

std::vector<uint64_t> BodyTracker::find_instances(size_t p_most) const {
	std::vector<uint64_t> instances;
	for (auto body = _bodies.begin(); body != _bodies.end() && instances.size() < p_most; ++body) {
		if (body->second.is_near()) {
			instances.push_back(body->second.server.get_instance_id());
		}
	}
	return instances;
}

} // namespace grass
