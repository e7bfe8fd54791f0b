// SPDX-License-Identifier: MIT
#include "nodes/field_api.h"

#include "field/work_limits.h"
#include "ground/bare_answer.h"
#include "shared/bind_property.h"
#include "shared/build_info.h"
#include "shared/params.h"

#include <godot_cpp/core/class_db.hpp>

#include <string_view>

using namespace godot;

namespace grass {

namespace {

void add_numbers(std::string_view p_group) {
	for (const FieldParam &param : FIELD_PARAMS) {
		if (param.group == p_group) {
			ClassDB::add_property("GrassField", property_of(param.tunable), "_set_param", "_get_param", param.id);
		}
	}
}

} // namespace

void FieldApi::bind() {
	bind_properties();
	bind_queries();
	bind_deeds();
	bind_signals();
	bind_constants();
}

// Binds the properties in the order of the inspector.
void FieldApi::bind_properties() {
	settings.bind<"_set_param", &FieldSettings::set_param>({ "param", "value" });
	settings.bind_reader<"_get_param", &FieldSettings::get_param_value>("param");
	settings.bind<"_set_color", &FieldSettings::set_color>({ "index", "color" });
	settings.bind_reader<"_get_color", &FieldSettings::get_color>("index");
	settings.bind<"_set_soil_texture", &FieldSettings::set_soil_texture>({ "index", "texture" });
	settings.bind_reader<"_get_soil_texture", &FieldSettings::get_soil_texture>("index");

	ADD_GROUP("Field", "");
	settings.bind_property<"set_size", &FieldSettings::set_size, "get_size", &FieldSettings::get_size>(
			PropertyInfo(Variant::VECTOR2, "size", PROPERTY_HINT_NONE, "suffix:m"));
	GRASS_BIND_PROPERTY(GrassField,
			PropertyInfo(Variant::ARRAY, "species", PROPERTY_HINT_TYPE_STRING,
					vformat("%d/%d:GrassSpecies", Variant::OBJECT, PROPERTY_HINT_RESOURCE_TYPE)),
			set_species, get_species);
	add_numbers("Field");
	settings.bind_property<"set_seed", &FieldSettings::set_seed, "get_seed", &FieldSettings::get_seed>(
			PropertyInfo(Variant::INT, "seed", PROPERTY_HINT_RANGE, range_hint(0, UINT32_MAX)));
	ADD_GROUP("Map", "");
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::OBJECT, "map", PROPERTY_HINT_RESOURCE_TYPE, "GrassMap"), set_map, get_map);
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::OBJECT, "fill_rule", PROPERTY_HINT_RESOURCE_TYPE, "GrassFillRule"), set_fill_rule,
			get_fill_rule);
	sources.bind_property<"set_fill_live", &FieldSources::set_fill_live, "is_fill_live", &FieldSources::is_fill_live>(
			PropertyInfo(Variant::BOOL, "fill_live"));
	ClassDB::bind_method(D_METHOD("_get_fill_button"), &GrassField::get_fill_button);
	ADD_PROPERTY(PropertyInfo(Variant::CALLABLE, "fill_now", PROPERTY_HINT_TOOL_BUTTON, "Fill Now,Bucket", PROPERTY_USAGE_EDITOR), "",
			"_get_fill_button");
	add_numbers("Map");
	settings.bind_property<"set_ground_mask", &FieldSettings::set_ground_mask, "get_ground_mask", &FieldSettings::get_ground_mask>(
			PropertyInfo(Variant::INT, "ground_mask", PROPERTY_HINT_LAYERS_3D_PHYSICS));
	settings.bind_property<"set_ground_group", &FieldSettings::set_ground_group, "get_ground_group", &FieldSettings::get_ground_group>(
			PropertyInfo(Variant::STRING_NAME, "ground_group"));
	sources.bind_property<"set_terrain", &FieldSources::set_terrain, "get_terrain", &FieldSources::get_terrain>(
			PropertyInfo(Variant::NODE_PATH, "terrain", PROPERTY_HINT_NODE_PATH_VALID_TYPES, "Node"));
	ADD_GROUP("Clumps", "");
	add_numbers("Clumps");
	ADD_GROUP("Simulation", "");
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::BOOL, "simulated"), set_simulated, is_simulated);
	settings.bind_property<"set_collision_mask", &FieldSettings::set_collision_mask, "get_collision_mask",
			&FieldSettings::get_collision_mask>(PropertyInfo(Variant::INT, "collision_mask", PROPERTY_HINT_LAYERS_3D_PHYSICS));
	settings.bind_property<"set_method", &FieldSettings::set_method, "get_method", &FieldSettings::get_method>(
			PropertyInfo(Variant::INT, "method", PROPERTY_HINT_ENUM, "Direct,PBD"));
	settings.bind_property<"set_simulation_detail", &FieldSettings::set_simulation_detail, "get_simulation_detail",
			&FieldSettings::get_simulation_detail>(PropertyInfo(Variant::INT, "simulation_detail", PROPERTY_HINT_ENUM, "Seen,Whole"));
	settings.bind_property<"set_sleep_mode", &FieldSettings::set_sleep_mode, "get_sleep_mode", &FieldSettings::get_sleep_mode>(
			PropertyInfo(Variant::INT, "sleep_mode", PROPERTY_HINT_ENUM, "Timer,Energy"));
	add_numbers("Simulation");
	settings.bind_property<"set_pool_tiles", &FieldSettings::set_pool_tiles, "get_pool_tiles", &FieldSettings::get_pool_tiles>(
			PropertyInfo(Variant::INT, "pool_tiles", PROPERTY_HINT_RANGE, range_hint(0, TileParams::MAX_POOL_SIZE)));
	settings.bind_property<"set_backend", &FieldSettings::set_backend, "get_backend", &FieldSettings::get_backend>(
			PropertyInfo(Variant::INT, "backend", PROPERTY_HINT_ENUM, "Auto,CPU"));
	ADD_GROUP("Wind", "");
	add_numbers("Wind");
	bind_look();
}

