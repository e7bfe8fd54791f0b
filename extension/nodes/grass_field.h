// SPDX-License-Identifier: MIT
// GrassField: the node. Holds properties and wires the parts: bodies -> standing field in a physics tick, cameras -> standing field in a
// frame, properties -> life -> standing field when they change. No maths here.
#pragma once

#include "field/field_forces.h"
#include "field/field_host.h"
#include "field/field_life.h"
#include "field/field_places.h"
#include "field/field_properties.h"
#include "field/field_work.h"
#include "field/other_light.h"
#include "field/plant_nodes.h"
#include "field/standing_field.h"
#include "ground/field_filler.h"
#include "ground/field_terrain.h"
#include "nodes/field_monitors.h"
#include "nodes/field_turns.h"
#include "physics/field_bodies.h"
#include "physics/ground_rays.h"
#include "shared/frames.h"
#include "shared/property_value.h"

#include <godot_cpp/classes/geometry_instance3d.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_int64_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <vector>

namespace grass {

class GrassField : public godot::GeometryInstance3D, private FieldHost {
	GDCLASS(GrassField, godot::GeometryInstance3D)

public:
	enum SolverMethod : int64_t {
		METHOD_DIRECT = int(Method::DIRECT),
		METHOD_PBD = int(Method::PBD),
	};
	enum SimulationDetail : int64_t {
		SIMULATION_SEEN = int(grass::SimulationDetail::SEEN),
		SIMULATION_WHOLE = int(grass::SimulationDetail::WHOLE),
	};
	enum SleepMode : int64_t {
		SLEEP_TIMER = int(grass::SleepMode::TIMER),
		SLEEP_ENERGY = int(grass::SleepMode::ENERGY),
	};
	enum BackendMode : int64_t {
		BACKEND_AUTO, // GPU if the renderer has a RenderingDevice, otherwise CPU
		BACKEND_CPU,
	};
	enum DebugView : int64_t {
		DEBUG_VIEW_OFF = GRASS_DEBUG_OFF,
		DEBUG_VIEW_AWAKE_TILES = GRASS_DEBUG_AWAKE,
		DEBUG_VIEW_LOD = GRASS_DEBUG_LOD,
		DEBUG_VIEW_DENSITY = GRASS_DEBUG_DENSITY,
		DEBUG_VIEW_COST = GRASS_DEBUG_COST,
		DEBUG_VIEW_SIMULATED = GRASS_DEBUG_SIMULATED,
	};

	GrassField();

