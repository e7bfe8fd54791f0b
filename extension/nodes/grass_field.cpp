// SPDX-License-Identifier: MIT
// The node's life cycle, its physics ticks and its frames.
#include "nodes/grass_field.h"

#include "core/base/cpu_clock.h"
#include "core/solver/hang.h"
#include "draw/quit.h"
#include "draw/shared_shader.h"
#include "field/field_view.h"
#include "shared/convert.h"
#include "shared/main_thread.h"
#include "shared/plant_group.h"
#include "shared/scene_watch.h"
#include "shared/script_call.h"

#include <godot_cpp/classes/animatable_body3d.hpp>
#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/static_body3d.hpp>
#include <godot_cpp/classes/window.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <algorithm>
#include <utility>

using namespace godot;

namespace grass {

namespace {

Transform3D without_scale(const Transform3D &p_transform) {
	if (!p_transform.is_finite() || p_transform.basis.determinant() == 0.0) {
		return Transform3D(Basis(), p_transform.origin.is_finite() ? p_transform.origin : Vector3());
	}
	Transform3D turned = p_transform.orthonormalized();
	if (turned.basis.determinant() < 0.0) { // a mirrored field would turn its blades inside out
		turned.basis.scale_local(Vector3(-1, 1, 1));
	}
	return turned.is_finite() ? turned : Transform3D(Basis(), p_transform.origin);
}

// A plant's static body stands in the grass and never moves, but is put where the next plant is.
bool is_ground_plant(const Object *p_body) {
	return Object::cast_to<StaticBody3D>(p_body) != nullptr && Object::cast_to<AnimatableBody3D>(p_body) == nullptr && is_in_plant(p_body);
}

} // namespace

GrassField::GrassField() {
	GrassPatch::prepare_default(); // starts early, before the node enters the tree
	set_notify_transform(true);
}

void GrassField::_notification(int p_what) {
	switch (p_what) {
		case NOTIFICATION_ENTER_WORLD:
			enter();
			break;
		case NOTIFICATION_EXIT_WORLD:
			leave();
			break;
		case NOTIFICATION_INTERNAL_PROCESS:
			if (belongs_here()) {
				callable_mp(this, &GrassField::_frame).call_deferred(get_process_delta_time());
			}
			break;
		case NOTIFICATION_INTERNAL_PHYSICS_PROCESS:
			if (belongs_here()) {
				callable_mp(this, &GrassField::_physics_tick).call_deferred(get_physics_process_delta_time());
			}
			break;
		case NOTIFICATION_RESET_PHYSICS_INTERPOLATION:
			_moved_in = UINT64_MAX; // it was moved elsewhere: do not interpolate between the two places
			break;
		case NOTIFICATION_TRANSFORM_CHANGED:
			turn();
			update_configuration_warnings();
			break;
	}
}

// In the editor the blades follow gravity while somebody turns the field. In a game they keep the shape that they were made with: a field
// that turns over would be made again every few degrees.
void GrassField::turn() {
	const bool is_edited = Engine::get_singleton()->is_editor_hint() && is_inside_tree();
	if (is_edited && find_pull(to_eigen(field_transform()).linear()) != _properties.species.get_pull()) {
		request_rebuild();
	}
}

// A separate thread group runs a node on another thread, on which neither bodies nor the renderer may be used.
bool GrassField::belongs_here() const {
	const bool is_main = is_main_thread();
	if (!is_main) {
		ERR_PRINT_ONCE(message("it is not simulated in a thread group. Set `process_thread_group` of the field to Main Thread."));
	}
	return is_main;
}

void GrassField::enter() {
	if (FieldMonitors::get_fields().empty()) {
		hold_shader_jobs(); // the first frame with a field may need shaders in new variants
	}
	watch_for_quit(get_tree()->get_root());
	FieldMonitors::add(this);
	SceneWatch::get_singleton()->start(this);
	set_process_internal(true);
	set_physics_process_internal(true);
	RenderingServer::get_singleton()->connect("frame_pre_draw", callable_mp(this, &GrassField::_before_draw));
	if (!Engine::get_singleton()->is_editor_hint()) {
		_bodies.get_tracker().start(get_world_3d()->get_space(), callable_mp(this, &GrassField::_body_changed),
				callable_mp(this, &GrassField::_area_changed), callable_mp(this, &GrassField::_body_woke),
				uint32_t(_properties.collision_mask), find_carriers());
	}
	(void)_properties.update_quality();
	_standing.begin_passes();
	request_rebuild();
}

// Returns the nodes that carry the field. When its place in the tree changes, the field enters again.
std::vector<uint64_t> GrassField::find_carriers() const {
	std::vector<uint64_t> carriers;
	for (const Node *node = get_parent(); node != nullptr; node = node->get_parent()) {
		carriers.push_back(node->get_instance_id());
	}
	return carriers;
}

void GrassField::leave() {
	FieldMonitors::remove(this);
	if (FieldMonitors::get_fields().empty()) {
		forget_shader_jobs();
	}
	RenderingServer::get_singleton()->disconnect("frame_pre_draw", callable_mp(this, &GrassField::_before_draw));
	set_process_internal(false);
	set_physics_process_internal(false);
	_bodies.get_tracker().stop();
	_bodies.get_wheels().clear();
	_forces.get_areas().clear();
	_terrain.leave();
	_life.leave();
	if (!_plants.leave()) {
		return;
	}
	if (_plants.is_waiting()) {
		callable_mp(this, &GrassField::_plants_left).call_deferred();
	}
	emit_leaving();
}

void GrassField::_physics_tick(double p_delta) {
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

// Once a frame: in _frame(), which is there where nothing is drawn, or else before it is drawn, as in a paused tree.
bool GrassField::advance() {
	const uint64_t frame = Engine::get_singleton()->get_process_frames();
	if (std::exchange(_advanced_in, frame) == frame) {
		return stand();
	}
	if (_properties.update_quality()) {
		_standing.update_quality();
	}
	return _life.advance();
}

void GrassField::_frame(double p_delta) {
	if (!is_inside_tree() || !advance()) {
		return;
	}
	if (!update_terrain() || !update_fill()) {
		return;
	}
	if (is_inside_tree() && _standing.stands()) {
		_forces.gather(_properties.size);
		_standing.blow(_forces.get(), p_delta); // before drawing begins: a change in _before_draw() causes no further frame
	}
}

// Runs when the camera has its pose of this frame, which is not earlier. Also runs in a paused tree, unlike frame().
void GrassField::_before_draw() {
	if (!advance() || !_standing.stands()) {
		return;
	}
	CpuClock clock;
	update_map();
	const Transform3D place = drawn_transform();
	const FieldView view = is_visible_in_tree() ? find_view(this, place, _properties, _standing.get_field()) : FieldView();
	if (is_compatibility() && !view.cameras.empty()) {
		_standing.show_light(_other_light.find(this));
	}
	_standing.read_asked();
	if (view.has_motion) {
		expect_motion_vectors();
	}
	_standing.show_between(is_physics_interpolated_and_enabled(), find_share());
	_standing.show_motion(view.has_motion);
	_standing.follow(this, place);
	if (_standing.draw(view, is_visible_in_tree())) {
		update_configuration_warnings();
		if (!Engine::get_singleton()->is_editor_hint()) { // there the node itself shows it
			warn(_standing.crowded_warning());
		}
	}
	if (_standing.notice_blind_budget()) {
		update_configuration_warnings();
		if (!Engine::get_singleton()->is_editor_hint()) {
			warn(StandingField::blind_warning());
		}
	}
	_frame_ms = clock.lap();
}

// Returns the share of the last step in this frame: bodies are drawn that far on their way from the tick before to the last one. In ticks
// in which no blade moved, or which the field skipped, both steps are the same.
float GrassField::find_share() const {
	const Engine *engine = Engine::get_singleton();
	const bool is_moving = engine->get_physics_frames() == _moved_in;
	return is_moving ? std::clamp(float(engine->get_physics_interpolation_fraction()), 0.0f, 1.0f) : 1.0f;
}

// Returns whether a script listens for bodies in the grass, visible or not.
bool GrassField::is_listened_to() const {
	return !get_signal_connection_list("body_entered_grass").is_empty() || !get_signal_connection_list("body_exited_grass").is_empty();
}

void GrassField::_body_changed(int64_t p_status, const RID &p_body, int64_t p_instance_id, int64_t p_body_shape, int64_t p_area_shape) {
	(void)p_body_shape; // see BodyTracker::body_changed()
	(void)p_area_shape; // the area has one shape
	if (p_status == PhysicsServer3D::AREA_BODY_ADDED && is_ground_plant(ObjectDB::get_instance(uint64_t(p_instance_id)))) {
		return;
	}
	_bodies.get_tracker().body_changed(p_status, p_body, p_instance_id);
	if (!_bodies.get_tracker().carries(uint64_t(p_instance_id))) {
		_bodies.get_wheels().body_changed(p_status, p_instance_id);
	}
}

void GrassField::_area_changed(int64_t p_status, const RID &p_area, int64_t p_instance_id, int64_t p_other_shape, int64_t p_own_shape) {
	(void)p_area;
	(void)p_other_shape;
	(void)p_own_shape;
	_forces.get_areas().area_changed(p_status, p_instance_id);
}

AABB GrassField::_get_aabb() const {
	return _standing.get_bounds();
}

Transform3D GrassField::field_transform() const {
	return without_scale(get_global_transform());
}

Transform3D GrassField::drawn_transform() {
	return without_scale(get_global_transform_interpolated());
}

} // namespace grass
