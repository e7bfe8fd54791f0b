// SPDX-License-Identifier: MIT
// The node's life, its physics ticks and its frames.
#include "nodes/grass_field.h"

#include "convert.h"
#include "core/base/cpu_clock.h"
#include "core/field/grass_at.h"
#include "gpu/gpu_backend.h"
#include "nodes/field_view.h"
#include "nodes/main_thread.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

GrassField::GrassField() {
	GrassPatch::prepare_default(); // until it enters the tree
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
				frame(get_process_delta_time());
			}
			break;
		case NOTIFICATION_INTERNAL_PHYSICS_PROCESS:
			if (belongs_here()) {
				physics_tick(get_physics_process_delta_time());
			}
			break;
		case NOTIFICATION_TRANSFORM_CHANGED:
			update_configuration_warnings();
			break;
	}
}

// A thread group of its own runs a node on another thread, where neither bodies nor the renderer can be reached.
bool GrassField::belongs_here() const {
	const bool is_main = is_main_thread();
	if (!is_main) {
		ERR_PRINT_ONCE(message("it stands still in a thread group. Set `process_thread_group` of the field to Main Thread."));
	}
	return is_main;
}

void GrassField::enter() {
	FieldMonitors::add(this);
	set_process_internal(true);
	set_physics_process_internal(true);
	RenderingServer::get_singleton()->connect("frame_pre_draw", callable_mp(this, &GrassField::_before_draw));
	if (!Engine::get_singleton()->is_editor_hint()) {
		_tracker.start(get_world_3d()->get_space(), callable_mp(this, &GrassField::_body_changed), uint32_t(_properties.collision_mask));
	}
	if (!_properties.is_on_cpu) {
		GpuBackend::begin_passes(!_properties.species.is_plain(), _properties.method);
	}
	request_rebuild();
}

void GrassField::leave() {
	FieldMonitors::remove(this);
	RenderingServer::get_singleton()->disconnect("frame_pre_draw", callable_mp(this, &GrassField::_before_draw));
	set_process_internal(false);
	set_physics_process_internal(false);
	_tracker.stop();
	_backend.reset();
	_ground.free();
	emit_leaving();
	_field.forget_map();
	_map.reset();
	_maker.forget();
	_field.rest();
}

void GrassField::physics_tick(double p_delta) {
	build();
	if (!_backend || !_properties.simulated || Engine::get_singleton()->is_editor_hint()) {
		return;
	}
	recover(p_delta);
	if (!_backend) { // a listener of the map did that
		return;
	}
	if (!_field.begin_tick(*_backend, _properties.method, is_listened_to(), p_delta)) {
		_tracker.forget_left();
		return;
	}
	CpuClock clock;
	if (_field.resume()) {
		_tracker.forget_motion();
		_node_colliders.forget_motion();
	}
	update_map();
	collect_bodies(p_delta);
	_gather_ms = clock.lap();
	_field.set_params(_properties.field_params(_species));
	if (_field.tick(*_backend, _colliders, p_delta)) {
		request_draw();
	}
	emit_visits();
}

void GrassField::collect_bodies(double p_delta) {
	const Transform3D transform = field_transform();
	const double height = _field.get_setup().blade_length();
	const Vector3 half(real_t(0.5 * _field.get_grid().get_size_x() + height), real_t(height + _field.ground_relief()),
			real_t(0.5 * _field.get_grid().get_size_z() + height));
	const MotionTick tick{ .delta = p_delta, .teleport_speed = param(PARAM_TELEPORT_SPEED) };
	_tracker.set_box(transform, half, p_delta);
	_tracker.collect(transform, tick, _colliders);
	_node_colliders.collect(transform, tick, _colliders);
}

// What time heals in a tick.
void GrassField::recover(double p_delta) {
	const RecoveryRates rates = _properties.recovery_rates(_species);
	const Ref<GrassMap> &map = _properties.map;
	if (map.is_valid() && map->is_readable() && !rates.is_none()) {
		const SharesAt shares = [this](const Eigen::Vector2d &p_place) {
			return _field.get_setup().species->get_shares_at(p_place.cast<float>(), _field.get_layers());
		};
		const MapRegion region = MapRegion::of_grid(_field.get_grid());
		map.ptr()->change([&](PaintMap &r_map) {
			return _recovery.step(r_map, region, kind_of(_field), rates, p_delta, _field.get_setup().species ? shares : nullptr);
		});
	}
}

// Signals for bodies that met grass in this tick and did not in the one before, and the other way round. Last in a tick: who listens may
// change the field.
void GrassField::emit_visits() {
	const Visitors::Change change = _visitors.update(_field.get_tiles(), _colliders);
	emit_for_each("body_exited_grass", change.exited);
	emit_for_each("body_entered_grass", change.entered);
}

