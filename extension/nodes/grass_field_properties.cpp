// SPDX-License-Identifier: MIT
// GrassField's properties: each setter clamps its value, warns if it had to, and passes it on.
#include "nodes/grass_field.h"

#include "shared/bind_property.h"
#include "shared/inherited_properties.h"
#include "shared/main_thread.h"
#include "shared/params.h"
#include "shared/property_value.h"
#include "shared/script_call.h"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <algorithm>
#include <iterator>
#include <string_view>

using namespace godot;

namespace grass {

void GrassField::set_size(const Vector2 &p_size) {
	GRASS_MAIN_THREAD_ONLY();
	const Vector2 size(real_t(checked(FIELD_SIZE, p_size.x, label())), real_t(checked(FIELD_SIZE, p_size.y, label())));
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
		request_rebuild(); // tiles that were awake go back to rest
		emit_leaving();
	}
}

void GrassField::set_backend(BackendMode p_mode) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_INDEX_MSG(int64_t(p_mode), 2, message("`backend` is BACKEND_AUTO or BACKEND_CPU."));
	if (get_backend() != p_mode) {
		_properties.is_on_cpu = p_mode == BACKEND_CPU;
		_standing.drop_backend();
		request_rebuild();
	}
}

void GrassField::set_method(SolverMethod p_method) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_INDEX_MSG(int64_t(p_method), 2, message("`method` is METHOD_DIRECT or METHOD_PBD."));
	if (replace(_properties.method, Method(p_method))) {
		request_rebuild();
	}
}

void GrassField::set_sleep_mode(SleepMode p_mode) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_INDEX_MSG(int64_t(p_mode), 2, message("`sleep_mode` is SLEEP_TIMER or SLEEP_ENERGY."));
	if (replace(_properties.sleep_mode, grass::SleepMode(p_mode))) {
		_standing.update_params();
	}
}

