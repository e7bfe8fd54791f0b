// SPDX-License-Identifier: MIT
// GrassField's properties: each setter brings its value within limits, says so if it had to, and passes it on.
#include "nodes/grass_field.h"

#include "draw/patch_texture.h"
#include "nodes/build_info.h"
#include "nodes/inherited_properties.h"
#include "nodes/main_thread.h"
#include "nodes/params.h"

#include <godot_cpp/core/class_db.hpp>

#include <cmath>
#include <string_view>

using namespace godot;

namespace grass {

String GrassField::label() const {
	return vformat("GrassField '%s'", get_name());
}
String GrassField::message(const String &p_text) const {
	// On another thread the renderer answers only once the main thread is free, which may be waiting for this one.
	if (_has_reported || !is_main_thread()) {
		return vformat("%s: %s", label(), p_text);
	}
	_has_reported = true;
	PackedStringArray build;
	build.push_back("GrassField " + get_version());
	build.push_back(_backend ? vformat("%s backend", _backend->get_name()) : String("no backend"));
	if (const String device = get_device(); !device.is_empty()) {
		build.push_back(device);
		build.push_back(get_driver());
	}
	return vformat("%s: %s (%s)", label(), p_text, String(", ").join(build));
}

void GrassField::set_size(const Vector2 &p_size) {
	GRASS_MAIN_THREAD_ONLY();
	_size.x = real_t(checked(FIELD_SIZE, p_size.x, label()));
	_size.y = real_t(checked(FIELD_SIZE, p_size.y, label()));
	request_rebuild();
}

void GrassField::set_patch(const Ref<GrassPatch> &p_patch) {
	GRASS_MAIN_THREAD_ONLY();
	const Callable changed = callable_mp(this, &GrassField::_patch_changed);
	if (_patch.is_valid()) {
		_patch->disconnect("changed", changed);
	}
	_patch = p_patch;
	if (_patch.is_valid()) {
		_patch->connect("changed", changed);
	}
	_patch_changed();
}

void GrassField::_patch_changed() {
	if (!is_main_thread()) { // a part of the resource changed on another one
		callable_mp(this, &GrassField::_patch_changed).call_deferred();
		return;
	}
	request_rebuild();
	if (_backend) {
		prepare_patches();
	}
}

void GrassField::set_seed(int64_t p_seed) {
	GRASS_MAIN_THREAD_ONLY();
	_seed = checked_int("seed", p_seed, 0, UINT32_MAX, label());
	request_rebuild();
}

void GrassField::set_simulated(bool p_simulated) {
	GRASS_MAIN_THREAD_ONLY();
	if (_simulated != p_simulated) {
		_simulated = p_simulated;
		request_rebuild(); // tiles that were awake go back to rest
		tell_of_leaving();
	}
}

void GrassField::set_backend(BackendMode p_mode) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_INDEX_MSG(int64_t(p_mode), 2, message("`backend` is BACKEND_AUTO or BACKEND_CPU."));
	if (_backend_mode != p_mode) {
		_backend_mode = p_mode;
		_backend.reset();
		_tiles.reset(); // its blades went with it
		request_rebuild();
	}
}

void GrassField::set_method(SolverMethod p_method) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_INDEX_MSG(int64_t(p_method), 2, message("`method` is METHOD_DIRECT or METHOD_PBD."));
	_solver_method = p_method;
	if (_backend) {
		choose_method();
	}
	update_tiles();
}

void GrassField::set_sleep_mode(SleepMode p_mode) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_INDEX_MSG(int64_t(p_mode), 2, message("`sleep_mode` is SLEEP_TIMER or SLEEP_ENERGY."));
	_sleep_mode = p_mode;
	update_tiles();
}

void GrassField::set_pool_tiles(int64_t p_tiles) {
	GRASS_MAIN_THREAD_ONLY();
	_pool_tiles = checked_int("pool_tiles", p_tiles, 0, TileParams::MAX_POOL_SIZE, label());
	request_rebuild();
}

void GrassField::set_collision_mask(int64_t p_mask) {
	GRASS_MAIN_THREAD_ONLY();
	_collision_mask = int64_t(uint32_t(p_mask));
	_tracker.set_mask(uint32_t(_collision_mask));
	update_configuration_warnings();
}

