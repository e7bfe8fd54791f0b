// SPDX-License-Identifier: MIT
// GrassField: the node. Holds properties and passes things on: bodies -> tiles -> backend in a physics tick,
// camera -> backend in a frame. No maths here.
#pragma once

#include "backend/backend.h"
#include "core/fill/live_fill.h"
#include "core/plants/field_blades.h"
#include "core/tiles/tiles.h"
#include "draw/ground.h"
#include "nodes/body_tracker.h"
#include "nodes/field_monitors.h"
#include "nodes/field_params.h"
#include "nodes/fill_gatherer.h"
#include "nodes/grass_map.h"
#include "nodes/grass_patch.h"
#include "nodes/grass_species.h"
#include "nodes/ground_rays.h"
#include "nodes/node_colliders.h"
#include "nodes/shown_map.h"

#include <godot_cpp/classes/geometry_instance3d.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace grass {

class GrassField : public godot::GeometryInstance3D {
	GDCLASS(GrassField, godot::GeometryInstance3D)

public:
	enum SolverMethod : int64_t {
		METHOD_DIRECT = int(Method::DIRECT),
		METHOD_PBD = int(Method::PBD),
	};
	enum SleepMode : int64_t {
		SLEEP_TIMER = int(grass::SleepMode::TIMER),
		SLEEP_ENERGY = int(grass::SleepMode::ENERGY),
	};
	enum BackendMode : int64_t {
		BACKEND_AUTO, // GPU where the renderer has a RenderingDevice, else CPU
		BACKEND_CPU,
	};
	enum DebugView : int64_t {
		DEBUG_VIEW_OFF = GRASS_DEBUG_OFF,
		DEBUG_VIEW_AWAKE_TILES = GRASS_DEBUG_AWAKE,
		DEBUG_VIEW_LOD = GRASS_DEBUG_LOD,
	};

	GrassField();

	void set_size(const godot::Vector2 &p_size); // metres along x and z
	godot::Vector2 get_size() const { return _size; }
	void set_patch(const godot::Ref<GrassPatch> &p_patch); // null: the default patch
	godot::Ref<GrassPatch> get_patch() const { return _patch; }
	void set_map(const godot::Ref<GrassMap> &p_map); // null: grass stands everywhere
	godot::Ref<GrassMap> get_map() const { return _map; }
	void set_species(const godot::TypedArray<GrassSpecies> &p_species); // none: the field's own patch and properties
	godot::TypedArray<GrassSpecies> get_species() const;
	// grass_field_fill.cpp
	void set_fill_rule(const godot::Ref<GrassFillRule> &p_rule); // null: takes back what it filled
	godot::Ref<GrassFillRule> get_fill_rule() const { return _fill.rule; }
	void set_fill_live(bool p_live);
	bool is_fill_live() const { return _fill.is_live; }
	double fill(const godot::Ref<GrassFillRule> &p_rule); // square metres of full grass that came
	godot::Callable get_fill_button() const;
	void set_seed(int64_t p_seed);
	int64_t get_seed() const { return _seed; }
	void set_simulated(bool p_simulated);
	bool is_simulated() const { return _simulated; }
	void set_method(SolverMethod p_method);
	SolverMethod get_method() const { return _solver_method; }
	void set_sleep_mode(SleepMode p_mode);
	SleepMode get_sleep_mode() const { return _sleep_mode; }
	void set_backend(BackendMode p_mode);
	BackendMode get_backend() const { return _backend_mode; }
	void set_pool_tiles(int64_t p_tiles);
	int64_t get_pool_tiles() const { return _pool_tiles; }
	void set_collision_mask(int64_t p_mask);
	int64_t get_collision_mask() const { return _collision_mask; }
	void set_ground(bool p_ground) { _has_ground = p_ground; }
	bool has_ground() const { return _has_ground; }
	void set_debug_view(DebugView p_view);
	DebugView get_debug_view() const { return _debug_view; }
	void set_measure_time(bool p_measure);
	bool is_measuring_time() const { return _measure_time; }
	// Indexed properties: numbers (FIELD_PARAMS) and colours (FIELD_COLORS).
	void set_param(int64_t p_param, double p_value);
	double get_param(int64_t p_param) const;
	void set_color(int64_t p_index, const godot::Color &p_color);
	godot::Color get_color(int64_t p_index) const;

