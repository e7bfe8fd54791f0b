// SPDX-License-Identifier: MIT
// The field's life, its physics ticks and its frames. Properties: grass_field_properties.cpp; what scripts may ask:
// grass_field_queries.cpp.
#include "nodes/grass_field.h"

#include "convert.h"
#include "core/base/cpu_clock.h"
#include "gpu/gpu_backend.h"
#include "nodes/field_view.h"
#include "nodes/main_thread.h"
#include "nodes/params.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/world3d.hpp>

using namespace godot;

namespace grass {

namespace {

// Grass this far outside of the view counts as seen: a camera that turns finds it as it should be. Metres. Smaller: bodies
// push into the grass before one's eyes when the camera turns fast. Larger: more is simulated that nobody sees.
constexpr float VIEW_MARGIN = 3.0f;

} // namespace

GrassField::GrassField() {
	GrassPatch::prepare_default(); // until it enters the tree
	for (size_t i = 0; i < _params.size(); i++) {
		_params[i] = FIELD_PARAMS[i].tunable.initial;
	}
	for (size_t i = 0; i < _colors.size(); i++) {
		_colors[i] = Color(FIELD_COLORS[i].red, FIELD_COLORS[i].green, FIELD_COLORS[i].blue);
	}
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
		_tracker.start(get_world_3d()->get_space(), callable_mp(this, &GrassField::_body_changed), uint32_t(_collision_mask));
	}
	if (_backend_mode == BACKEND_AUTO) {
		GpuBackend::begin_passes(!_species.empty(), Method(_solver_method));
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
	tell_of_leaving();
	_standing.map.reset();
	_wanted.reset();
	_tiles.reset();
}

void GrassField::physics_tick(double p_delta) {
	build();
	if (!_backend || !_simulated || Engine::get_singleton()->is_editor_hint()) {
		return;
	}
	recover(p_delta);
	if (!_backend) { // a listener of the map did that
		return;
	}
	_backend->tidy();
	choose_method();
	const bool can_simulate = _backend->can_simulate();
	if ((!_is_seen || !can_simulate) && !is_listened_to()) {
		_unseen_time += p_delta;
		_unseen_ticks += can_simulate ? 1 : 0;
		_tracker.forget_left();
		return; // nobody would know
	}
	CpuClock clock;
	if (_unseen_time > 0.0) {
		_tracker.forget_motion();
		_node_colliders.forget_motion();
		_tiles.pass_unseen(_unseen_time);
		_unseen_time = 0.0;
	}
	update_map();
	const Transform3D transform = field_transform();
	const double height = _standing.setup.blade_length();
	const Vector3 half(real_t(0.5 * _standing.setup.grid.get_size_x() + height), real_t(height + ground_reach()),
			real_t(0.5 * _standing.setup.grid.get_size_z() + height));
	const MotionTick tick{ .delta = p_delta, .teleport_speed = param(PARAM_TELEPORT_SPEED) };
	_tracker.set_box(transform, half, p_delta);
	_tracker.collect(transform, tick, _colliders);
	_node_colliders.collect(transform, tick, _colliders);
	_gather_ms = clock.lap();
	_tiles.report_energy(_backend->read_energy());
	_tiles.stir(_backend->is_complete() ? _regrown : all_tiles());
	_tiles.update(p_delta, _colliders);
	_tiles_ms = clock.lap();
	if (!can_simulate) {
		_tiles.reset(); // whom the bodies meet is known; the blades stand
	} else if (!_tiles.get_slots().empty()) { // else nothing is awake: no dispatch, no upload
		step(p_delta);
	}
	tell_of_bodies();
}

// At rest, too: who waits until nothing is being compiled shall wait for this.
void GrassField::choose_method() {
	_method_now = _backend->choose_method(Method(_solver_method));
}

void GrassField::step(double p_delta) {
	StepInput input;
	input.number = _tiles.get_step_number();
	input.slots = _tiles.get_slots();
	input.sharp = _tiles.get_sharp();
	input.colliders = _tiles.get_colliders();
	input.collider_list = _tiles.get_collider_list();
	input.planes = _tiles.get_planes();
	input.growth = grow_tiles();
	input.step = _clock.advance(solver_params(), p_delta);
	input.species = species_steps();
	input.step.field = { float(_standing.setup.grid.get_tile_size()), float(_standing.setup.grid.get_tiles_x()),
		float(_standing.setup.grid.get_tiles_z()), float(GRASS_KNOTS) };
	input.step.clump = { _standing.setup.clump.size, _standing.setup.clump.height, _standing.setup.clump.lean, _standing.setup.clump.tint };
	_backend->step(input);
	request_draw();
}

void GrassField::frame(double p_delta) {
	build();
	update_fill();
	if (!_backend) {
		return;
	}
	if (param(PARAM_WIND_SPEED) > 0.0) {
		_wind_clock.advance(p_delta, param(PARAM_WIND_SPEED), param(PARAM_GUST_SIZE));
		if (_is_seen) { // before drawing begins: what is told in _before_draw() asks for no further frame
			set_wind_clock();
			_wind_updates++;
		}
	}
}

void GrassField::follow() {
	const Transform3D transform = field_transform();
	_backend->follow(this, transform);
	_ground.follow(this, transform, _has_ground && ground_reach() == 0.0); // it is flat
}

// The camera has its pose of this frame only now. Comes in a paused tree too, unlike frame().
void GrassField::_before_draw() {
	build(); // also where the tree is paused from the first frame on
	if (!_backend) {
		return;
	}
	CpuClock clock;
	update_map();
	follow();
	const bool was_seen = _is_seen;
	const FieldView view = find_view();
	_is_seen = look(view);
	if (!view.cameras.empty() && (_is_seen || was_seen)) { // once more, to know that nothing is drawn
		_backend->draw(view);
		watch_room();
	}
	if (_is_seen && !was_seen && param(PARAM_WIND_SPEED) > 0.0) {
		set_wind_clock();
		_wind_updates++;
	}
	_frame_ms = clock.lap();
}

// Says once, as soon as it is known, that more tiles are seen than have room.
void GrassField::watch_room() {
	if (_is_crowded ||
			int(_standing.setup.grid.get_tile_count()) <=
					std::min(_standing.setup.instance_capacity(), _standing.setup.shadow_capacity())) {
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

// Tells the tiles what is seen; whether any of them is, or throws a shadow that is. A world without a camera is looked at
// in ways that are not known here: by scripts, by tests.
bool GrassField::look(const FieldView &p_view) {
	if (p_view.cameras.empty() && is_visible_in_tree()) {
		_tiles.see_all();
		return true;
	}
	std::vector<Frustum> frustums;
	for (const ViewCamera &camera : p_view.cameras) {
		frustums.push_back(camera.planes);
	}
	float margin = std::max(VIEW_MARGIN, p_view.shadow_margin);
	for (const Eigen::Vector3f &fall : p_view.falls) {
		margin = std::max(margin, fall.norm());
	}
	_tiles.see(frustums, margin);
	return _tiles.is_field_seen();
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
	view.lod.far = float(param(PARAM_LOD_FAR));
	view.lod.error = float(param(PARAM_LOD_ERROR));
	view.lod.pixels_min = float(param(PARAM_PIXELS_MIN));
	view.lod.shadow_coarseness = float(param(PARAM_SHADOW_COARSENESS));
	view.lod = view.lod.sanitised();
	if (get_cast_shadows_setting() != SHADOW_CASTING_SETTING_OFF) {
		view.shadow_distance = float(param(PARAM_SHADOW_DISTANCE));
		view.shadow_margin = float(param(PARAM_SHADOW_MARGIN));
		view.falls = find_falls(this, field, _standing.setup.blade_height() + ground_range(), param(PARAM_SHADOW_DISTANCE));
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

TileRange GrassField::all_tiles() const {
	return { 0, _standing.setup.grid.get_tiles_x(), 0, _standing.setup.grid.get_tiles_z() };
}

TileParams GrassField::tile_params() const {
	TileParams params;
	params.pool_size = _standing.setup.pool_tiles;
	params.sleep_mode = grass::SleepMode(_sleep_mode);
	params.sleep_delay = param(PARAM_SLEEP_DELAY);
	params.sleep_energy = calm_energy();
	params.still_delay = calm_time();
	params.settle_time = param(PARAM_SETTLE_TIME);
	params.reach = _standing.bounds ? _standing.bounds->get_reach() : 0.0;
	params.low = _standing.bounds ? _standing.bounds->get_low() : 0.0;
	params.height = _standing.bounds ? _standing.bounds->get_height() : 0.0;
	params.segment = _standing.setup.patch ? double(_standing.setup.blade_length()) / GRASS_SEGMENTS : 0.0;
	params.is_mapped = _standing.blades.is_told();
	params.seed = _standing.setup.seed;
	return params;
}

} // namespace grass
