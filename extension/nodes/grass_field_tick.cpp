// SPDX-License-Identifier: MIT
// GrassField's physics ticks, and the bodies in it.
#include "nodes/grass_field.h"

#include "core/base/cpu_clock.h"
#include "shared/plant_group.h"
#include "shared/script_call.h"

#include <godot_cpp/classes/animatable_body3d.hpp>
#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/classes/static_body3d.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/core/object.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// A plant's static body stands in the grass and never moves, but is put where the next plant is.
bool is_ground_plant(const Object *p_body) {
	return Object::cast_to<StaticBody3D>(p_body) != nullptr && Object::cast_to<AnimatableBody3D>(p_body) == nullptr && is_in_plant(p_body);
}

} // namespace

void GrassField::tick(double p_delta) {
	_visited_ticks++;
	if (!is_inside_tree() || !stand()) {
		return;
	}
	_forces.pass(p_delta);
	if (!update_plants() || !is_inside_tree()) {
		return;
	}
	if (!_standing.stands() || !_properties.simulated || Engine::get_singleton()->is_editor_hint()) {
		return;
	}
	if (!outlives(*this, [&] { _work.recover(p_delta); }) || !_standing.stands()) { // a listener of the map removed it
		return;
	}
	if (_undrawn.count(last_drawn_frame, Engine::get_singleton()->get_physics_frames())) {
		_standing.read_asked(); // otherwise _before_draw() does it
	}
	_bodies.watch(_standing.get_field(), field_transform(), p_delta);
	if (!_standing.begin_tick(is_listened_to(), p_delta)) {
		_bodies.get_tracker().forget_left();
		return;
	}
	CpuClock clock;
	if (_standing.resume()) {
		_bodies.forget_motion();
	}
	update_map();
	_forces.gather(_properties.size);
	_bodies.collect(_standing.get_field(), get_world_3d(), field_transform(), _properties.param(PARAM_TELEPORT_SPEED), p_delta);
	_bodies.add_forces(_forces.get());
	_gather_ms = clock.lap();
	if (_standing.tick(_bodies.get_colliders(), _forces.get(), p_delta, _bodies.get_parallel_for())) {
		_moved_in = Engine::get_singleton()->get_physics_frames();
	}
	if (_work.wear_tracks(_bodies.get_wheels(), p_delta) && _standing.stands()) {
		emit_visits();
	}
}

bool GrassField::needs_tick() const {
	return !_rests || _life.is_waiting() || _standing.is_map_waiting();
}

// A tick of such a field would change nothing, now and later, unless something calls stir().
bool GrassField::can_rest(std::vector<RestingBody> &r_bodies) const {
	if (!is_inside_tree() || !_standing.is_shown() || _life.is_waiting() || _standing.is_map_waiting() || _plants.is_used(_standing) ||
			!_forces.find_resting(r_bodies)) {
		return false;
	}
	return !_properties.simulated || Engine::get_singleton()->is_editor_hint() ||
			(!_standing.holds_slots() && !_work.may_recover() && _bodies.find_resting(r_bodies));
}

std::vector<RestingBody> GrassField::rest() {
	std::vector<RestingBody> bodies;
	_rests = can_rest(bodies);
	if (!_rests) {
		return {};
	}
	_gather_ms = 0.0;
	if (_properties.simulated) {
		_bodies.watch(_standing.get_field(), field_transform(), 0.0); // the map may have other ground since the tick began
	}
	return bodies;
}

void GrassField::stir_by(std::span<const Mover> p_movers) {
	if (_rests && std::ranges::any_of(p_movers, [&](const Mover &p_mover) {
			return p_mover.world == _world && p_mover.box.intersects(_bodies.get_watched());
		})) {
		stir();
	}
}

// Also of a field that is neither simulated nor seen: a server has bodies. Returns false if a script freed the field.
bool GrassField::update_plants() {
	if (!_standing.stands() || Engine::get_singleton()->is_editor_hint() || !_plants.is_used(_standing)) {
		return true;
	}
	update_map();
	CpuClock clock;
	if (!_plants.update(_standing, _properties, _bodies.get_tracker())) {
		return false;
	}
	_plants_ms = clock.lap();
	return true;
}

void GrassField::_plants_left() {
	(void)_plants.put_away(); // nothing may follow this
}

// Emits signals for bodies that met grass in this tick and did not in the one before, and the reverse. Runs last in a tick, since a
// listener may change the field.
void GrassField::emit_visits() {
	const Visitors::Change change = _bodies.update_visitors(_standing.get_field().get_tiles());
	if (emit_for_each("body_exited_grass", change.exited) && is_inside_tree()) {
		(void)emit_for_each("body_entered_grass", change.entered); // nothing may follow this
	}
}

// When the field leaves the tree, every body in its grass has left the grass.
void GrassField::emit_leaving() {
	(void)emit_for_each("body_exited_grass", _bodies.leave()); // nothing may follow this
}

bool GrassField::emit_for_each(const char *p_signal, const std::vector<uint64_t> &p_bodies) {
	for (const uint64_t id : p_bodies) {
		Node3D *body = Object::cast_to<Node3D>(ObjectDB::get_instance(id));
		if (body != nullptr && !outlives(*this, [&] { emit_signal(p_signal, body); })) {
			return false;
		}
	}
	return true;
}

// Returns whether a script listens for bodies in the grass, visible or not.
bool GrassField::is_listened_to() const {
	return has_connections("body_entered_grass") || has_connections("body_exited_grass");
}

void GrassField::_body_changed(int64_t p_status, const RID &p_body, int64_t p_instance_id, int64_t p_body_shape, int64_t p_area_shape) {
	(void)p_body_shape; // see BodyTracker::body_changed()
	(void)p_area_shape; // the area has one shape
	if (p_status == PhysicsServer3D::AREA_BODY_ADDED && is_ground_plant(ObjectDB::get_instance(uint64_t(p_instance_id)))) {
		return;
	}
	stir();
	_bodies.get_tracker().body_changed(p_status, p_body, p_instance_id);
	if (!_bodies.get_tracker().carries(uint64_t(p_instance_id))) {
		_bodies.get_wheels().body_changed(p_status, p_instance_id);
	}
}

void GrassField::_area_changed(int64_t p_status, const RID &, int64_t p_instance_id, int64_t, int64_t) {
	stir();
	_forces.get_areas().area_changed(p_status, p_instance_id);
}

void GrassField::_body_woke(int64_t p_body) {
	stir();
	_bodies.get_tracker().body_woke(p_body);
}

} // namespace grass