void FieldApi::bind_look() {
	ADD_GROUP("Look", "");
	settings.bind_property<"set_soil_enabled", &FieldSettings::set_soil_enabled, "is_soil_enabled", &FieldSettings::is_soil_enabled>(
			PropertyInfo(Variant::BOOL, "soil_enabled"));
	settings.bind_property<"set_terrain_texture", &FieldSettings::set_terrain_texture, "get_terrain_texture",
			&FieldSettings::get_terrain_texture>(
			PropertyInfo(Variant::OBJECT, "terrain_texture", PROPERTY_HINT_RESOURCE_TYPE, "Texture2D"));
	for (size_t i = 0; i < FIELD_COLORS.size(); i++) {
		ClassDB::add_property("GrassField", PropertyInfo(Variant::COLOR, FIELD_COLORS[i].name, PROPERTY_HINT_COLOR_NO_ALPHA), "_set_color",
				"_get_color", int(i));
	}
	for (size_t i = 0; i < SOIL_TEXTURES.size(); i++) {
		ClassDB::add_property("GrassField", PropertyInfo(Variant::OBJECT, SOIL_TEXTURES[i], PROPERTY_HINT_RESOURCE_TYPE, "Texture2D"),
				"_set_soil_texture", "_get_soil_texture", int(i));
	}
	add_numbers("Look");
	ADD_GROUP("Surface", "");
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::OBJECT, "surface_hook", PROPERTY_HINT_RESOURCE_TYPE, "ShaderInclude"),
			set_surface_hook, get_surface_hook);
	add_numbers("Surface");
	ADD_GROUP("Level of Detail", "");
	add_numbers("Level of Detail");
	ADD_GROUP("Debug", "");
	settings.bind_property<"set_debug_view", &FieldSettings::set_debug_view, "get_debug_view", &FieldSettings::get_debug_view>(
			PropertyInfo(Variant::INT, "debug_view", PROPERTY_HINT_ENUM, "Off,Awake Tiles,Level of Detail,Density,Cost,Simulated Blades"));
	settings.bind_property<"set_measure_time", &FieldSettings::set_measure_time, "is_measuring_time", &FieldSettings::is_measuring_time>(
			PropertyInfo(Variant::BOOL, "measure_time"));
}

