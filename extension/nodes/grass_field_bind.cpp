// SPDX-License-Identifier: MIT
// What scripts and the inspector see of GrassField.
#include "nodes/grass_field.h"

#include "field/work_limits.h"
#include "ground/bare_answer.h"
#include "shared/bind_property.h"
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

// Names of 0.9.0, which its scenes and scripts use. The editor and new files do not show them; the class reference calls them deprecated.
void add_old_names() {
	ClassDB::bind_method(D_METHOD("density_at", "global_position"), &GrassField::get_density_at);
	ClassDB::bind_method(D_METHOD("height_at", "global_position"), &GrassField::get_height_at);
	ClassDB::bind_method(D_METHOD("bend_at", "global_position"), &GrassField::get_bend_at);
	ClassDB::bind_method(D_METHOD("get_tiles"), &GrassField::get_grid_size);
	const auto hidden = [](Variant::Type p_type, const char *p_name) {
		return PropertyInfo(p_type, p_name, PROPERTY_HINT_NONE, "", PROPERTY_USAGE_NONE);
	};
	ClassDB::add_property("GrassField", hidden(Variant::BOOL, "ground"), "set_soil_enabled", "is_soil_enabled");
	ClassDB::add_property("GrassField", hidden(Variant::FLOAT, "max_speed"), "_set_param", "_get_param", PARAM_SWING_SPEED_MAX);
}

} // namespace