	void set_size(const godot::Vector2 &p_size); // metres along x and z
	godot::Vector2 get_size() const { return _properties.size; }
	void set_map(const godot::Ref<GrassMap> &p_map); // null: grass grows everywhere
	godot::Ref<GrassMap> get_map() const { return value_of(_properties.map); }
	void make_map(); // a new one, with grass everywhere
	// Instead of set_map(), for a map that another thread prepared as find_map_place() says.
	void show_map(const godot::Ref<GrassMap> &p_map, std::unique_ptr<ShownMap> p_prepared);
	// Also of a field that is not made, nor in the tree; nothing until its patches are there.
	std::optional<MapPlace> find_map_place() const { return grass::find_map_place(_properties); }
	bool is_made() const { return _life.get_stage() == FieldLife::Stage::SHOWN; } // as the properties have it
	// For a world: makes the field as its own frames do, whether it processes or not. Scripts run: afterwards it may be gone.
	void come() { (void)advance(); }
	// For FieldTurns: a tick and a frame, which the field does not need while it rests. Scripts run: afterwards it may be gone.
	bool needs_tick() const;
	void tick(double p_delta);
	bool needs_frame() const;
	void frame(double p_delta);
	// Must be called after tick(). If nothing is left to do, rests until something calls stir(), and returns the bodies to watch meanwhile.
	std::vector<RestingBody> rest();
	// Must be called after any change that a tick or a frame has to follow.
	void stir() { _rests = _frame_rests = false; }
	void stir_by(std::span<const Mover> p_movers); // if one of them is near
	void count_reads(const BodyReads &p_reads) { _shared_reads.add(p_reads); } // that serve all fields
	double get_build_ms() const { return _life.get_most_ms(); } // that its last making took in one frame, at most
	void join(const GrassField &p_other) { _standing.join(p_other._standing); } // before it enters the tree, of the same blades
	void set_streamed() { _properties.is_streamed = true; } // before it enters the tree
	// Sets a function that gets the warnings of this field, instead of the console.
	using WarningTeller = std::function<void(const godot::String &p_warning)>;
	void set_warning_teller(const WarningTeller &p_teller) { _warning_teller = p_teller; }
	// For a world: sets the centre's place in the noise, metres. A field outside a world is at (0, 0).
	void set_noise_origin(const godot::Vector2i &p_place);
	void set_species(const godot::TypedArray<GrassSpecies> &p_species); // none: one species with the defaults
	godot::TypedArray<GrassSpecies> get_species() const { return _properties.species.get(); }
	void set_fill_rule(const godot::Ref<GrassFillRule> &p_rule); // null: removes what it filled
	godot::Ref<GrassFillRule> get_fill_rule() const { return value_of(_filler.get_rule()); }
	void set_fill_live(bool p_live);
	bool is_fill_live() const { return _filler.is_live(); }
	// For the editor: draws the grass as a brush would leave it, without changing the map. Lasts until the map changes or the next preview.
	// Not for a field without a map.
	void preview(const MapShape &p_shape, const Brush &p_brush);
	void end_preview();
	bool is_preview() const { return _standing.get_map() != nullptr && _standing.get_map()->is_preview(); }
	double fill(const godot::Ref<GrassFillRule> &p_rule); // square metres of full grass added
	double fill_whole(const godot::Ref<GrassFillRule> &p_rule); // for the editor: however large the field is
	godot::Callable get_fill_button() const;
	void set_seed(int64_t p_seed);
	int64_t get_seed() const { return _properties.seed; }
	void set_simulated(bool p_simulated);
	bool is_simulated() const { return _properties.simulated; }
	void set_method(SolverMethod p_method);
	SolverMethod get_method() const { return SolverMethod(_properties.method); }
	void set_simulation_detail(SimulationDetail p_detail);
	SimulationDetail get_simulation_detail() const { return SimulationDetail(_properties.simulation_detail); }
	void set_sleep_mode(SleepMode p_mode);
	SleepMode get_sleep_mode() const { return SleepMode(_properties.sleep_mode); }
	void set_backend(BackendMode p_mode);
	BackendMode get_backend() const { return _properties.is_on_cpu ? BACKEND_CPU : BACKEND_AUTO; }
	void set_pool_tiles(int64_t p_tiles);
	int64_t get_pool_tiles() const { return _properties.pool_tiles; }
	// For a world: sets `pool_tiles` without making the field again; slots that exist now.
	void fit_pool(int64_t p_tiles);
	int64_t get_pool_slots() const { return _standing.get_field().get_tiles().get_room(); }
	void set_collision_mask(int64_t p_mask);
	int64_t get_collision_mask() const { return _properties.collision_mask; }
	// grass_field_hook.cpp: the user's include that the shaders call.
	void set_surface_hook(const godot::Ref<godot::ShaderInclude> &p_include);
	godot::Ref<godot::ShaderInclude> get_surface_hook() const { return value_of(_properties.hook.get_include()); }
	void set_hook_parameter(const godot::StringName &p_name, const godot::Variant &p_value); // null: the include's default
	godot::Variant get_hook_parameter(const godot::StringName &p_name) const;
	void set_terrain_texture(const godot::Ref<godot::Texture2D> &p_texture); // null: none
	godot::Ref<godot::Texture2D> get_terrain_texture() const { return value_of(_properties.terrain_texture); }
	// grass_field_terrain.cpp: a node that reports heights, through methods with known names.
	void set_terrain(const godot::NodePath &p_path); // empty: none
	godot::NodePath get_terrain() const { return value_of(_terrain.get_path()); }
	void terrain_changed(const godot::AABB &p_area); // global; empty: everywhere
	void set_ground_mask(int64_t p_mask);
	int64_t get_ground_mask() const { return _properties.ground_mask; }
	void set_ground_group(const godot::StringName &p_group); // empty: all bodies
	godot::StringName get_ground_group() const { return value_of(_properties.ground_group); }
	void set_soil_enabled(bool p_enabled) { _properties.has_soil = p_enabled; }
	bool is_soil_enabled() const { return _properties.has_soil; }
	void set_debug_view(DebugView p_view);
	DebugView get_debug_view() const { return DebugView(_properties.debug_view); }
	void set_measure_time(bool p_measure);
	bool is_measuring_time() const { return _properties.measure_time; }
	// Indexed properties: numbers (FIELD_PARAMS) and colours (FIELD_COLORS).
	void set_param(int64_t p_param, double p_value);
	double get_param(int64_t p_param) const;
	FieldGround get_ground_band() const { return _properties.ground_band(); }
	godot::Variant _get_param(int64_t p_param) const; // for the property: an int if it is a whole number
	void set_soil_texture(int64_t p_index, const godot::Ref<godot::Texture2D> &p_texture); // null: none
	godot::Ref<godot::Texture2D> get_soil_texture(int64_t p_index) const;
	void set_color(int64_t p_index, const godot::Color &p_color);
	godot::Color get_color(int64_t p_index) const;