	// What is there. A tile is named by its column (along x) and row (along z).
	int64_t get_blade_count() const;
	godot::Vector2i get_tiles() const; // how many along x and z
	double get_tile_size() const; // metres
	godot::Vector2i get_tile_at(const godot::Vector3 &p_global_position) const; // (-1, -1) outside of the field
	godot::Vector3 get_tile_center(const godot::Vector2i &p_tile) const; // global
	bool is_tile_awake(const godot::Vector2i &p_tile) const;
	int64_t get_awake_tile_count() const;
	// Global positions of a blade's 16 knots from root to tip, without wind. Of an awake tile on the GPU: waits for it.
	godot::PackedVector3Array get_knots(const godot::Vector2i &p_tile, int64_t p_blade) const;
	godot::PackedVector3Array get_tile_knots(const godot::Vector2i &p_tile) const;
	int64_t get_blade_species(const godot::Vector2i &p_tile, int64_t p_blade) const; // its place in `species`
	int64_t get_body_count() const { return _tracker.body_count(); }
	int64_t get_memory_usage() const; // bytes
	static godot::String get_version(); // of the extension
	godot::Dictionary get_statistics() const;
	godot::Transform3D field_transform() const; // global, without scale
	double get_monitor(FieldMonitor p_monitor); // this field's share. Times are measured from the first question on

	// grass_field_game.cpp: what a game asks of the grass and does to it. Places are global.
	bool is_grass_at(const godot::Vector3 &p_global_position);
	double density_at(const godot::Vector3 &p_global_position); // share of the blades that stand, 0..1
	double height_at(const godot::Vector3 &p_global_position); // of the grass at rest, metres
	// How far the tips around are from rest, on average: global axes, shares of the blades' lengths.
	godot::Vector3 bend_at(const godot::Vector3 &p_global_position);
	godot::Dictionary cut(const godot::Ref<godot::Shape3D> &p_shape, const godot::Transform3D &p_transform);
	double get_mown_share(const godot::Ref<godot::Shape3D> &p_shape, const godot::Transform3D &p_transform);
	void regrow(double p_height, double p_wear, const godot::Ref<godot::Shape3D> &p_shape, const godot::Transform3D &p_transform);
	double paint(const godot::Ref<GrassBrush> &p_brush, const godot::Vector3 &p_from, const godot::Vector3 &p_to);
	double trample(const godot::Vector3 &p_global_position, double p_radius, double p_amount);
	void register_collider(godot::Node3D *p_node, const godot::Ref<godot::Shape3D> &p_shape);
	void unregister_collider(godot::Node3D *p_node);

	// grass_field_ground.cpp: reads the shape of the ground into the map, over a rectangle of places (field space, x and z in
	// metres) or, where that is empty, over the whole field. At how many places, one a metre, there is ground.
	int64_t bake_ground(const godot::Rect2 &p_region = godot::Rect2(), int64_t p_mask = GroundRays::ALL_LAYERS);
	int64_t bake_ground_from(const godot::Ref<godot::Shape3D> &p_shape, const godot::Transform3D &p_transform);

	godot::PackedStringArray _get_configuration_warnings() const override;
	godot::AABB _get_aabb() const override;

protected:
	static void _bind_methods();
	void _notification(int p_what);
	void _validate_property(godot::PropertyInfo &p_property) const;

private:
	struct GrownSpecies {
		godot::Ref<GrassSpecies> species;
		std::shared_ptr<const Patch> patch;
	};
	// The field that properties describe, as far as it is prepared. Nothing that runs reads it.
	struct Wanted {
		FieldSetup setup;
		std::vector<SpeciesParams> mix;
		std::vector<GrownSpecies> species;
		std::shared_ptr<TileBounds> bounds; // null: not prepared yet
		std::unique_ptr<ShownMap> map; // null: none, or not begun yet
	};
	// The field that runs. Tiles, backend and picture read this, never a property that remakes the field: what that says may differ
	// until the field is made again.
	struct Standing : Wanted {
		FieldBlades blades;
	};

	// In the newest frame known, in the picture and in shadows.
	struct Drawn {
		std::array<int64_t, 2> tiles{}, triangles{};
	};

