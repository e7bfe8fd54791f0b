// SPDX-License-Identifier: MIT
// Sets those properties of a field that are values: clamps each, warns if it had to, and passes it on to its readers. The node itself sets
// those whose changes it listens to: species, map, fill rule and surface hook.
#pragma once

#include "field/field_enums.h"
#include "field/field_host.h"
#include "field/field_life.h"
#include "field/field_properties.h"
#include "field/standing_field.h"
#include "physics/body_tracker.h"
#include "shared/property_value.h"

namespace grass {

class FieldSettings {
public:
	FieldSettings(FieldHost &p_host, FieldProperties &p_properties, FieldLife &p_life, StandingField &p_standing, BodyTracker &p_tracker) :
			_host(p_host), _properties(p_properties), _life(p_life), _standing(p_standing), _tracker(p_tracker) {}

	void set_size(const godot::Vector2 &p_size); // metres along x and z
	godot::Vector2 get_size() const { return _properties.size; }
	void set_seed(int64_t p_seed);
	int64_t get_seed() const { return _properties.seed; }
	void set_method(FieldEnums::SolverMethod p_method);
	FieldEnums::SolverMethod get_method() const { return FieldEnums::SolverMethod(_properties.method); }
	void set_simulation_detail(FieldEnums::SimulationDetail p_detail);
	FieldEnums::SimulationDetail get_simulation_detail() const { return FieldEnums::SimulationDetail(_properties.simulation_detail); }
	void set_sleep_mode(FieldEnums::SleepMode p_mode);
	FieldEnums::SleepMode get_sleep_mode() const { return FieldEnums::SleepMode(_properties.sleep_mode); }
	void set_backend(FieldEnums::BackendMode p_mode);
	FieldEnums::BackendMode get_backend() const { return _properties.is_on_cpu ? FieldEnums::BACKEND_CPU : FieldEnums::BACKEND_AUTO; }
	void set_pool_tiles(int64_t p_tiles);
	int64_t get_pool_tiles() const { return _properties.pool_tiles; }
	void fit_pool(int64_t p_tiles); // for a world: sets `pool_tiles` without making the field again
	void set_collision_mask(int64_t p_mask);
	int64_t get_collision_mask() const { return _properties.collision_mask; }
	void set_ground_mask(int64_t p_mask);
	int64_t get_ground_mask() const { return _properties.ground_mask; }
	void set_ground_group(const godot::StringName &p_group); // empty: all bodies
	godot::StringName get_ground_group() const { return value_of(_properties.ground_group); }
	FieldGround get_ground_band() const { return _properties.ground_band(); }
	void set_soil_enabled(bool p_enabled) { _properties.has_soil = p_enabled; }
	bool is_soil_enabled() const { return _properties.has_soil; }
	void set_debug_view(FieldEnums::DebugView p_view);
	FieldEnums::DebugView get_debug_view() const { return FieldEnums::DebugView(_properties.debug_view); }
	void set_measure_time(bool p_measure);
	bool is_measuring_time() const { return _properties.measure_time; }
	void set_terrain_texture(const godot::Ref<godot::Texture2D> &p_texture); // null: none
	godot::Ref<godot::Texture2D> get_terrain_texture() const { return value_of(_properties.terrain_texture); }
	void show_terrain_colors(const godot::Ref<godot::Texture2D> &p_colors); // unless the user set a texture
	// Sets the hook. p_changed must call compile_hook().
	void set_surface_hook(const godot::Ref<godot::ShaderInclude> &p_include, const godot::Callable &p_changed);
	godot::Ref<godot::ShaderInclude> get_surface_hook() const { return value_of(_properties.hook.get_include()); }
	void compile_hook();
	void set_hook_parameter(const godot::StringName &p_name, const godot::Variant &p_value); // null: the include's default
	godot::Variant get_hook_parameter(const godot::StringName &p_name) const;

	// Numbers (FIELD_PARAMS) and colours (FIELD_COLORS) by their index.
	void set_param(int64_t p_param, double p_value);
	double get_param(int64_t p_param) const;
	godot::Variant get_param_value(int64_t p_param) const; // for the property: an int if it is a whole number
	void set_soil_texture(int64_t p_index, const godot::Ref<godot::Texture2D> &p_texture); // null: none
	godot::Ref<godot::Texture2D> get_soil_texture(int64_t p_index) const;
	void set_color(int64_t p_index, const godot::Color &p_color);
	godot::Color get_color(int64_t p_index) const;

private:
	void show_terrain_texture(const godot::Ref<godot::Texture2D> &p_texture, const godot::Ref<godot::Texture2D> &p_colors);
	godot::String no_uniform(const char *p_call, const godot::StringName &p_name) const; // for messages

	FieldHost &_host;
	FieldProperties &_properties;
	FieldLife &_life;
	StandingField &_standing;
	BodyTracker &_tracker;
};

} // namespace grass