void FieldApi::bind_queries() {
	queries.bind<"get_blade_count", &FieldQueries::get_blade_count>();
	queries.bind<"get_grid_size", &FieldQueries::get_grid_size>();
	queries.bind<"get_tile_size", &FieldQueries::get_tile_size>();
	queries.bind<"get_tile_at", &FieldQueries::get_tile_at>({ "global_position" });
	queries.bind<"get_tile_center", &FieldQueries::get_tile_center>({ "tile" });
	queries.bind<"is_tile_awake", &FieldQueries::is_tile_awake>({ "tile" });
	queries.bind<"get_awake_tile_count", &FieldQueries::get_awake_tile_count>();
	queries.bind<"get_knots", &FieldQueries::get_knots>({ "tile", "blade" });
	queries.bind<"get_tile_knots", &FieldQueries::get_tile_knots>({ "tile" });
	queries.bind<"get_blade_knots", &FieldQueries::get_blade_knots>({ "blades" });
	queries.bind<"wait_for_knots", &FieldQueries::wait_for_knots>({ "blades" });
	queries.bind<"get_tile_blades", &FieldQueries::get_tile_blades>({ "tile" });
	queries.bind<"find_blades", &FieldQueries::find_blades>({ "global_position", "radius" });
	queries.bind<"get_blade_species", &FieldQueries::get_blade_species>({ "tile", "blade" });
	queries.bind<"get_body_count", &FieldQueries::get_body_count>();
	report.bind<"get_memory_usage", &FieldReport::get_memory_usage>();
	report.bind<"get_statistics", &FieldReport::get_statistics>();
	report.bind<"get_counters", &FieldReport::get_counters>();
	ClassDB::bind_static_method("GrassField", D_METHOD("get_version"), &get_version);

	queries.bind<"is_grass_at", &FieldQueries::is_grass_at>({ "global_position" });
	queries.bind<"get_density_at", &FieldQueries::get_density_at>({ "global_position" });
	queries.bind<"get_height_at", &FieldQueries::get_height_at>({ "global_position" });
	queries.bind<"get_bend_at", &FieldQueries::get_bend_at>({ "global_position" });
	queries.bind<"get_cover", &FieldQueries::get_cover>({ "from", "to" });
	queries.bind<"get_rustle", &FieldQueries::get_rustle>({ "body" });
	report.bind<"explain", &FieldReport::explain>({ "global_position", "camera" }, DEFVAL(Variant()));
	work.bind<"get_mown_share", &FieldWork::get_mown_share>({ "shape", "transform" }, DEFVAL(Ref<Shape3D>()), DEFVAL(Transform3D()));
	settings.bind<"get_hook_parameter", &FieldSettings::get_hook_parameter>({ "name" });
}

