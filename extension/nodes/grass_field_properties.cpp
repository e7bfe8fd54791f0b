// SPDX-License-Identifier: MIT
// GrassField's properties: each setter clamps its value, warns if it had to, and passes it on.
#include "nodes/grass_field.h"

#include "shared/inherited_properties.h"
#include "shared/main_thread.h"
#include "shared/params.h"
#include "shared/script_call.h"

#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <algorithm>
#include <iterator>
#include <string_view>

using namespace godot;

namespace grass {

void GrassField::set_size(const Vector2 &p_size) {
	GRASS_MAIN_THREAD_ONLY();
	const Vector2 size(real_t(checked(FIELD_SIZE, p_size.x, label())), real_t(checked(FIELD_SIZE, p_size.y, label())));
	if (_properties.is_streamed && size != _properties.size) { // files and neighbours depend on it
		warn("`size` of a plot's field follows `plot_size` of its GrassWorld, and stays. Change it there.");
		return;
	}
	if (replace(_properties.size, size)) {
		request_rebuild();
	}
}

void GrassField::set_seed(int64_t p_seed) {
	GRASS_MAIN_THREAD_ONLY();
	if (replace(_properties.seed, checked_int("seed", p_seed, 0, UINT32_MAX, label()))) {
		request_rebuild();
	}
}

void GrassField::set_simulated(bool p_simulated) {
	GRASS_MAIN_THREAD_ONLY();
	if (replace(_properties.simulated, p_simulated)) {
		request_rebuild(); // awake tiles return to rest
		emit_leaving();
	}
}

void GrassField::set_backend(BackendMode p_mode) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_INDEX_MSG(int64_t(p_mode), 2, message("`backend` must be BACKEND_AUTO or BACKEND_CPU."));
	if (get_backend() != p_mode) {
		_properties.is_on_cpu = p_mode == BACKEND_CPU;
		_standing.drop_backend();
		request_rebuild();
	}
}

void GrassField::set_method(SolverMethod p_method) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_INDEX_MSG(int64_t(p_method), 2, message("`method` must be METHOD_DIRECT or METHOD_PBD."));
	if (replace(_properties.method, Method(p_method))) {
		request_rebuild();
	}
}

void GrassField::set_simulation_detail(SimulationDetail p_detail) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_INDEX_MSG(int64_t(p_detail), 2, message("`simulation_detail` must be SIMULATION_SEEN or SIMULATION_WHOLE."));
	if (replace(_properties.simulation_detail, grass::SimulationDetail(p_detail))) {
		_standing.update_params();
		update_configuration_warnings();
	}
}

void GrassField::set_sleep_mode(SleepMode p_mode) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_INDEX_MSG(int64_t(p_mode), 2, message("`sleep_mode` must be SLEEP_TIMER or SLEEP_ENERGY."));
	if (replace(_properties.sleep_mode, grass::SleepMode(p_mode))) {
		_standing.update_params();
	}
}

void GrassField::set_pool_tiles(int64_t p_tiles) {
	GRASS_MAIN_THREAD_ONLY();
	if (!replace(_properties.pool_tiles, checked_int("pool_tiles", p_tiles, 0, TileParams::MAX_POOL_SIZE, label()))) {
		return;
	}
	if (_life.is_waiting()) {
		request_rebuild();
	} else {
		_standing.fit_pool();
		report_warnings();
	}
}

void GrassField::fit_pool(int64_t p_tiles) {
	if (replace(_properties.pool_tiles, p_tiles)) {
		_standing.fit_pool();
	}
}

void GrassField::set_collision_mask(int64_t p_mask) {
	GRASS_MAIN_THREAD_ONLY();
	if (!replace(_properties.collision_mask, int64_t(uint32_t(p_mask)))) {
		return;
	}
	_bodies.get_tracker().set_mask(uint32_t(_properties.collision_mask));
	update_configuration_warnings();
}

void GrassField::set_ground_mask(int64_t p_mask) {
	GRASS_MAIN_THREAD_ONLY();
	if (replace(_properties.ground_mask, int64_t(uint32_t(p_mask)))) {
		update_configuration_warnings();
	}
}

void GrassField::set_ground_group(const StringName &p_group) {
	GRASS_MAIN_THREAD_ONLY();
	(void)replace(_properties.ground_group, p_group); // read when ground is
}

void GrassField::set_debug_view(DebugView p_view) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_INDEX_MSG(int64_t(p_view), GRASS_DEBUG_SIMULATED + 1, message("`debug_view` must be one of the constants DEBUG_VIEW_*."));
	if (replace(_properties.debug_view, p_view)) {
		_standing.set_uniform("debug_view", int64_t(p_view));
	}
}

void GrassField::set_measure_time(bool p_measure) {
	GRASS_MAIN_THREAD_ONLY();
	if (replace(_properties.measure_time, p_measure)) {
		_standing.update_measuring();
	}
}

