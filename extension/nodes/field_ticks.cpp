// SPDX-License-Identifier: MIT
#include "nodes/field_ticks.h"

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

// Returns whether it is a plant's static body: it never moves, but is put where the next plant is.
bool is_ground_plant(const Object *p_body) {
	return Object::cast_to<StaticBody3D>(p_body) != nullptr && Object::cast_to<AnimatableBody3D>(p_body) == nullptr && is_in_plant(p_body);
}

// Returns the nodes that carry the field. When its place in the tree changes, the field enters again.
std::vector<uint64_t> find_carriers(const Node &p_field) {
	std::vector<uint64_t> carriers;
	for (const Node *node = p_field.get_parent(); node != nullptr; node = node->get_parent()) {
		carriers.push_back(node->get_instance_id());
	}
	return carriers;
}

bool is_editor() {
	return Engine::get_singleton()->is_editor_hint();
}

} // namespace

void FieldTicks::enter(const Callbacks &p_callbacks) {
	const Ref<World3D> world = _parts.node().get_world_3d();
	_world = world->get_instance_id();
	if (!is_editor()) {
		_parts.bodies.get_tracker().start(world->get_space(), p_callbacks.body_changed, p_callbacks.area_changed, p_callbacks.body_woke,
				uint32_t(_parts.properties.collision_mask), find_carriers(_parts.node()));
	}
}

void FieldTicks::leave() {
	_record.stop_record();
	_parts.bodies.get_tracker().stop();
	_parts.bodies.get_wheels().clear();
	_parts.forces.get_areas().clear();
}

void FieldTicks::tick(double p_delta) {
	_visited++;
	if (!_parts.node().is_inside_tree() || !_parts.host.stand()) {
		return;
	}
	if (_record.is_playing()) {
		play(); // nothing may follow this
		return;
	}
	_parts.forces.pass(p_delta);
	if (!update_plants() || !_parts.node().is_inside_tree()) {
		return;
	}
	if (!_parts.standing.stands() || !_parts.properties.simulated || is_editor()) {
		return;
	}
	if (!outlives(_parts.node(), [&] { _parts.work.recover(p_delta); }) || !_parts.standing.stands()) { // a listener of the map removed it
		return;
	}
	if (simulate(p_delta) && _parts.work.wear_tracks(_parts.bodies.get_wheels(), p_delta) && _parts.standing.stands()) {
		emit_visits();
	}
}

// Returns false if the field skips this tick.
bool FieldTicks::simulate(double p_delta) {
	StandingField &standing = _parts.standing;
	FieldBodies &bodies = _parts.bodies;
	const Transform3D transform = _parts.host.field_transform();
	if (_undrawn.count(last_drawn_frame, Engine::get_singleton()->get_physics_frames())) {
		standing.read_asked(); // otherwise FieldFrames::before_draw() does it
	}
	bodies.watch(standing.get_field(), transform, p_delta);
	if (!standing.begin_tick(is_listened_to(), p_delta)) {
		bodies.get_tracker().forget_left();
		return false;
	}
	CpuClock clock;
	if (standing.resume()) {
		bodies.forget_motion();
	}
	update_map();
	_parts.forces.gather(_parts.properties.size);
	bodies.collect(standing.get_field(), _parts.node().get_world_3d(), transform, _parts.properties.param(PARAM_TELEPORT_SPEED), p_delta);
	bodies.add_forces(_parts.forces.get());
	_gather_ms = clock.lap();
	const FieldParams params = standing.find_params();
	if (_record.is_recording()) {
		_record.begin_tick(params, bodies.get_colliders(), _parts.forces.get(), p_delta);
	}
	if (standing.tick(params, bodies.get_colliders(), _parts.forces.get(), p_delta, bodies.get_parallel_for())) {
		_moved_in = Engine::get_singleton()->get_physics_frames();
	}
	_record.end_tick();
	return true;
}

// Bodies, forces and whatever changes the map come from the record.
void FieldTicks::play() {
	std::optional<TickRecord> tick = _record.read_tick();
	if (!tick || !_parts.standing.stands()) {
		return; // and the field may be gone
	}
	StandingField &standing = _parts.standing;
	standing.begin_tick(true, tick->delta);
	(void)standing.resume();
	update_map();
	if (standing.tick(tick->params, tick->colliders, tick->forces, tick->delta, serial_for)) {
		_moved_in = Engine::get_singleton()->get_physics_frames();
	}
	_record.compare(*tick);
}

bool FieldTicks::needs_tick() const {
	return !_rests || _record.is_playing() || _parts.life.is_waiting() || _parts.standing.is_map_waiting();
}

// Returns whether a tick would change nothing, now and later, unless something calls stir().
bool FieldTicks::can_rest(std::vector<RestingBody> &r_bodies) const {
	const StandingField &standing = _parts.standing;
	if (!_parts.node().is_inside_tree() || !standing.get_picture().is_shown() || _parts.life.is_waiting() || standing.is_map_waiting() ||
			_parts.plants.is_used(standing) || !_parts.forces.find_resting(r_bodies)) {
		return false;
	}
	return !_parts.properties.simulated || is_editor() ||
			(!standing.holds_slots() && !_parts.work.may_recover() && _parts.bodies.find_resting(r_bodies));
}

std::vector<RestingBody> FieldTicks::rest() {
	std::vector<RestingBody> bodies;
	_rests = can_rest(bodies);
	if (!_rests) {
		return {};
	}
	_gather_ms = 0.0;
	if (_parts.properties.simulated) {
		// the map may have other ground since the tick began
		_parts.bodies.watch(_parts.standing.get_field(), _parts.host.field_transform(), 0.0);
	}
	return bodies;
}