void FieldApi::bind_deeds() {
	work.bind<"cut", &FieldWork::cut>({ "shape", "transform" });
	work.bind<"regrow", &FieldWork::regrow>(
			{ "height", "wear", "shape", "transform" }, DEFVAL(0.0), DEFVAL(Ref<Shape3D>()), DEFVAL(Transform3D()));
	work.bind<"paint", &FieldWork::paint>({ "brush", "from", "to" });
	work.bind<"trample", &FieldWork::trample>({ "global_position", "radius", "amount" });
	work.bind<"bake_ground", &FieldWork::bake_ground>({ "region", "collision_mask" }, DEFVAL(Rect2()), DEFVAL(FieldGround::ALL_LAYERS));
	work.bind<"bake_ground_from", &FieldWork::bake_ground_from>({ "shape", "transform" });
	sources.bind<"terrain_changed", &FieldSources::terrain_changed>({ "area" }, DEFVAL(AABB()));
	sources.bind<"fill", &FieldSources::fill>({ "rule" });
	forces.bind<"blast", &FieldForces::blast>({ "global_position", "speed", "radius", "duration" }, DEFVAL(FORCE_SPEED.initial),
			DEFVAL(FORCE_RADIUS.initial), DEFVAL(FORCE_DURATION.initial));
	forces.bind<"push", &FieldForces::push>(
			{ "global_position", "velocity", "radius", "duration" }, DEFVAL(FORCE_RADIUS.initial), DEFVAL(FORCE_DURATION.initial));
	ticks.bind<"register_collider", &FieldTicks::register_collider>({ "node", "shape" });
	ticks.bind<"unregister_collider", &FieldTicks::unregister_collider>({ "node" });
	record.bind<"record", &FieldRecord::record>({ "path" });
	record.bind<"play_record", &FieldRecord::play_record>({ "path" });
	record.bind<"stop_record", &FieldRecord::stop_record>();
	record.bind<"get_record_state", &FieldRecord::get_record_state>();
	settings.bind<"set_hook_parameter", &FieldSettings::set_hook_parameter>({ "name", "value" });
}

void FieldApi::bind_signals() {
	ADD_SIGNAL(MethodInfo("fill_finished"));
	for (const char *signal : { "plant_node_appeared", "plant_node_leaving" }) {
		ADD_SIGNAL(MethodInfo(signal, PropertyInfo(Variant::OBJECT, "node", PROPERTY_HINT_RESOURCE_TYPE, "Node3D"),
				PropertyInfo(Variant::INT, "species"), PropertyInfo(Variant::INT, "blade")));
	}
	for (const char *signal : { "body_entered_grass", "body_exited_grass" }) {
		ADD_SIGNAL(MethodInfo(signal, PropertyInfo(Variant::OBJECT, "body", PROPERTY_HINT_RESOURCE_TYPE, "Node3D")));
	}
}

void FieldApi::bind_constants() {
	using enum FieldEnums::BackendMode;
	using enum FieldEnums::SolverMethod;
	using enum FieldEnums::SimulationDetail;
	using enum FieldEnums::SleepMode;
	using enum FieldEnums::DebugView;
	BIND_ENUM_CONSTANT(BACKEND_AUTO);
	BIND_ENUM_CONSTANT(BACKEND_CPU);
	BIND_ENUM_CONSTANT(METHOD_DIRECT);
	BIND_ENUM_CONSTANT(METHOD_PBD);
	BIND_ENUM_CONSTANT(SIMULATION_SEEN);
	BIND_ENUM_CONSTANT(SIMULATION_WHOLE);
	BIND_ENUM_CONSTANT(SLEEP_TIMER);
	BIND_ENUM_CONSTANT(SLEEP_ENERGY);
	BIND_ENUM_CONSTANT(DEBUG_VIEW_OFF);
	BIND_ENUM_CONSTANT(DEBUG_VIEW_AWAKE_TILES);
	BIND_ENUM_CONSTANT(DEBUG_VIEW_LOD);
	BIND_ENUM_CONSTANT(DEBUG_VIEW_DENSITY);
	BIND_ENUM_CONSTANT(DEBUG_VIEW_COST);
	BIND_ENUM_CONSTANT(DEBUG_VIEW_SIMULATED);
	ClassDB::bind_integer_constant("GrassField", StringName(), "BLADES_MAX", BLADES_MAX);
	ClassDB::bind_integer_constant("GrassField", StringName(), "AREA_MAX", AREA_MAX);
	ClassDB::bind_integer_constant("GrassField", StringName(), "RAYS_AREA_MAX", RAYS_AREA_MAX);
	ClassDB::bind_integer_constant("GrassField", StringName(), "COVER_DISTANCE_MAX", COVER_DISTANCE_MAX);
	for (size_t reason = 0; reason < BARE_REASONS.size(); reason++) { // see explain()
		ClassDB::bind_integer_constant("GrassField", "Reason", BARE_REASONS[reason], int64_t(reason));
	}
}

} // namespace grass