void GrassField::set_debug_view(DebugView p_view) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_INDEX_MSG(int64_t(p_view), 3, message("`debug_view` is DEBUG_VIEW_OFF, DEBUG_VIEW_AWAKE_TILES or DEBUG_VIEW_LOD."));
	_debug_view = p_view;
	set_uniform("debug_view", int64_t(p_view));
}

void GrassField::set_measure_time(bool p_measure) {
	GRASS_MAIN_THREAD_ONLY();
	_measure_time = p_measure;
	if (_backend) {
		_backend->set_measure_time(p_measure || _is_watched);
	}
}

void GrassField::set_param(int64_t p_param, double p_value) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_INDEX(p_param, int(FIELD_PARAMS.size()));
	const FieldParam &info = FIELD_PARAMS[size_t(p_param)];
	_params[size_t(p_param)] = checked(info.tunable, p_value, label());
	switch (info.effect) {
		case Effect::REBUILD:
			request_rebuild();
			break;
		case Effect::STEP:
			update_tiles();
			break;
		case Effect::UNIFORM:
			set_uniform(info.tunable.name, _params[size_t(p_param)]);
			break;
		case Effect::WIND:
			set_wind_uniforms();
			break;
		case Effect::VIEW:
			request_draw();
			break;
	}
}

void GrassField::update_tiles() {
	if (_backend) { // else build() will
		_tiles.set_params(tile_params());
		_tiles.stir(all_tiles()); // what stands still may move
	}
}

double GrassField::get_param(int64_t p_param) const {
	ERR_FAIL_INDEX_V(p_param, int(FIELD_PARAMS.size()), 0.0);
	return _params[size_t(p_param)];
}

void GrassField::set_color(int64_t p_index, const Color &p_color) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_INDEX(p_index, int(FIELD_COLORS.size()));
	_colors[size_t(p_index)] = p_color;
	set_uniform(FIELD_COLORS[size_t(p_index)].name, p_color);
}

Color GrassField::get_color(int64_t p_index) const {
	ERR_FAIL_INDEX_V(p_index, int(FIELD_COLORS.size()), Color());
	return _colors[size_t(p_index)];
}

void GrassField::set_uniform(const StringName &p_name, const Variant &p_value) {
	if (_backend) {
		_backend->set_uniform(p_name, p_value);
		_ground.set_uniform(p_name, p_value);
	}
}

// An idle editor, and a game in low processor mode, draw only once the rendering server was told something.
void GrassField::request_draw() {
	set_uniform("tile_size", _standing.setup.grid.get_tile_size());
}

void GrassField::set_wind_uniforms() {
	const double angle = Math::deg_to_rad(param(PARAM_WIND_DIRECTION)), speed = param(PARAM_WIND_SPEED);
	set_uniform("wind", Vector2(real_t(speed * std::cos(angle)), real_t(speed * std::sin(angle))));
	set_uniform("gust", Vector2(real_t(param(PARAM_GUST_SIZE)), real_t(param(PARAM_GUST_STRENGTH))));
}

// The ground has no wind.
void GrassField::set_wind_clock() {
	_backend->set_uniform("grass_time", Vector2(real_t(_wind_clock.sway), real_t(_wind_clock.roll)));
}

void GrassField::set_all_uniforms() {
	const TileGrid &grid = _standing.setup.grid;
	set_uniform("tiles", Vector2(real_t(grid.get_tiles_x()), real_t(grid.get_tiles_z())));
	set_uniform("lattice_points", lattice_texture());
	set_uniform("tile_size", grid.get_tile_size());
	set_uniform("clump",
			Vector4(_standing.setup.clump.size, _standing.setup.clump.height, _standing.setup.clump.lean, _standing.setup.clump.tint));
	set_uniform("canopy_height", _standing.setup.patch->mean_height * 1.1);
	set_uniform("debug_view", int64_t(_debug_view));
	set_uniform("follow_slope", _standing.setup.follow_slope);
	set_wind_clock();
	for (size_t i = 0; i < FIELD_PARAMS.size(); i++) {
		if (FIELD_PARAMS[i].effect == Effect::UNIFORM) {
			set_uniform(FIELD_PARAMS[i].tunable.name, _params[i]);
		}
	}
	for (size_t i = 0; i < FIELD_COLORS.size(); i++) {
		set_uniform(FIELD_COLORS[i].name, _colors[i]);
	}
	set_wind_uniforms();
	set_species_uniforms();
}