	// grass_field_queries.cpp and _methods.cpp: the methods that scripts call. Places are global.
	// What is there. A tile is named by its column (along x) and row (along z).
	int64_t get_blade_count() const;
	godot::Vector2i get_grid_size() const; // number of tiles along x and z
	double get_tile_size() const; // metres
	godot::Vector2i get_tile_at(const godot::Vector3 &p_global_position) const; // (-1, -1) outside the field
	godot::Vector3 get_tile_center(const godot::Vector2i &p_tile) const;
	bool is_tile_awake(const godot::Vector2i &p_tile) const;
	int64_t get_awake_tile_count() const;
	// Returns a blade's 16 knots from root to tip, without wind and without waiting: for an awake tile on the GPU they are at most two
	// ticks old.
	godot::PackedVector3Array get_knots(const godot::Vector2i &p_tile, int64_t p_blade);
	godot::PackedVector3Array get_tile_knots(const godot::Vector2i &p_tile);
	godot::PackedVector3Array get_blade_knots(const godot::PackedInt64Array &p_blades);
	godot::PackedVector3Array wait_for_knots(const godot::PackedInt64Array &p_blades); // their current state
	godot::PackedInt64Array get_tile_blades(const godot::Vector2i &p_tile) const;
	godot::PackedInt64Array find_blades(const godot::Vector3 &p_global_position, double p_radius);
	int64_t get_blade_species(const godot::Vector2i &p_tile, int64_t p_blade) const; // index in `species`
	int64_t get_body_count() const { return _bodies.get_count(); }
	int64_t get_memory_usage() const; // bytes
	FieldMemory find_memory() const;
	static godot::String get_version(); // of the extension
	godot::Dictionary get_statistics() const;
	godot::Dictionary get_counters() const;
	double get_monitor(FieldMonitor p_monitor); // this field's share; times are measured from the first call on
	godot::Transform3D field_transform() const override; // global, without scale
	godot::Transform3D drawn_transform() override;

	bool is_grass_at(const godot::Vector3 &p_global_position);
	double get_density_at(const godot::Vector3 &p_global_position);
	double get_height_at(const godot::Vector3 &p_global_position);
	double get_cover(const godot::Vector3 &p_from, const godot::Vector3 &p_to); // share of the view between them that blades hide
	double get_rustle(const godot::Node3D *p_body) const; // blades per second that it moves over
	godot::Vector3 get_bend_at(const godot::Vector3 &p_global_position);
	// Explains why there is no grass, or less than there could be. p_camera: null: the viewport's.
	godot::Dictionary explain(const godot::Vector3 &p_global_position, const godot::Camera3D *p_camera);
	bool has_level_at(const godot::Vector3 &p_global_position) const; // within its size and the band of its ground
	godot::Dictionary cut(const godot::Ref<godot::Shape3D> &p_shape, const godot::Transform3D &p_transform);
	double get_mown_share(const godot::Ref<godot::Shape3D> &p_shape, const godot::Transform3D &p_transform);
	void regrow(double p_height, double p_wear, const godot::Ref<godot::Shape3D> &p_shape, const godot::Transform3D &p_transform);
	double paint(const godot::Ref<GrassBrush> &p_brush, const godot::Vector3 &p_from, const godot::Vector3 &p_to);
	double trample(const godot::Vector3 &p_global_position, double p_radius, double p_amount);
	// Start a blast, or a gust of air. p_duration: seconds. For ranges see FORCE_SPEED and others in core/blades/force.h.
	void blast(const godot::Vector3 &p_global_position, double p_speed, double p_radius, double p_duration);
	void push(const godot::Vector3 &p_global_position, const godot::Vector3 &p_velocity, double p_radius, double p_duration);
	void register_collider(godot::Node3D *p_node, const godot::Ref<godot::Shape3D> &p_shape);
	void unregister_collider(godot::Node3D *p_node);
	double find_area(const godot::Ref<godot::Shape3D> &p_shape, const godot::Transform3D &p_transform) const; // see FieldWork
	int64_t bake_ground(const godot::Rect2 &p_region = godot::Rect2(), int64_t p_mask = FieldGround::ALL_LAYERS);
	int64_t bake_whole_ground(); // for the editor: however large the field is
	int64_t bake_ground_from(const godot::Ref<godot::Shape3D> &p_shape, const godot::Transform3D &p_transform);