void GrassField::set_pool_tiles(int64_t p_tiles) {
	GRASS_MAIN_THREAD_ONLY();
	if (replace(_properties.pool_tiles, checked_int("pool_tiles", p_tiles, 0, TileParams::MAX_POOL_SIZE, label()))) {
		request_rebuild();
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

void GrassField::set_debug_view(DebugView p_view) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_INDEX_MSG(int64_t(p_view), GRASS_DEBUG_COST + 1, message("`debug_view` is one of the constants DEBUG_VIEW_*."));
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
	switch (info.effect) {
		case Effect::REBUILD:
			request_rebuild();
			break;
		case Effect::STEP:
			_standing.update_params();
			break;
		case Effect::UNIFORM:
			_standing.set_uniform(info.tunable.name, _properties.params[size_t(p_param)]);
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

// What was a field's in 0.9.0 and is a species' since.
bool is_species_property(const StringName &p_name) {
	static const char *const names[] = { "patch", "natural_frequency", "damping_ratio", "root_stiffness", "bend_stiffness", "wear_recovery",
		"root_color", "tip_color", "dry_color", "dry" };
	return std::any_of(std::begin(names), std::end(names), [&](const char *p_known) { return p_name == StringName(p_known); });
}

} // namespace

// Scenes and scripts of 0.9.0 go on: a field without species gets one that has the value. One that has species did not read it.
bool GrassField::_set(const StringName &p_name, const Variant &p_value) {
	Variant now;
	const bool is_hooks = _properties.hook.get_property(p_name, now);
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
	if (!is_species) {
		return _properties.hook.get_property(p_name, r_value);
	}
	r_value = _properties.species.find_used().front()->get(p_name);
	return true;
}

void GrassField::_validate_property(PropertyInfo &p_property) const {
	const CharString utf8 = String(p_property.name).utf8();
	const std::string_view name = utf8.get_data();
	const bool has_no_rule = (name == "fill_now" && (_filler.is_live() || _filler.get_rule().is_null())) ||
			(name == "fill_live" && _filler.get_rule().is_null());
	if (has_no_rule || has_no_effect(name)) {
		p_property.usage = p_property.usage & ~uint32_t(PROPERTY_USAGE_EDITOR);
	}
}

namespace {

void add_numbers(std::string_view p_group) {
	for (const FieldParam &param : FIELD_PARAMS) {
		if (param.group == p_group) {
			ClassDB::add_property("GrassField", property_of(param.tunable), "_set_param", "_get_param", param.id);
		}
	}
}

} // namespace

void GrassField::_bind_methods() {
	ClassDB::bind_method(D_METHOD("_set_param", "param", "value"), &GrassField::set_param);
	ClassDB::bind_method(D_METHOD("_get_param", "param"), &GrassField::_get_param);
	ClassDB::bind_method(D_METHOD("_set_color", "index", "color"), &GrassField::set_color);
	ClassDB::bind_method(D_METHOD("_get_color", "index"), &GrassField::get_color);

	ADD_GROUP("Field", "");
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::VECTOR2, "size", PROPERTY_HINT_NONE, "suffix:m"), set_size, get_size);
	add_numbers("Field");
	GRASS_BIND_PROPERTY(GrassField,
			PropertyInfo(Variant::ARRAY, "species", PROPERTY_HINT_TYPE_STRING,
					vformat("%d/%d:GrassSpecies", Variant::OBJECT, PROPERTY_HINT_RESOURCE_TYPE)),
			set_species, get_species);
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::INT, "seed", PROPERTY_HINT_RANGE, range_hint(0, UINT32_MAX)), set_seed, get_seed);
	ADD_GROUP("Map", "");
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::OBJECT, "map", PROPERTY_HINT_RESOURCE_TYPE, "GrassMap"), set_map, get_map);
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::OBJECT, "fill_rule", PROPERTY_HINT_RESOURCE_TYPE, "GrassFillRule"), set_fill_rule,
			get_fill_rule);
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::BOOL, "fill_live"), set_fill_live, is_fill_live);
	ClassDB::bind_method(D_METHOD("_get_fill_button"), &GrassField::get_fill_button);
	ADD_PROPERTY(PropertyInfo(Variant::CALLABLE, "fill_now", PROPERTY_HINT_TOOL_BUTTON, "Fill Now,Bucket", PROPERTY_USAGE_EDITOR), "",
			"_get_fill_button");
	add_numbers("Map");
	GRASS_BIND_PROPERTY(
			GrassField, PropertyInfo(Variant::NODE_PATH, "terrain", PROPERTY_HINT_NODE_PATH_VALID_TYPES, "Node"), set_terrain, get_terrain);
	ADD_GROUP("Clumps", "");
	add_numbers("Clumps");
	ADD_GROUP("Simulation", "");
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::BOOL, "simulated"), set_simulated, is_simulated);
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::INT, "collision_mask", PROPERTY_HINT_LAYERS_3D_PHYSICS), set_collision_mask,
			get_collision_mask);
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::INT, "method", PROPERTY_HINT_ENUM, "Direct,PBD"), set_method, get_method);
	GRASS_BIND_PROPERTY(
			GrassField, PropertyInfo(Variant::INT, "sleep_mode", PROPERTY_HINT_ENUM, "Timer,Energy"), set_sleep_mode, get_sleep_mode);
	add_numbers("Simulation");
	GRASS_BIND_PROPERTY(GrassField,
			PropertyInfo(Variant::INT, "pool_tiles", PROPERTY_HINT_RANGE, range_hint(0, TileParams::MAX_POOL_SIZE, "tiles")),
			set_pool_tiles, get_pool_tiles);
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::INT, "backend", PROPERTY_HINT_ENUM, "Auto,CPU"), set_backend, get_backend);
	ADD_GROUP("Wind", "");
	add_numbers("Wind");
	ADD_GROUP("Look", "");
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::BOOL, "ground"), set_ground, has_ground);
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::OBJECT, "terrain_texture", PROPERTY_HINT_RESOURCE_TYPE, "Texture2D"),
			set_terrain_texture, get_terrain_texture);
	for (size_t i = 0; i < FIELD_COLORS.size(); i++) {
		ClassDB::add_property("GrassField", PropertyInfo(Variant::COLOR, FIELD_COLORS[i].name, PROPERTY_HINT_COLOR_NO_ALPHA), "_set_color",
				"_get_color", int(i));
	}
	add_numbers("Look");
	ADD_GROUP("Surface", "");
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::OBJECT, "surface_hook", PROPERTY_HINT_RESOURCE_TYPE, "ShaderInclude"),
			set_surface_hook, get_surface_hook);
	add_numbers("Surface");
	ADD_GROUP("Level of Detail", "");
	add_numbers("Level of Detail");
	ADD_GROUP("Debug", "");
	GRASS_BIND_PROPERTY(GrassField,
			PropertyInfo(Variant::INT, "debug_view", PROPERTY_HINT_ENUM, "Off,Awake Tiles,Level of Detail,Density,Cost"), set_debug_view,
			get_debug_view);
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::BOOL, "measure_time"), set_measure_time, is_measuring_time);

	ClassDB::bind_method(D_METHOD("get_blade_count"), &GrassField::get_blade_count);
	ClassDB::bind_method(D_METHOD("get_tiles"), &GrassField::get_tiles);
	ClassDB::bind_method(D_METHOD("get_tile_size"), &GrassField::get_tile_size);
	ClassDB::bind_method(D_METHOD("get_tile_at", "global_position"), &GrassField::get_tile_at);
	ClassDB::bind_method(D_METHOD("get_tile_center", "tile"), &GrassField::get_tile_center);
	ClassDB::bind_method(D_METHOD("is_tile_awake", "tile"), &GrassField::is_tile_awake);
	ClassDB::bind_method(D_METHOD("get_awake_tile_count"), &GrassField::get_awake_tile_count);
	ClassDB::bind_method(D_METHOD("get_knots", "tile", "blade"), &GrassField::get_knots);
	ClassDB::bind_method(D_METHOD("get_tile_knots", "tile"), &GrassField::get_tile_knots);
	ClassDB::bind_method(D_METHOD("get_blade_knots", "blades"), &GrassField::get_blade_knots);
	ClassDB::bind_method(D_METHOD("wait_for_knots", "blades"), &GrassField::wait_for_knots);
	ClassDB::bind_method(D_METHOD("get_tile_blades", "tile"), &GrassField::get_tile_blades);
	ClassDB::bind_method(D_METHOD("find_blades", "global_position", "radius"), &GrassField::find_blades);
	ClassDB::bind_method(D_METHOD("get_blade_species", "tile", "blade"), &GrassField::get_blade_species);
	ClassDB::bind_method(D_METHOD("get_body_count"), &GrassField::get_body_count);
	ClassDB::bind_method(D_METHOD("get_memory_usage"), &GrassField::get_memory_usage);
	ClassDB::bind_method(D_METHOD("get_statistics"), &GrassField::get_statistics);
	ClassDB::bind_method(D_METHOD("get_counters"), &GrassField::get_counters);
	ClassDB::bind_static_method("GrassField", D_METHOD("get_version"), &GrassField::get_version);

	ClassDB::bind_method(D_METHOD("is_grass_at", "global_position"), &GrassField::is_grass_at);
	ClassDB::bind_method(D_METHOD("density_at", "global_position"), &GrassField::density_at);
	ClassDB::bind_method(D_METHOD("height_at", "global_position"), &GrassField::height_at);
	ClassDB::bind_method(D_METHOD("bend_at", "global_position"), &GrassField::bend_at);
	ClassDB::bind_method(D_METHOD("explain", "global_position", "camera"), &GrassField::explain, DEFVAL(Variant()));
	ClassDB::bind_method(D_METHOD("cut", "shape", "transform"), &GrassField::cut);
	ClassDB::bind_method(
			D_METHOD("get_mown_share", "shape", "transform"), &GrassField::get_mown_share, DEFVAL(Ref<Shape3D>()), DEFVAL(Transform3D()));
	ClassDB::bind_method(D_METHOD("regrow", "height", "wear", "shape", "transform"), &GrassField::regrow, DEFVAL(0.0),
			DEFVAL(Ref<Shape3D>()), DEFVAL(Transform3D()));
	ClassDB::bind_method(D_METHOD("paint", "brush", "from", "to"), &GrassField::paint);
	ClassDB::bind_method(D_METHOD("trample", "global_position", "radius", "amount"), &GrassField::trample);
	ClassDB::bind_method(
			D_METHOD("bake_ground", "region", "mask"), &GrassField::bake_ground, DEFVAL(Rect2()), DEFVAL(GroundRays::ALL_LAYERS));
	ClassDB::bind_method(D_METHOD("bake_ground_from", "shape", "transform"), &GrassField::bake_ground_from);
	ClassDB::bind_method(D_METHOD("blast", "global_position", "speed", "radius", "duration"), &GrassField::blast,
			DEFVAL(FORCE_SPEED.initial), DEFVAL(FORCE_RADIUS.initial), DEFVAL(FORCE_DURATION.initial));
	ClassDB::bind_method(D_METHOD("push", "global_position", "velocity", "radius", "duration"), &GrassField::push,
			DEFVAL(FORCE_RADIUS.initial), DEFVAL(FORCE_DURATION.initial));
	ClassDB::bind_method(D_METHOD("register_collider", "node", "shape"), &GrassField::register_collider);
	ClassDB::bind_method(D_METHOD("unregister_collider", "node"), &GrassField::unregister_collider);
	ClassDB::bind_method(D_METHOD("terrain_changed", "area"), &GrassField::terrain_changed, DEFVAL(AABB()));
	ClassDB::bind_method(D_METHOD("fill", "rule"), &GrassField::fill);
	ClassDB::bind_method(D_METHOD("set_hook_parameter", "name", "value"), &GrassField::set_hook_parameter);
	ClassDB::bind_method(D_METHOD("get_hook_parameter", "name"), &GrassField::get_hook_parameter);
	ADD_SIGNAL(MethodInfo("fill_finished"));
	ADD_SIGNAL(MethodInfo("body_entered_grass", PropertyInfo(Variant::OBJECT, "body", PROPERTY_HINT_RESOURCE_TYPE, "Node3D")));
	ADD_SIGNAL(MethodInfo("body_exited_grass", PropertyInfo(Variant::OBJECT, "body", PROPERTY_HINT_RESOURCE_TYPE, "Node3D")));

	BIND_ENUM_CONSTANT(BACKEND_AUTO);
	BIND_ENUM_CONSTANT(BACKEND_CPU);
	BIND_ENUM_CONSTANT(METHOD_DIRECT);
	BIND_ENUM_CONSTANT(METHOD_PBD);
	BIND_ENUM_CONSTANT(SLEEP_TIMER);
	BIND_ENUM_CONSTANT(SLEEP_ENERGY);
	BIND_ENUM_CONSTANT(DEBUG_VIEW_OFF);
	BIND_ENUM_CONSTANT(DEBUG_VIEW_AWAKE_TILES);
	BIND_ENUM_CONSTANT(DEBUG_VIEW_LOD);
	BIND_ENUM_CONSTANT(DEBUG_VIEW_DENSITY);
	BIND_ENUM_CONSTANT(DEBUG_VIEW_COST);
	BIND_ENUM_CONSTANT(REASON_NONE);
	BIND_ENUM_CONSTANT(REASON_NOT_MADE);
	BIND_ENUM_CONSTANT(REASON_HIDDEN);
	BIND_ENUM_CONSTANT(REASON_OUTSIDE);
	BIND_ENUM_CONSTANT(REASON_LAYERS);
	BIND_ENUM_CONSTANT(REASON_TOO_FAR);
	BIND_ENUM_CONSTANT(REASON_NO_ROOM);
	BIND_ENUM_CONSTANT(REASON_MAP);
	BIND_ENUM_CONSTANT(REASON_PAINTED);
	BIND_ENUM_CONSTANT(REASON_FILL_DENSITY);
	BIND_ENUM_CONSTANT(REASON_FILL_MASK);
	BIND_ENUM_CONSTANT(REASON_FILL_MESH);
	BIND_ENUM_CONSTANT(REASON_FILL_SLOPE);
	BIND_ENUM_CONSTANT(REASON_FILL_HEIGHT);
	BIND_ENUM_CONSTANT(REASON_FILL_NOISE);
	BIND_ENUM_CONSTANT(REASON_FILL_NODE);
	BIND_ENUM_CONSTANT(REASON_WORN);
	BIND_ENUM_CONSTANT(REASON_SHORT);
	BIND_ENUM_CONSTANT(REASON_CUT);
	BIND_ENUM_CONSTANT(REASON_HOLE);
	BIND_ENUM_CONSTANT(REASON_FILL_TEXTURE);
	BIND_ENUM_CONSTANT(REASON_LEDGE);
}

} // namespace grass