SolverParams GrassField::solver_params() const {
	SolverParams params;
	params.method = _method_now;
	params.natural_frequency = param(PARAM_NATURAL_FREQUENCY);
	params.damping_ratio = param(PARAM_DAMPING_RATIO);
	params.root_stiffness = param(PARAM_ROOT_STIFFNESS);
	params.bend_stiffness = param(PARAM_BEND_STIFFNESS);
	params.friction = param(PARAM_FRICTION);
	params.max_speed = param(PARAM_MAX_SPEED);
	params.iterations = int(param(PARAM_ITERATIONS));
	return params;
}

void GrassField::_validate_property(PropertyInfo &p_property) const {
	const CharString utf8 = String(p_property.name).utf8();
	const std::string_view name = utf8.get_data();
	const bool has_no_rule =
			(name == "fill_now" && (_fill.is_live || _fill.rule.is_null())) || (name == "fill_live" && _fill.rule.is_null());
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
	ClassDB::bind_method(D_METHOD("_get_param", "param"), &GrassField::get_param);
	ClassDB::bind_method(D_METHOD("_set_color", "index", "color"), &GrassField::set_color);
	ClassDB::bind_method(D_METHOD("_get_color", "index"), &GrassField::get_color);
#define BIND_PROPERTY(m_info, m_setter, m_getter)                                                                                          \
	ClassDB::bind_method(D_METHOD(#m_setter, "value"), &GrassField::m_setter);                                                             \
	ClassDB::bind_method(D_METHOD(#m_getter), &GrassField::m_getter);                                                                      \
	ADD_PROPERTY(m_info, #m_setter, #m_getter)

	ADD_GROUP("Field", "");
	BIND_PROPERTY(PropertyInfo(Variant::VECTOR2, "size", PROPERTY_HINT_NONE, "suffix:m"), set_size, get_size);
	add_numbers("Field");
	BIND_PROPERTY(PropertyInfo(Variant::OBJECT, "patch", PROPERTY_HINT_RESOURCE_TYPE, "GrassPatch"), set_patch, get_patch);
	BIND_PROPERTY(PropertyInfo(Variant::ARRAY, "species", PROPERTY_HINT_TYPE_STRING,
						  vformat("%d/%d:GrassSpecies", Variant::OBJECT, PROPERTY_HINT_RESOURCE_TYPE)),
			set_species, get_species);
	BIND_PROPERTY(PropertyInfo(Variant::INT, "seed", PROPERTY_HINT_RANGE, "0,4294967295,1"), set_seed, get_seed);
	ADD_GROUP("Map", "");
	BIND_PROPERTY(PropertyInfo(Variant::OBJECT, "map", PROPERTY_HINT_RESOURCE_TYPE, "GrassMap"), set_map, get_map);
	BIND_PROPERTY(PropertyInfo(Variant::OBJECT, "fill_rule", PROPERTY_HINT_RESOURCE_TYPE, "GrassFillRule"), set_fill_rule, get_fill_rule);
	BIND_PROPERTY(PropertyInfo(Variant::BOOL, "fill_live"), set_fill_live, is_fill_live);
	ClassDB::bind_method(D_METHOD("_get_fill_button"), &GrassField::get_fill_button);
	ADD_PROPERTY(PropertyInfo(Variant::CALLABLE, "fill_now", PROPERTY_HINT_TOOL_BUTTON, "Fill Now,Bucket", PROPERTY_USAGE_EDITOR), "",
			"_get_fill_button");
	add_numbers("Map");
	ADD_GROUP("Clumps", "");
	add_numbers("Clumps");
	ADD_GROUP("Simulation", "");
	BIND_PROPERTY(PropertyInfo(Variant::BOOL, "simulated"), set_simulated, is_simulated);
	BIND_PROPERTY(PropertyInfo(Variant::INT, "collision_mask", PROPERTY_HINT_LAYERS_3D_PHYSICS), set_collision_mask, get_collision_mask);
	BIND_PROPERTY(PropertyInfo(Variant::INT, "method", PROPERTY_HINT_ENUM, "Direct,PBD"), set_method, get_method);
	BIND_PROPERTY(PropertyInfo(Variant::INT, "sleep_mode", PROPERTY_HINT_ENUM, "Timer,Energy"), set_sleep_mode, get_sleep_mode);
	add_numbers("Simulation");
	BIND_PROPERTY(PropertyInfo(Variant::INT, "pool_tiles", PROPERTY_HINT_RANGE, "0,16384,1,suffix:tiles"), set_pool_tiles, get_pool_tiles);
	BIND_PROPERTY(PropertyInfo(Variant::INT, "backend", PROPERTY_HINT_ENUM, "Auto,CPU"), set_backend, get_backend);
	ADD_GROUP("Wind", "");
	add_numbers("Wind");
	ADD_GROUP("Look", "");
	BIND_PROPERTY(PropertyInfo(Variant::BOOL, "ground"), set_ground, has_ground);
	for (size_t i = 0; i < FIELD_COLORS.size(); i++) {
		ClassDB::add_property("GrassField", PropertyInfo(Variant::COLOR, FIELD_COLORS[i].name, PROPERTY_HINT_COLOR_NO_ALPHA), "_set_color",
				"_get_color", int(i));
	}
	add_numbers("Look");
	ADD_GROUP("Level of Detail", "");
	add_numbers("Level of Detail");
	ADD_GROUP("Debug", "");
	BIND_PROPERTY(PropertyInfo(Variant::INT, "debug_view", PROPERTY_HINT_ENUM, "Off,Awake Tiles,Level of Detail"), set_debug_view,
			get_debug_view);
	BIND_PROPERTY(PropertyInfo(Variant::BOOL, "measure_time"), set_measure_time, is_measuring_time);
#undef BIND_PROPERTY

	ClassDB::bind_method(D_METHOD("get_blade_count"), &GrassField::get_blade_count);
	ClassDB::bind_method(D_METHOD("get_tiles"), &GrassField::get_tiles);
	ClassDB::bind_method(D_METHOD("get_tile_size"), &GrassField::get_tile_size);
	ClassDB::bind_method(D_METHOD("get_tile_at", "global_position"), &GrassField::get_tile_at);
	ClassDB::bind_method(D_METHOD("get_tile_center", "tile"), &GrassField::get_tile_center);
	ClassDB::bind_method(D_METHOD("is_tile_awake", "tile"), &GrassField::is_tile_awake);
	ClassDB::bind_method(D_METHOD("get_awake_tile_count"), &GrassField::get_awake_tile_count);
	ClassDB::bind_method(D_METHOD("get_knots", "tile", "blade"), &GrassField::get_knots);
	ClassDB::bind_method(D_METHOD("get_tile_knots", "tile"), &GrassField::get_tile_knots);
	ClassDB::bind_method(D_METHOD("get_blade_species", "tile", "blade"), &GrassField::get_blade_species);
	ClassDB::bind_method(D_METHOD("get_body_count"), &GrassField::get_body_count);
	ClassDB::bind_method(D_METHOD("get_memory_usage"), &GrassField::get_memory_usage);
	ClassDB::bind_method(D_METHOD("get_statistics"), &GrassField::get_statistics);
	ClassDB::bind_static_method("GrassField", D_METHOD("get_version"), &GrassField::get_version);

	ClassDB::bind_method(D_METHOD("is_grass_at", "global_position"), &GrassField::is_grass_at);
	ClassDB::bind_method(D_METHOD("density_at", "global_position"), &GrassField::density_at);
	ClassDB::bind_method(D_METHOD("height_at", "global_position"), &GrassField::height_at);
	ClassDB::bind_method(D_METHOD("bend_at", "global_position"), &GrassField::bend_at);
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
	ClassDB::bind_method(D_METHOD("register_collider", "node", "shape"), &GrassField::register_collider);
	ClassDB::bind_method(D_METHOD("unregister_collider", "node"), &GrassField::unregister_collider);
	ClassDB::bind_method(D_METHOD("fill", "rule"), &GrassField::fill);
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
}

} // namespace grass
