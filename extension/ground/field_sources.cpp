// SPDX-License-Identifier: MIT
#include "ground/field_sources.h"

#include "field/work_limits.h"
#include "ground/bare_answer.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/core/object.hpp>

using namespace godot;

namespace grass {

FieldFiller::Place FieldSources::place() const {
	return { _host.field_transform(), MapRegion::of_grid(_properties.grid()),
		Eigen::Vector2d(_properties.noise_origin.x, _properties.noise_origin.y) };
}

void FieldSources::set_terrain(const NodePath &p_path) {
	_host.stir();
	if (_terrain.get_path() == p_path) {
		_terrain.look_soon();
		return;
	}
	_terrain.set_path(p_path);
	_filler.set_terrain(nullptr);
	_host.show_warnings();
}

void FieldSources::terrain_changed(const AABB &p_area) {
	ERR_FAIL_COND_MSG(!p_area.is_finite(), _host.message("terrain_changed() needs a finite area, or an empty one for everything."));
	_terrain.area_changed(p_area);
}

bool FieldSources::update_terrain() {
	if (!_terrain.look(_host.field_transform(), MapRegion::of_grid(_properties.grid()), _handlers)) {
		return false;
	}
	_filler.set_terrain(_terrain.get_ids());
	if (_host.node().is_inside_tree() && _terrain.can_read()) {
		if (_properties.map.is_null()) {
			_host.make_map();
		}
		const double ledge_slope = _properties.param(PARAM_LEDGE_SLOPE);
		if (!_terrain.read(_properties.map, ledge_slope, [this](const MapRegion &p_region) { _filler.touch_textures(p_region); })) {
			return false;
		}
	}
	_settings.show_terrain_colors(_terrain.get_colors());
	if (_terrain.has_new_warning()) {
		_host.report_warnings();
	}
	return true;
}

void FieldSources::set_fill_rule(const Ref<GrassFillRule> &p_rule, const Callable &p_changed) {
	if (_filler.get_rule() != p_rule && _filler.set_rule(p_rule, p_changed, _properties.map)) {
		rule_changed();
		_host.node().notify_property_list_changed();
	}
}

void FieldSources::rule_changed() {
	_filler.rule_changed();
	_host.show_warnings();
}

void FieldSources::set_fill_live(bool p_live) {
	if (_filler.is_live() != p_live) {
		_filler.set_live(p_live, _properties.map);
		_host.show_warnings();
		_host.node().notify_property_list_changed();
	}
}

bool FieldSources::start_fill() {
	if (_filler.is_set() || !_host.node().is_inside_tree() || !_filler.is_needed(place())) {
		return true;
	}
	if (_properties.map.is_null()) {
		_host.make_map();
	}
	return _filler.start(_properties.map, place(), !_standing.stands() && !_properties.is_streamed);
}

bool FieldSources::update_fill(bool &r_has_finished) {
	if (!start_fill() || (_filler.is_set() && _host.node().is_inside_tree() && !_filler.update(_properties.map, place()))) {
		return false;
	}
	r_has_finished = _filler.is_set() && _filler.take_finished();
	return true;
}

double FieldSources::fill(const Ref<GrassFillRule> &p_rule) {
	ERR_FAIL_COND_V_MSG(p_rule.is_null(), 0.0, _host.message("fill() needs a GrassFillRule."));
	const double area = double(_properties.size.x) * double(_properties.size.y);
	ERR_FAIL_COND_V_MSG(area > double(AREA_MAX), 0.0,
			_host.message(vformat("fill() would fill %.0f square metres at once, and fills %d at most (AREA_MAX). Set the rule as "
								  "`fill_rule`, which fills some of it in each frame.",
					area, AREA_MAX)));
	return fill_whole(p_rule);
}

double FieldSources::fill_whole(const Ref<GrassFillRule> &p_rule) {
	if (_host.need_map("fill") == nullptr) {
		return 0.0;
	}
	if (_filler.has_live_rule()) {
		WARN_PRINT(_host.message("fill() was called while `fill_rule` is live: that rule will overwrite the result at its next change. "
								 "Turn `fill_live` off."));
	}
	return _filler.fill(_properties.map, p_rule, place());
}

Dictionary FieldSources::explain(const Vector3 &p_global, const Camera3D *p_camera, Node3D *p_other) {
	ERR_FAIL_COND_V_MSG(
			!_host.node().is_inside_tree(), Dictionary(), _host.message("add the node to the scene tree before asking for its grass."));
	const uint64_t given = p_camera != nullptr ? p_camera->get_instance_id() : 0,
				   other = p_other != nullptr ? p_other->get_instance_id() : 0;
	if (!_host.stand() || !_host.node().is_inside_tree() || !_filler.read_meshes(place()) || !_host.node().is_inside_tree()) {
		return Dictionary(); // a script may have freed any of them
	}
	const Camera3D *camera =
			given != 0 ? Object::cast_to<Camera3D>(ObjectDB::get_instance(given)) : _host.node().get_viewport()->get_camera_3d();
	return to_dictionary(explain_place(_host.node(), _standing, _filler, _properties, place(), p_global, camera,
			Object::cast_to<Node3D>(ObjectDB::get_instance(other))));
}

void FieldSources::forget_map() {
	_filler.forget_map();
	_terrain.read_all(_properties.is_streamed);
	_is_map_bare = is_map_bare();
}

void FieldSources::map_changed(const TypedArray<Vector2i> &p_chunks) {
	_filler.touch(_properties.map, p_chunks);
	watch_bare_map();
}

bool FieldSources::is_map_bare() const {
	const Ref<GrassMap> &map = _properties.map;
	return map.is_valid() && map->is_readable() && !_filler.has_live_rule() && map->get_base_density() == 0.0 &&
			!map->get_map().uses(MAP_DENSITY);
}

// Notifies the editor when the map becomes bare or stops being bare: it reads a node's warnings only then, and redraws the whole scene
// tree.
void FieldSources::watch_bare_map() {
	if (_is_map_bare != is_map_bare()) {
		_is_map_bare = !_is_map_bare;
		_host.show_warnings();
	}
}

bool FieldSources::hides(std::string_view p_property) const {
	const bool has_rule = _filler.get_rule().is_valid();
	return (p_property == "fill_now" && (_filler.is_live() || !has_rule)) || (p_property == "fill_live" && _filler.is_live() && !has_rule);
}

void FieldSources::warn_of_map(PackedStringArray &r_warnings) const {
	if (is_map_bare() && Engine::get_singleton()->is_editor_hint()) { // a game may begin with bare ground
		r_warnings.push_back("`map` has no paint and a `base_density` of 0, so no grass grows. Paint with the brush, or set the map's "
							 "`base_density` to 1.");
	}
}

void FieldSources::warn(PackedStringArray &r_warnings) const {
	_filler.warn(_properties.map, _terrain.is_found(), r_warnings);
	_terrain.warn(r_warnings);
}

void FieldSources::add_to(FieldStatistics &r_statistics) const {
	_filler.add_to(r_statistics);
	_terrain.add_to(r_statistics);
}

} // namespace grass
