// SPDX-License-Identifier: MIT
// The node's life cycle and its frames; its ticks are in grass_field_tick.cpp.
#include "nodes/grass_field.h"

#include "core/base/cpu_clock.h"
#include "core/solver/hang.h"
#include "draw/quit.h"
#include "draw/shared_shader.h"
#include "field/field_view.h"
#include "field/sun_map.h"
#include "shared/convert.h"
#include "shared/scene_watch.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/window.hpp>
#include <godot_cpp/classes/world3d.hpp>
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
		case NOTIFICATION_RESET_PHYSICS_INTERPOLATION:
			_moved_in = UINT64_MAX; // it was moved elsewhere: do not interpolate between the two places
			break;
		case NOTIFICATION_TRANSFORM_CHANGED:
			stir();
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

void GrassField::enter() {
	if (FieldMonitors::get_fields().empty()) {
		hold_shader_jobs(); // the first frame with a field may need shaders in new variants
	}
	watch_for_quit(get_tree()->get_root());
	FieldMonitors::add(this);
	SceneWatch::get_singleton()->start(this);
	FieldTurns::start(this);
	stir();
	_world = get_world_3d()->get_instance_id();
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
	FieldTurns::remove(*this);
	if (FieldMonitors::get_fields().empty()) {
		forget_shader_jobs();
	}
	RenderingServer::get_singleton()->disconnect("frame_pre_draw", callable_mp(this, &GrassField::_before_draw));
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

// Where frames are drawn, every one may need another wind.
bool GrassField::needs_frame() const {
	static const bool are_drawn = draws_frames();
	return are_drawn || !_frame_rests || _life.is_waiting() || _properties.is_other_quality() || _filler.may_fill();
}

void GrassField::frame(double p_delta) {
	_visited_frames++;
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
	_frame_rests = _life.rests() && _terrain.get_path().is_empty();
}

// Runs when the camera has its pose of this frame, which is not earlier. Also runs in a paused tree, unlike frame().
void GrassField::_before_draw() {
	last_drawn_frame = Engine::get_singleton()->get_process_frames();
	if (!advance() || !_standing.stands()) {
		return;
	}
	CpuClock clock;
	update_map();
	const Transform3D place = drawn_transform();
	const FieldView view = is_visible_in_tree() ? find_view(this, place, _properties, _standing.get_field()) : FieldView();
	if (!view.cameras.empty()) {
		_standing.show_sun_map(find_sun_map(this));
		if (is_compatibility()) {
			_standing.show_light(_other_light.find(this));
		}
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