	godot::PackedStringArray _get_configuration_warnings() const override;
	godot::AABB _get_aabb() const override;

protected:
	static void _bind_methods();
	void _notification(int p_what);
	void _validate_property(godot::PropertyInfo &p_property) const;
	bool _set(const godot::StringName &p_name, const godot::Variant &p_value);
	bool _get(const godot::StringName &p_name, godot::Variant &r_value) const;
	void _get_property_list(godot::List<godot::PropertyInfo> *r_list) const;

private:
	// grass_field.cpp and _tick.cpp: the node's life cycle, its frames and its ticks
	void enter();
	void turn();
	std::vector<uint64_t> find_carriers() const;
	void leave();
	// Called from the message queue, where the engine lets a node die: shared/script_call.h. Those that return bool return whether the node
	// still exists.
	void _before_draw();
	bool advance();
	bool can_rest(std::vector<RestingBody> &r_bodies) const;
	float find_share() const;
	bool is_listened_to() const;
	bool update_plants();
	void _plants_left();
	void emit_visits();
	void emit_leaving();
	bool emit_for_each(const char *p_signal, const std::vector<uint64_t> &p_bodies);
	void _body_woke(int64_t p_body);
	void _body_changed(int64_t p_status, const godot::RID &p_body, int64_t p_instance_id, int64_t p_body_shape, int64_t p_area_shape);
	void _area_changed(int64_t p_status, const godot::RID &p_area, int64_t p_instance_id, int64_t p_other_shape, int64_t p_own_shape);

	// grass_field_changes.cpp and _warnings.cpp: what a change of properties, species, map or fill rule sets going
	void request_rebuild();
	bool stand() override { return _life.stand(); }
	bool read_scene() override;
	void update_map();
	void show_terrain_texture(const godot::Ref<godot::Texture2D> &p_texture, const godot::Ref<godot::Texture2D> &p_colors);
	bool is_map_bare() const;
	void watch_bare_map();
	bool start_fill();
	bool update_fill();
	FieldFiller::Place fill_place() const;
	void report_warnings() override;
	void _species_changed();
	void _map_changed(const godot::TypedArray<godot::Vector2i> &p_chunks, const godot::Rect2 &p_region);
	void _fill_rule_changed();
	void _fill_pressed();

	// grass_field_hook.cpp
	void compile_hook();
	godot::String no_uniform(const char *p_call, const godot::StringName &p_name) const; // for messages
	void _hook_changed();

	// grass_field_terrain.cpp
	bool update_terrain();
	void _terrain_edited(const godot::AABB &p_area);
	void _terrain_replaced();
	void _terrain_rectangle_changed(const godot::Rect2 &p_cells);
	void _terrain_cells_changed(double p_x, double p_y, double p_width, double p_height, int64_t p_channel);

	// grass_field_queries.cpp and _methods.cpp
	const godot::Node3D &as_node() const override { return *this; }
	GrassMap *need_map(const char *p_method) override;
	bool prepare_places();
	GrassField *find_other(const godot::Vector3 &p_global_position) const;
	godot::PackedVector3Array find_knots(std::span<const BladeNumber> p_blades, FieldPlaces::Knots p_knots);
	FieldPlaces places() const { return FieldPlaces(_standing, field_transform(), _properties.ground_band()); }
	bool has_blades() const;
	bool has_tile(const godot::Vector2i &p_tile) const;
	bool has_blades_of(const godot::PackedInt64Array &p_blades) const;
	FieldStatistics find_statistics() const;
	godot::String label() const override;
	godot::String message(const godot::String &p_text) const override;

	FieldProperties _properties;
	StandingField _standing{ _properties };
	FieldLife _life{ *this, *this, _properties, _standing };
	FieldFiller _filler{ *this };
	FieldTerrain _terrain{ *this };
	OtherLight _other_light;
	FieldBodies _bodies;
	FieldForces _forces{ *this };
	PlantNodes _plants{ *this, *this };
	FieldWork _work{ *this, _standing, _properties };

	uint64_t _advanced_in = UINT64_MAX; // the frame of the last advance()
	bool _rests = false, _frame_rests = false; // until stir(): in ticks; in frames
	int64_t _visited_ticks = 0, _visited_frames = 0;
	BodyReads _shared_reads;
	uint64_t _world = 0; // its instance id
	bool _has_own_species = false; // the first one was made for a property that is a species' now
	void warn(const godot::String &p_warning) const;
	WarningTeller _warning_teller;
	mutable bool _has_reported = false; // whether message() has included version and device
	godot::PackedStringArray _warned_of; // in the console, when the field was made
	bool _is_map_bare = false; // as last reported to the editor
	UndrawnTicks _undrawn;
	uint64_t _moved_in = UINT64_MAX; // the physics tick in which a step last moved blades; none if they are drawn without interpolation
	double _gather_ms = 0.0, _plants_ms = 0.0,
		   _frame_ms = 0.0; // CPU time: of reading bodies and of plants in the last tick; of the last frame
};

} // namespace grass

VARIANT_ENUM_CAST(grass::GrassField::SolverMethod);
VARIANT_ENUM_CAST(grass::GrassField::SimulationDetail);
VARIANT_ENUM_CAST(grass::GrassField::SleepMode);
VARIANT_ENUM_CAST(grass::GrassField::BackendMode);
VARIANT_ENUM_CAST(grass::GrassField::DebugView);
