// SPDX-License-Identifier: MIT
// The node's life in the tree, and what the engine calls; the rest is in grass_field_changes.cpp.
#include "nodes/grass_field.h"

#include "core/solver/hang.h"
#include "draw/quit.h"
#include "draw/shared_shader.h"
#include "field/field_device.h"
#include "nodes/field_api.h"
#include "nodes/field_monitors.h"
#include "nodes/field_turns.h"
#include "shared/convert.h"
#include "shared/inherited_properties.h"
#include "shared/scene_watch.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/window.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <string_view>

using namespace godot;

namespace grass {

GrassField::GrassField() {
	GrassPatch::prepare_default(); // starts early, before the node enters the tree
	set_notify_transform(true);
}

void GrassField::_bind_methods() {
	FieldApi::bind();
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
			_ticks.skip_between();
			break;
		case NOTIFICATION_TRANSFORM_CHANGED:
			stir();
			turn();
			update_configuration_warnings();
			break;
	}
}

// Turns the blades with the field. In the editor they follow gravity while somebody turns it. In a game they keep the shape that they were
// made with: a field that turns over would be made again every few degrees.
void GrassField::turn() {
	const bool is_edited = Engine::get_singleton()->is_editor_hint() && is_inside_tree();
	if (is_edited && find_pull(to_eigen(field_transform()).linear()) != _parts.properties.species.get_pull()) {
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
	RenderingServer::get_singleton()->connect("frame_pre_draw", callable_mp(this, &GrassField::_before_draw));
	listen();
	(void)_parts.properties.update_quality();
	begin_passes(_parts.properties);
	request_rebuild();
}

void GrassField::listen() {
	_ticks.enter({ callable_mp(this, &GrassField::_body_changed), callable_mp(this, &GrassField::_area_changed),
			callable_mp(this, &GrassField::_body_woke) });
	_parts.sources.set_handlers({ callable_mp(this, &GrassField::_terrain_edited), callable_mp(this, &GrassField::_terrain_replaced),
			callable_mp(this, &GrassField::_terrain_cells_changed), callable_mp(this, &GrassField::_terrain_rectangle_changed) });
}

void GrassField::leave() {
	FieldMonitors::remove(this);
	FieldTurns::remove(*this);
	if (FieldMonitors::get_fields().empty()) {
		forget_shader_jobs();
	}
	RenderingServer::get_singleton()->disconnect("frame_pre_draw", callable_mp(this, &GrassField::_before_draw));
	_ticks.leave();
	_parts.sources.leave();
	_parts.life.leave();
	if (!_parts.plants.leave()) {
		return;
	}
	if (_parts.plants.is_waiting()) {
		callable_mp(this, &GrassField::_plants_left).call_deferred();
	}
	_ticks.emit_leaving();
}

Transform3D GrassField::field_transform() const {
	return without_scale(get_global_transform());
}

Transform3D GrassField::drawn_transform() {
	return without_scale(get_global_transform_interpolated());
}

void GrassField::stir() {
	_ticks.stir();
	_frames.stir();
}

void GrassField::request_rebuild() {
	stir();
	_parts.life.ask();
	update_gizmos();
	update_configuration_warnings();
}

// Reads what scripts provide. The ground beside the cameras is laid from the first frame on.
bool GrassField::read_scene() {
	const bool is_first = !_parts.standing.stands() && !_parts.properties.is_streamed;
	_parts.properties.species.set_pull(find_pull(to_eigen(field_transform()).linear()));
	return (!is_first || _parts.sources.update_terrain()) && _parts.sources.start_fill() && _parts.properties.species.read_plants(*this);
}

GrassMap *GrassField::need_map(const char *p_method) {
	ERR_FAIL_COND_V_MSG(!is_inside_tree(), nullptr, message(vformat("add the node to the scene tree before calling %s().", p_method)));
	if (_parts.properties.map.is_null()) {
		make_map();
	}
	return stand() ? _parts.properties.map.ptr() : nullptr;
}

void GrassField::_body_changed(int64_t p_status, const RID &p_body, int64_t p_instance_id, int64_t p_body_shape, int64_t p_area_shape) {
	(void)p_body_shape; // see BodyTracker::body_changed()
	(void)p_area_shape; // the area has one shape
	_ticks.body_changed(p_status, p_body, p_instance_id);
}

void GrassField::_area_changed(int64_t p_status, const RID &, int64_t p_instance_id, int64_t, int64_t) {
	_ticks.area_changed(p_status, p_instance_id);
}

void GrassField::_validate_property(PropertyInfo &p_property) const {
	const CharString utf8 = String(p_property.name).utf8();
	const std::string_view name = utf8.get_data();
	if (_parts.sources.hides(name) || has_no_effect(name)) {
		p_property.usage = p_property.usage & ~uint32_t(PROPERTY_USAGE_EDITOR);
	}
}

void GrassField::_get_property_list(List<PropertyInfo> *r_list) const {
	_parts.properties.hook.list(r_list);
}

} // namespace grass