void GrassField::_bind_methods() {
	ClassDB::bind_method(D_METHOD("_set_param", "param", "value"), &GrassField::set_param);
	ClassDB::bind_method(D_METHOD("_get_param", "param"), &GrassField::_get_param);
	ClassDB::bind_method(D_METHOD("_set_soil_texture", "index", "texture"), &GrassField::set_soil_texture);
	ClassDB::bind_method(D_METHOD("_get_soil_texture", "index"), &GrassField::get_soil_texture);
	ClassDB::bind_method(D_METHOD("_set_color", "index", "color"), &GrassField::set_color);
	ClassDB::bind_method(D_METHOD("_get_color", "index"), &GrassField::get_color);

	ADD_GROUP("Field", "");
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::VECTOR2, "size", PROPERTY_HINT_NONE, "suffix:m"), set_size, get_size);
	GRASS_BIND_PROPERTY(GrassField,
			PropertyInfo(Variant::ARRAY, "species", PROPERTY_HINT_TYPE_STRING,
					vformat("%d/%d:GrassSpecies", Variant::OBJECT, PROPERTY_HINT_RESOURCE_TYPE)),
			set_species, get_species);
	add_numbers("Field");
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
			GrassField, PropertyInfo(Variant::INT, "ground_mask", PROPERTY_HINT_LAYERS_3D_PHYSICS), set_ground_mask, get_ground_mask);
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::STRING_NAME, "ground_group"), set_ground_group, get_ground_group);
	GRASS_BIND_PROPERTY(
			GrassField, PropertyInfo(Variant::NODE_PATH, "terrain", PROPERTY_HINT_NODE_PATH_VALID_TYPES, "Node"), set_terrain, get_terrain);
	ADD_GROUP("Clumps", "");
	add_numbers("Clumps");
	ADD_GROUP("Simulation", "");
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::BOOL, "simulated"), set_simulated, is_simulated);
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::INT, "collision_mask", PROPERTY_HINT_LAYERS_3D_PHYSICS), set_collision_mask,
			get_collision_mask);
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::INT, "method", PROPERTY_HINT_ENUM, "Direct,PBD"), set_method, get_method);
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::INT, "simulation_detail", PROPERTY_HINT_ENUM, "Seen,Whole"),
			set_simulation_detail, get_simulation_detail);
	GRASS_BIND_PROPERTY(
			GrassField, PropertyInfo(Variant::INT, "sleep_mode", PROPERTY_HINT_ENUM, "Timer,Energy"), set_sleep_mode, get_sleep_mode);
	add_numbers("Simulation");
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::INT, "pool_tiles", PROPERTY_HINT_RANGE, range_hint(0, TileParams::MAX_POOL_SIZE)),
			set_pool_tiles, get_pool_tiles);
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::INT, "backend", PROPERTY_HINT_ENUM, "Auto,CPU"), set_backend, get_backend);
	ADD_GROUP("Wind", "");
	add_numbers("Wind");
	ADD_GROUP("Look", "");
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::BOOL, "soil_enabled"), set_soil_enabled, is_soil_enabled);
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::OBJECT, "terrain_texture", PROPERTY_HINT_RESOURCE_TYPE, "Texture2D"),
			set_terrain_texture, get_terrain_texture);
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
	GRASS_BIND_PROPERTY(GrassField,
			PropertyInfo(Variant::INT, "debug_view", PROPERTY_HINT_ENUM, "Off,Awake Tiles,Level of Detail,Density,Cost,Simulated Blades"),
			set_debug_view, get_debug_view);
	GRASS_BIND_PROPERTY(GrassField, PropertyInfo(Variant::BOOL, "measure_time"), set_measure_time, is_measuring_time);

	ClassDB::bind_method(D_METHOD("get_blade_count"), &GrassField::get_blade_count);
	ClassDB::bind_method(D_METHOD("get_grid_size"), &GrassField::get_grid_size);
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
	ClassDB::bind_method(D_METHOD("get_density_at", "global_position"), &GrassField::get_density_at);
	ClassDB::bind_method(D_METHOD("get_height_at", "global_position"), &GrassField::get_height_at);
	ClassDB::bind_method(D_METHOD("get_bend_at", "global_position"), &GrassField::get_bend_at);
	ClassDB::bind_method(D_METHOD("get_cover", "from", "to"), &GrassField::get_cover);
	ClassDB::bind_method(D_METHOD("get_rustle", "body"), &GrassField::get_rustle);
	ClassDB::bind_method(D_METHOD("explain", "global_position", "camera"), &GrassField::explain, DEFVAL(Variant()));
	ClassDB::bind_method(D_METHOD("cut", "shape", "transform"), &GrassField::cut);
	ClassDB::bind_method(
			D_METHOD("get_mown_share", "shape", "transform"), &GrassField::get_mown_share, DEFVAL(Ref<Shape3D>()), DEFVAL(Transform3D()));
	ClassDB::bind_method(D_METHOD("regrow", "height", "wear", "shape", "transform"), &GrassField::regrow, DEFVAL(0.0),
			DEFVAL(Ref<Shape3D>()), DEFVAL(Transform3D()));
	ClassDB::bind_method(D_METHOD("paint", "brush", "from", "to"), &GrassField::paint);
	ClassDB::bind_method(D_METHOD("trample", "global_position", "radius", "amount"), &GrassField::trample);
	ClassDB::bind_method(D_METHOD("bake_ground", "region", "collision_mask"), &GrassField::bake_ground, DEFVAL(Rect2()),
			DEFVAL(FieldGround::ALL_LAYERS));
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
	add_old_names();
	ADD_SIGNAL(MethodInfo("fill_finished"));
	for (const char *signal : { "plant_node_appeared", "plant_node_leaving" }) {
		ADD_SIGNAL(MethodInfo(signal, PropertyInfo(Variant::OBJECT, "node", PROPERTY_HINT_RESOURCE_TYPE, "Node3D"),
				PropertyInfo(Variant::INT, "species"), PropertyInfo(Variant::INT, "blade")));
	}
	ADD_SIGNAL(MethodInfo("body_entered_grass", PropertyInfo(Variant::OBJECT, "body", PROPERTY_HINT_RESOURCE_TYPE, "Node3D")));
	ADD_SIGNAL(MethodInfo("body_exited_grass", PropertyInfo(Variant::OBJECT, "body", PROPERTY_HINT_RESOURCE_TYPE, "Node3D")));

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