	// A rule that keeps the map filled.
	struct FieldFill {
		godot::Ref<GrassFillRule> rule;
		bool is_live = true;
		LiveFill state; // not set: nothing filled yet
		FillGatherer gatherer;
		bool has_changed = false; // the rule, since it was looked at
		bool is_filling = false; // the map changes by the field's own doing
		uint64_t revision = 0; // of the exclusion nodes, when looked at
		bool has_finished = false; // to be told
		uint64_t replacements = 0; // of the map's contents, as far as known
		double base_density = 0.0; // of the map, as far as known
		int frames_to_look = 0;
		int64_t cells = 0; // texels that rules were asked about, in all
	};

	// grass_field.cpp: the field's life and its ticks
	void enter();
	bool belongs_here() const;
	void leave();
	void physics_tick(double p_delta);
	void choose_method();
	void step(double p_delta);
	void frame(double p_delta);
	void follow();
	void _before_draw();
	FieldView find_view();
	void watch_room();
	bool look(const FieldView &p_view);
	bool is_listened_to() const;
	void _body_changed(int64_t p_status, const godot::RID &p_body, int64_t p_instance_id, int64_t p_body_shape, int64_t p_area_shape);
	void _patch_changed();
	// grass_field_making.cpp: from properties to a field
	void request_rebuild();
	void build();
	void make();
	bool prepare(bool p_in_parts);
	bool prepare_patches() const;
	bool prepare_map(bool p_in_parts);
	Wanted find_wanted() const;
	std::shared_ptr<TileBounds> find_bounds(const FieldSetup &p_next) const;
	void take_wanted();
	void make_backend();
	// grass_field_map.cpp
	void show_map();
	void update_map();
	bool is_map_bare() const;
	void watch_bare_map();
	void _map_changed(const godot::TypedArray<godot::Vector2i> &p_chunks, const godot::Rect2 &p_region);
	std::span<const SlotGrowth> grow_tiles();
	double ground_reach() const;
	double ground_range() const;
	// grass_field_species.cpp
	void _species_changed();
	std::vector<godot::Ref<GrassSpecies>> used_species() const;
	std::vector<SpeciesParams> species_mix() const;
	std::vector<double> species_shares() const;
	bool are_species_joined() const;
	std::vector<std::shared_ptr<const Patch>> species_patches() const;
	std::shared_ptr<const Patch> join_species() const;
	float card_size() const;
	std::span<const GrassStep> species_steps();
	double calm_energy() const;
	double calm_time() const; // of the species that swings longest, seconds
	double mean_height_at(const Eigen::Vector2f &p_place, const MapLayers *p_layers) const;
	RecoveryRates recovery_rates() const;
	void set_species_uniforms();
	void warn_of_species(godot::PackedStringArray &r_warnings) const;
	// grass_field_ground.cpp
	MapRegion bake_region(const godot::Rect2 &p_region) const;
	int64_t lay_ground_by(const MapRegion &p_region, const HeightAt &p_height);
	// grass_field_fill.cpp
	void _fill_rule_changed();
	void look_at_rule();
	void start_fill();
	void update_fill();
	void touch_fill(const godot::TypedArray<godot::Vector2i> &p_chunks);
	template <typename F> FillResult change_map(F &&p_change);
	void _fill_pressed();
	// grass_field_game.cpp
	void make_map();
	bool find_place(const godot::Vector3 &p_global, Eigen::Vector3d &r_place);
	const MapLayers *layers_at(const Eigen::Vector2f &p_place, MapLayers &r_own) const;
	std::array<ShownMap *, 2> shown_maps() const { return { _standing.map.get(), _wanted ? _wanted->map.get() : nullptr }; }
	const MapLayers *shown_layers() const { return _standing.map ? &_standing.map->get_field().get_layers() : nullptr; }
	Growth growth_at(const Eigen::Vector2f &p_place, const MapLayers *p_layers) const;
	GrassKind grass_kind() const;
	GrassMap *find_map(const char *p_method);
	bool find_region(const char *p_method, const godot::Ref<godot::Shape3D> &p_shape, const godot::Transform3D &p_transform,
			std::optional<Footprint> &r_footprint) const;
	MowRegion mow_region(const std::optional<Footprint> &p_footprint) const;
	void recover(double p_delta);
	void tell_of_bodies();
	void tell_of_leaving();
	void set_uniform(const godot::StringName &p_name, const godot::Variant &p_value);
	void set_all_uniforms();
	void request_draw();
	void set_wind_uniforms();
	void set_wind_clock();
	std::shared_ptr<const Patch> find_patch() const;
	TileGrid find_grid() const;
	bool has_blades() const;
	Drawn find_drawn(const BackendStatistics &p_backend) const;
	// Knots of p_count blades of the tile from p_first on, in the world.
	godot::PackedVector3Array find_knots(const godot::Vector2i &p_tile, int p_first, int p_count) const;
	SolverParams solver_params() const;
	TileParams tile_params() const;
	TileRange all_tiles() const;
	void update_tiles();
	godot::String label() const; // of this node, for messages
	godot::String message(const godot::String &p_text) const; // with what a report needs, the first time
	godot::String crowded_warning() const;
	double param(FieldParamId p_param) const { return _params[size_t(p_param)]; }