void GrassField::set_param(int64_t p_param, double p_value) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_INDEX(p_param, int(FIELD_PARAMS.size()));
	const FieldParam &info = FIELD_PARAMS[size_t(p_param)];
	if (!replace(_properties.params[size_t(p_param)], checked(info.tunable, p_value, label()))) {
		return;
	}
	stir();
	if (info.id == PARAM_GROUND_LOW || info.id == PARAM_GROUND_HIGH) {
		update_configuration_warnings();
	}
	switch (info.effect) {
		case Effect::REBUILD:
			request_rebuild();
			break;
		case Effect::STEP:
			_standing.update_params();
			update_configuration_warnings();
			break;
		case Effect::TINT:
			if (_life.is_waiting()) {
				request_rebuild();
			} else {
				_standing.update_tint();
			}
			break;
		case Effect::UNIFORM:
			_standing.set_uniform(info.tunable.name, _properties.scaled(info.id));
			break;
		case Effect::WIND:
			_standing.update_wind();
			break;
		case Effect::VIEW:
			_standing.request_draw();
			break;
	}
}

double GrassField::get_param(int64_t p_param) const {
	ERR_FAIL_INDEX_V(p_param, int(FIELD_PARAMS.size()), 0.0);
	return _properties.params[size_t(p_param)];
}

Variant GrassField::_get_param(int64_t p_param) const {
	ERR_FAIL_INDEX_V(p_param, int(FIELD_PARAMS.size()), 0.0);
	return property_value(FIELD_PARAMS[size_t(p_param)].tunable, _properties.params[size_t(p_param)]);
}

void GrassField::set_soil_texture(int64_t p_index, const Ref<Texture2D> &p_texture) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_INDEX(p_index, int(SOIL_TEXTURES.size()));
	if (replace(_properties.soil_textures[size_t(p_index)], p_texture)) {
		FieldUniforms::set_soil(_properties, _standing.setter());
	}
}

Ref<Texture2D> GrassField::get_soil_texture(int64_t p_index) const {
	ERR_FAIL_INDEX_V(p_index, int(SOIL_TEXTURES.size()), Ref<Texture2D>());
	return value_of(_properties.soil_textures[size_t(p_index)]);
}

void GrassField::set_color(int64_t p_index, const Color &p_color) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_INDEX(p_index, int(FIELD_COLORS.size()));
	if (replace(_properties.colors[size_t(p_index)], p_color)) {
		_standing.set_uniform(FIELD_COLORS[size_t(p_index)].name, p_color);
	}
}

Color GrassField::get_color(int64_t p_index) const {
	ERR_FAIL_INDEX_V(p_index, int(FIELD_COLORS.size()), Color());
	return _properties.colors[size_t(p_index)];
}

namespace {

// Returns whether the property was a field's in 0.9.0 and now belongs to a species.
bool is_species_property(const StringName &p_name) {
	static const char *const names[] = { "patch", "natural_frequency", "damping_ratio", "root_stiffness", "bend_stiffness", "wear_recovery",
		"root_color", "tip_color", "dry_color", "dry" };
	return std::any_of(std::begin(names), std::end(names), [&](const char *p_known) { return p_name == StringName(p_known); });
}

} // namespace

// Keeps scenes and scripts of 0.9.0 working: a field without species gets one with the value. A field with species never used the value.
bool GrassField::_set(const StringName &p_name, const Variant &p_value) {
	const bool is_hooks = FieldHook::is_property(p_name);
	if (!is_hooks && !is_species_property(p_name)) {
		return false;
	}
	GRASS_MAIN_THREAD_ONLY_V(true);
	if (is_hooks) {
		_properties.hook.set_property(p_name, p_value);
		_properties.hook.hand_on(_standing.setter());
		return true;
	}
	if (_has_own_species || _properties.species.get().is_empty()) {
		_has_own_species = true;
		const Ref<GrassSpecies> first = _properties.species.make_first(callable_mp(this, &GrassField::_species_changed));
		if (outlives(*this, [&] { first.ptr()->set(p_name, p_value); }) && outlives(*this, [&] { _species_changed(); })) {
			notify_property_list_changed();
		}
	}
	return true;
}

bool GrassField::_get(const StringName &p_name, Variant &r_value) const {
	const bool is_species = is_species_property(p_name);
	if (!is_species && !FieldHook::is_property(p_name)) {
		return false;
	}
	GRASS_MAIN_THREAD_ONLY_V(false);
	r_value = is_species ? _properties.species.find_used().front()->get(p_name) : _properties.hook.get_property(p_name);
	return true;
}

void GrassField::_validate_property(PropertyInfo &p_property) const {
	const CharString utf8 = String(p_property.name).utf8();
	const std::string_view name = utf8.get_data();
	const bool has_no_rule = (name == "fill_now" && (_filler.is_live() || _filler.get_rule().is_null())) ||
			(name == "fill_live" && _filler.is_live() && _filler.get_rule().is_null());
	if (has_no_rule || has_no_effect(name)) {
		p_property.usage = p_property.usage & ~uint32_t(PROPERTY_USAGE_EDITOR);
	}
}

} // namespace grass