bool FieldTicks::is_stirred_by(std::span<const Mover> p_movers) const {
	return _rests && std::ranges::any_of(p_movers, [&](const Mover &p_mover) {
		return p_mover.world == _world && p_mover.box.intersects(_parts.bodies.get_watched());
	});
}

// Runs for a field that is neither simulated nor seen too: a server has bodies. Returns false if a script freed the field.
bool FieldTicks::update_plants() {
	if (!_parts.standing.stands() || is_editor() || !_parts.plants.is_used(_parts.standing)) {
		return true;
	}
	update_map();
	return _parts.plants.update(_parts.standing, _parts.properties, _parts.bodies.get_tracker());
}

void FieldTicks::update_map() {
	if (_parts.standing.is_map_waiting()) {
		_parts.host.stir(); // what it shows then may need another look
	}
	if (!_parts.standing.update_map()) {
		WARN_PRINT_ONCE(vformat(String::utf8("%s: `map` has more painted chunks under the field than the field can show (%d, about "
											 "8 km\u00b2). The rest stays bare. Use several smaller fields."),
				_parts.host.label(), GRASS_MAX_LAYERS));
	}
}

// Bodies are drawn that far on their way from the tick before to the last one. In ticks in which no blade moved, or which the field
// skipped, both steps are the same.
float FieldTicks::find_share() const {
	const Engine *engine = Engine::get_singleton();
	const bool is_moving = engine->get_physics_frames() == _moved_in;
	return is_moving ? std::clamp(float(engine->get_physics_interpolation_fraction()), 0.0f, 1.0f) : 1.0f;
}

// Emits signals for bodies that met grass in this tick and did not in the one before, and the reverse. Runs last in a tick, since a
// listener may change the field.
void FieldTicks::emit_visits() {
	const Visitors::Change change = _parts.bodies.update_visitors(_parts.standing.get_field().get_tiles());
	if (emit_for_each("body_exited_grass", change.exited) && _parts.node().is_inside_tree()) {
		(void)emit_for_each("body_entered_grass", change.entered); // nothing may follow this
	}
}

void FieldTicks::emit_leaving() {
	(void)emit_for_each("body_exited_grass", _parts.bodies.leave()); // nothing may follow this
}

// Returns false if a script freed the field.
bool FieldTicks::emit_for_each(const char *p_signal, const std::vector<uint64_t> &p_bodies) {
	GeometryInstance3D &node = _parts.node();
	for (const uint64_t id : p_bodies) {
		Node3D *body = Object::cast_to<Node3D>(ObjectDB::get_instance(id));
		if (body != nullptr && !outlives(node, [&] { node.emit_signal(p_signal, body); })) {
			return false;
		}
	}
	return true;
}

// Returns whether a script listens for bodies in the grass, visible or not.
bool FieldTicks::is_listened_to() const {
	return _parts.node().has_connections("body_entered_grass") || _parts.node().has_connections("body_exited_grass");
}

void FieldTicks::body_changed(int64_t p_status, const RID &p_body, int64_t p_instance_id) {
	if (p_status == PhysicsServer3D::AREA_BODY_ADDED && is_ground_plant(ObjectDB::get_instance(uint64_t(p_instance_id)))) {
		return;
	}
	_parts.host.stir();
	_parts.bodies.get_tracker().body_changed(p_status, p_body, p_instance_id);
	if (!_parts.bodies.get_tracker().carries(uint64_t(p_instance_id))) {
		_parts.bodies.get_wheels().body_changed(p_status, p_instance_id);
	}
}

void FieldTicks::area_changed(int64_t p_status, int64_t p_instance_id) {
	_parts.host.stir();
	_parts.forces.get_areas().area_changed(p_status, p_instance_id);
}

void FieldTicks::body_woke(int64_t p_body) {
	_parts.host.stir();
	_parts.bodies.get_tracker().body_woke(p_body);
}

void FieldTicks::register_collider(Node3D *p_node, const Ref<Shape3D> &p_shape) {
	const FieldHost &host = _parts.host;
	_parts.host.stir();
	ERR_FAIL_COND_MSG(p_node == nullptr || p_shape.is_null(), host.message("register_collider() needs a node and its shape."));
	if (_parts.bodies.get_registered().add(p_node, p_shape)) {
		return;
	}
	const String what = vformat("the %s registered for '%s'", p_shape->get_class(), p_node->get_name());
	const bool is_polygon = p_shape->is_class("ConvexPolygonShape3D") || p_shape->is_class("ConcavePolygonShape3D");
	ERR_FAIL_COND_MSG(is_polygon,
			host.message(vformat(
					"%s encloses no volume. Before you register it, give it at least four points that are not all in one plane.", what)));
	ERR_FAIL_MSG(host.message(vformat("%s bends no grass. Use a sphere, box, capsule, cylinder or convex polygon.", what)));
}

void FieldTicks::unregister_collider(Node3D *p_node) {
	ERR_FAIL_NULL_MSG(p_node, _parts.host.message("unregister_collider() needs a node."));
	_parts.bodies.get_registered().remove(p_node->get_instance_id());
}

void FieldTicks::add_to(FieldStatistics &r_statistics) const {
	_parts.bodies.add_to(r_statistics);
	_parts.plants.add_to(r_statistics);
	r_statistics.visited_ticks = _visited;
	r_statistics.reads.add(_shared_reads);
	r_statistics.forces = int64_t(_parts.forces.get().size());
	r_statistics.forces_left_out = _parts.forces.get_left_out();
	r_statistics.gather_ms = _gather_ms;
}

} // namespace grass