	godot::Vector2 _size{ 32, 32 };
	godot::Ref<GrassPatch> _patch;
	std::vector<godot::Ref<GrassSpecies>> _species; // may hold empty ones
	godot::Ref<GrassMap> _map;
	bool _is_map_bare = false; // as far as the editor was told
	int64_t _seed = 0, _pool_tiles = TileParams().pool_size, _collision_mask = 1;
	bool _simulated = true, _measure_time = false, _has_ground = true;
	SolverMethod _solver_method = SolverMethod(SolverParams().method);
	Method _method_now = SolverParams().method; // that the backend simulates by: another one's passes may have to be compiled first
	SleepMode _sleep_mode = SleepMode(TileParams().sleep_mode);
	BackendMode _backend_mode = BACKEND_AUTO;
	DebugView _debug_view = DEBUG_VIEW_OFF;
	std::array<double, FIELD_PARAMS.size()> _params;
	std::array<godot::Color, FIELD_COLORS.size()> _colors;

	bool _dirty = false; // the field must be made again; one that stands goes on as it is until prepare() has all it takes
	int64_t _makings = 0; // times that it was made again
	mutable bool _has_reported = false; // message() has named version and device
	godot::PackedStringArray _warned_of; // in the console, when it was made
	bool _is_crowded = false; // more tiles were seen, since it was made, than it has room for
	int64_t _builds = 0; // backends made
	bool _is_seen = true; // by a camera, in the last frame; where no frames are drawn, always
	double _unseen_time = 0.0; // seconds since it was, as far as ticks were left out
	int64_t _unseen_ticks = 0, _wind_updates = 0; // ticks left out; frames in which the wind's clock went to the materials
	bool _is_watched = false; // somebody reads the monitors of times
	WindClock _wind_clock;
	// CPU time, milliseconds: of the last tick (reading bodies, choosing tiles), of the last frame, of making the field
	// (the most that one frame had to do for it).
	double _gather_ms = 0.0, _tiles_ms = 0.0, _frame_ms = 0.0, _build_ms = 0.0;
	Standing _standing;
	std::optional<Wanted> _wanted; // once it is known what the properties make
	std::unique_ptr<Backend> _backend;
	Ground _ground;
	std::vector<GrassStep> _species_steps; // of this tick
	Cards _cards;
	mutable std::shared_ptr<const Patch> _joined; // of the species' patches and shares
	mutable std::vector<std::shared_ptr<const Patch>> _joined_from;
	mutable std::vector<double> _joined_shares;
	TileRange _regrown; // tiles below which the map changed since the last tick
	std::vector<SlotGrowth> _growth; // of this tick
	TileManager _tiles;
	StepClock _clock;
	BodyTracker _tracker;
	NodeColliders _node_colliders;
	std::vector<uint64_t> _in_grass; // instance ids of the bodies that met grass in the last tick, rising
	Recovery _recovery;
	FieldFill _fill;
	std::vector<ColliderShape> _colliders;
};

} // namespace grass

VARIANT_ENUM_CAST(grass::GrassField::SolverMethod);
VARIANT_ENUM_CAST(grass::GrassField::SleepMode);
VARIANT_ENUM_CAST(grass::GrassField::BackendMode);
VARIANT_ENUM_CAST(grass::GrassField::DebugView);
