// SPDX-License-Identifier: MIT
#include "field/field_settings.h"

#include "shared/params.h"

using namespace godot;

namespace grass {

void FieldSettings::set_size(const Vector2 &p_size) {
	const Vector2 size(real_t(checked(FIELD_SIZE, p_size.x, _host.label())), real_t(checked(FIELD_SIZE, p_size.y, _host.label())));
	if (_properties.is_streamed && size != _properties.size) { // files and neighbours depend on it
		_host.warn("`size` of a plot's field follows `plot_size` of its GrassWorld, and stays. Change it there.");
		return;
	}
	if (replace(_properties.size, size)) {
		_host.request_rebuild();
	}
}

void FieldSettings::set_seed(int64_t p_seed) {
	if (replace(_properties.seed, checked_int("seed", p_seed, 0, UINT32_MAX, _host.label()))) {
		_host.request_rebuild();
	}
}

void FieldSettings::set_backend(FieldEnums::BackendMode p_mode) {
	ERR_FAIL_INDEX_MSG(int64_t(p_mode), 2, _host.message("`backend` must be BACKEND_AUTO or BACKEND_CPU."));
	if (get_backend() != p_mode) {
		_properties.is_on_cpu = p_mode == FieldEnums::BACKEND_CPU;
		_standing.drop_backend();
		_host.request_rebuild();
	}
}

void FieldSettings::set_method(FieldEnums::SolverMethod p_method) {
	ERR_FAIL_INDEX_MSG(int64_t(p_method), 2, _host.message("`method` must be METHOD_DIRECT or METHOD_PBD."));
	if (replace(_properties.method, Method(p_method))) {
		_host.request_rebuild();
	}
}

void FieldSettings::set_simulation_detail(FieldEnums::SimulationDetail p_detail) {
	ERR_FAIL_INDEX_MSG(int64_t(p_detail), 2, _host.message("`simulation_detail` must be SIMULATION_SEEN or SIMULATION_WHOLE."));
	if (replace(_properties.simulation_detail, grass::SimulationDetail(p_detail))) {
		_standing.update_params();
		_host.show_warnings();
	}
}

void FieldSettings::set_sleep_mode(FieldEnums::SleepMode p_mode) {
	ERR_FAIL_INDEX_MSG(int64_t(p_mode), 2, _host.message("`sleep_mode` must be SLEEP_TIMER or SLEEP_ENERGY."));
	if (replace(_properties.sleep_mode, grass::SleepMode(p_mode))) {
		_standing.update_params();
	}
}

void FieldSettings::set_pool_tiles(int64_t p_tiles) {
	if (!replace(_properties.pool_tiles, checked_int("pool_tiles", p_tiles, 0, TileParams::MAX_POOL_SIZE, _host.label()))) {
		return;
	}
	if (_life.is_waiting()) {
		_host.request_rebuild();
	} else {
		_standing.fit_pool();
		_host.report_warnings();
	}
}

void FieldSettings::fit_pool(int64_t p_tiles) {
	if (replace(_properties.pool_tiles, p_tiles)) {
		_standing.fit_pool();
	}
}

void FieldSettings::set_collision_mask(int64_t p_mask) {
	if (!replace(_properties.collision_mask, int64_t(uint32_t(p_mask)))) {
		return;
	}
	_tracker.set_mask(uint32_t(_properties.collision_mask));
	_host.show_warnings();
}

void FieldSettings::set_ground_mask(int64_t p_mask) {
	if (replace(_properties.ground_mask, int64_t(uint32_t(p_mask)))) {
		_host.show_warnings();
	}
}

void FieldSettings::set_ground_group(const StringName &p_group) {
	(void)replace(_properties.ground_group, p_group); // read when ground is
}

void FieldSettings::set_debug_view(FieldEnums::DebugView p_view) {
	ERR_FAIL_INDEX_MSG(
			int64_t(p_view), GRASS_DEBUG_SIMULATED + 1, _host.message("`debug_view` must be one of the constants DEBUG_VIEW_*."));
	if (replace(_properties.debug_view, p_view)) {
		_standing.get_picture().set_uniform("debug_view", int64_t(p_view));
	}
}

void FieldSettings::set_measure_time(bool p_measure) {
	if (replace(_properties.measure_time, p_measure)) {
		_standing.update_measuring();
	}
}

void FieldSettings::set_param(int64_t p_param, double p_value) {
	ERR_FAIL_INDEX(p_param, int(FIELD_PARAMS.size()));
	const FieldParam &info = FIELD_PARAMS[size_t(p_param)];
	if (!replace(_properties.params[size_t(p_param)], checked(info.tunable, p_value, _host.label()))) {
		return;
	}
	_host.stir();
	if (info.id == PARAM_GROUND_LOW || info.id == PARAM_GROUND_HIGH) {
		_host.show_warnings();
	}
	switch (info.effect) {
		case Effect::REBUILD:
			_host.request_rebuild();
			break;
		case Effect::STEP:
			_standing.update_params();
			_host.show_warnings();
			break;
		case Effect::TINT:
			if (_life.is_waiting()) {
				_host.request_rebuild();
			} else {
				_standing.update_tint();
			}
			break;
		case Effect::UNIFORM:
			_standing.get_picture().set_uniform(info.tunable.name, _properties.scaled(info.id));
			break;
		case Effect::WIND:
			_standing.get_picture().update_wind();
			break;
		case Effect::VIEW:
			_standing.get_picture().request_draw();
			break;
	}
}

double FieldSettings::get_param(int64_t p_param) const {
	ERR_FAIL_INDEX_V(p_param, int(FIELD_PARAMS.size()), 0.0);
	return _properties.params[size_t(p_param)];
}

Variant FieldSettings::get_param_value(int64_t p_param) const {
	ERR_FAIL_INDEX_V(p_param, int(FIELD_PARAMS.size()), 0.0);
	return property_value(FIELD_PARAMS[size_t(p_param)].tunable, _properties.params[size_t(p_param)]);
}

void FieldSettings::set_soil_texture(int64_t p_index, const Ref<Texture2D> &p_texture) {
	ERR_FAIL_INDEX(p_index, int(SOIL_TEXTURES.size()));
	if (replace(_properties.soil_textures[size_t(p_index)], p_texture)) {
		FieldUniforms::set_soil(_properties, _standing.get_picture().setter());
	}
}

Ref<Texture2D> FieldSettings::get_soil_texture(int64_t p_index) const {
	ERR_FAIL_INDEX_V(p_index, int(SOIL_TEXTURES.size()), Ref<Texture2D>());
	return value_of(_properties.soil_textures[size_t(p_index)]);
}

void FieldSettings::set_color(int64_t p_index, const Color &p_color) {
	ERR_FAIL_INDEX(p_index, int(FIELD_COLORS.size()));
	if (replace(_properties.colors[size_t(p_index)], p_color)) {
		_standing.get_picture().set_uniform(FIELD_COLORS[size_t(p_index)].name, p_color);
	}
}

Color FieldSettings::get_color(int64_t p_index) const {
	ERR_FAIL_INDEX_V(p_index, int(FIELD_COLORS.size()), Color());
	return _properties.colors[size_t(p_index)];
}

// Sets the texture. The shaders of a field without one have no code for it.
void FieldSettings::set_terrain_texture(const Ref<Texture2D> &p_texture) {
	show_terrain_texture(p_texture, _properties.terrain_colors);
}

void FieldSettings::show_terrain_colors(const Ref<Texture2D> &p_colors) {
	if (_properties.terrain_colors != p_colors) {
		show_terrain_texture(_properties.terrain_texture, p_colors);
	}
}

// Shows a texture of the terrain. The user's takes precedence over the terrain's own.
void FieldSettings::show_terrain_texture(const Ref<Texture2D> &p_texture, const Ref<Texture2D> &p_colors) {
	const Ref<Texture2D> before = _properties.find_terrain_texture();
	(void)replace(_properties.terrain_texture, p_texture);
	_properties.terrain_colors = p_colors;
	const Ref<Texture2D> now = _properties.find_terrain_texture();
	if (before.is_valid() != now.is_valid()) {
		_host.request_rebuild();
	} else if (before != now) {
		_standing.get_picture().set_uniform("terrain_texture", now);
	}
}

void FieldSettings::set_surface_hook(const Ref<ShaderInclude> &p_include, const Callable &p_changed) {
	if (get_surface_hook() != p_include) {
		_properties.hook.set_include(p_include, p_changed);
		compile_hook();
	}
}

void FieldSettings::compile_hook() {
	_host.stir();
	_properties.hook.compile();
	if (_host.node().is_inside_tree()) { // otherwise when the field is made
		_host.report_warnings();
	}
	_host.node().notify_property_list_changed();
}

String FieldSettings::no_uniform(const char *p_call, const StringName &p_name) const {
	const PackedStringArray uniforms = _properties.hook.get_uniforms();
	return _host.message(vformat("%s: there is no uniform `%s`. %s", p_call, p_name,
			uniforms.is_empty() ? String("Set a `surface_hook` that has it first.")
								: vformat("The uniforms of `surface_hook` are: %s.", String(", ").join(uniforms))));
}

void FieldSettings::set_hook_parameter(const StringName &p_name, const Variant &p_value) {
	ERR_FAIL_COND_MSG(!_properties.hook.has(p_name), no_uniform("set_hook_parameter()", p_name));
	_properties.hook.set_value(p_name, p_value);
	_standing.get_picture().set_uniform(p_name, p_value);
}

Variant FieldSettings::get_hook_parameter(const StringName &p_name) const {
	ERR_FAIL_COND_V_MSG(!_properties.hook.has(p_name), Variant(), no_uniform("get_hook_parameter()", p_name));
	return _properties.hook.get_value(p_name);
}

} // namespace grass