// Where the grass goes, nobody is in it any more.
void GrassField::emit_leaving() {
	emit_for_each("body_exited_grass", _visitors.leave());
}

void GrassField::emit_for_each(const char *p_signal, const std::vector<uint64_t> &p_bodies) {
	for (const uint64_t id : p_bodies) {
		if (Node3D *body = Object::cast_to<Node3D>(ObjectDB::get_instance(id))) {
			emit_signal(p_signal, body);
		}
	}
}

void GrassField::frame(double p_delta) {
	build();
	update_fill();
	if (!_backend) {
		return;
	}
	// Before drawing begins: what is set in _before_draw() draws no further frame.
	if (_uniforms.blow(_properties, p_delta) && _field.is_seen()) {
		set_wind_clock();
		_wind_updates++;
	}
}

void GrassField::follow() {
	const Transform3D transform = field_transform();
	_backend->follow(this, transform);
	_ground.follow(this, transform, _properties.has_ground && _field.ground_relief() == 0.0); // it is flat
}

// The camera has its pose of this frame only now. Comes in a paused tree too, unlike frame().
void GrassField::_before_draw() {
	build(); // also where the tree is paused from the first frame on
	if (!_backend) {
		return;
	}
	CpuClock clock;
	update_map();
	const bool was_seen = _field.is_seen();
	const FieldView view = find_view();
	_field.see(view, is_visible_in_tree());
	_backend->show_motion(view.has_motion, view.has_motion && _uniforms.keep_wind_clock(uniform_setter(false)));
	follow();
	if (!view.cameras.empty() && (_field.is_seen() || was_seen)) { // once more, to know that nothing is drawn
		_backend->draw(view);
		watch_room();
	}
	if (_field.is_seen() && !was_seen && param(PARAM_WIND_SPEED) > 0.0) {
		set_wind_clock();
		_wind_updates++;
	}
	_frame_ms = clock.lap();
}

// Says once, as soon as it is known, that more tiles are seen than have room.
void GrassField::watch_room() {
	const FieldSetup &setup = _field.get_setup();
	if (_is_crowded || int(setup.grid.get_tile_count()) <= std::min(setup.instance_capacity(), setup.shadow_capacity())) {
		return;
	}
	const auto [picture, shadows] = _backend->get_statistics().left_out_tiles;
	if (picture + shadows > 0) {
		_is_crowded = true;
		update_configuration_warnings();
		if (!Engine::get_singleton()->is_editor_hint()) { // there it stands beside the node
			WARN_PRINT(vformat("%s: %s", label(), crowded_warning()));
		}
	}
}

// Whether a script wants to know of bodies in the grass, seen or not.
bool GrassField::is_listened_to() const {
	return !get_signal_connection_list("body_entered_grass").is_empty() || !get_signal_connection_list("body_exited_grass").is_empty();
}

// From all cameras; from none if it is hidden.
FieldView GrassField::find_view() {
	FieldView view;
	if (!is_visible_in_tree()) {
		return view;
	}
	const Eigen::Affine3d field = to_eigen(field_transform());
	view.cameras = find_cameras(this, field);
	if (view.cameras.empty()) {
		return view;
	}
	view.lod = _properties.lod();
	view.has_motion = are_motion_vectors_read(this);
	if (get_cast_shadows_setting() != SHADOW_CASTING_SETTING_OFF) {
		view.shadow_distance = float(param(PARAM_SHADOW_DISTANCE));
		view.shadow_margin = float(param(PARAM_SHADOW_MARGIN));
		view.falls = find_falls(this, field, _field.get_setup().blade_height() + _field.ground_range(), param(PARAM_SHADOW_DISTANCE));
	}
	return view;
}

void GrassField::_body_changed(int64_t p_status, const RID &p_body, int64_t p_instance_id, int64_t p_body_shape, int64_t p_area_shape) {
	(void)p_body_shape; // see BodyTracker::body_changed()
	(void)p_area_shape; // the area has one shape
	_tracker.body_changed(p_status, p_body, p_instance_id);
}

Transform3D GrassField::field_transform() const {
	const Transform3D transform = get_global_transform();
	if (!transform.is_finite() || transform.basis.determinant() == 0.0) {
		return Transform3D(Basis(), transform.origin.is_finite() ? transform.origin : Vector3());
	}
	Transform3D turned = transform.orthonormalized();
	if (turned.basis.determinant() < 0.0) { // a mirrored field would turn its blades inside out
		turned.basis.scale_local(Vector3(-1, 1, 1));
	}
	return turned.is_finite() ? turned : Transform3D(Basis(), transform.origin);
}

} // namespace grass
