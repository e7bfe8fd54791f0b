// SPDX-License-Identifier: MIT
// Writes a field's map besides a game: lays the terrain into it, and fills it by the rule.
#pragma once

#include "field/field_host.h"
#include "field/field_settings.h"
#include "ground/field_filler.h"
#include "ground/field_terrain.h"

#include <godot_cpp/classes/camera3d.hpp>

#include <string_view>

namespace grass {

// Functions marked [[nodiscard]] return false if a script freed the field: see shared/script_call.h.
class FieldSources {
public:
	FieldSources(FieldHost &p_host, const FieldProperties &p_properties, const StandingField &p_standing, FieldSettings &p_settings) :
			_host(p_host),
			_properties(p_properties),
			_standing(p_standing),
			_settings(p_settings),
			_filler(p_host.node()),
			_terrain(p_host.node()) {}

	void set_terrain(const godot::NodePath &p_path); // empty: none
	godot::NodePath get_terrain() const { return value_of(_terrain.get_path()); }
	void terrain_changed(const godot::AABB &p_area); // global; empty: everywhere
	void set_fill_live(bool p_live);
	bool is_fill_live() const { return _filler.is_live(); }
	godot::Ref<GrassFillRule> get_fill_rule() const { return value_of(_filler.get_rule()); }
	// Sets the rule. p_changed must call rule_changed(). Null: removes what the rule filled.
	void set_fill_rule(const godot::Ref<GrassFillRule> &p_rule, const godot::Callable &p_changed);
	void rule_changed();
	// Return the square metres of full grass added.
	double fill(const godot::Ref<GrassFillRule> &p_rule);
	double fill_whole(const godot::Ref<GrassFillRule> &p_rule); // for the editor: however large the field is
	// Explains why there is no grass, or less than there could be. p_camera: null: the viewport's. p_other: another field with ground at
	// the place, or null.
	godot::Dictionary explain(const godot::Vector3 &p_global, const godot::Camera3D *p_camera, godot::Node3D *p_other);

	// Sets what is called when a terrain changes. Must be called before the first update_terrain().
	void set_handlers(const TerrainSource::Handlers &p_handlers) { _handlers = p_handlers; }
	// Must be called once in each frame, and for a field that is to be made: reads the terrain and lays what it has read.
	[[nodiscard]] bool update_terrain();
	// Begins to fill. A field that enters the tree is filled before its first frame, others gradually.
	[[nodiscard]] bool start_fill();
	// Goes on filling. Must be called once in each frame. r_has_finished: in this frame.
	[[nodiscard]] bool update_fill(bool &r_has_finished);
	bool may_change() const { return _filler.may_fill(); } // update_fill() may have something to do in the next frames
	FieldTerrain &get_terrain_reader() { return _terrain; }

	void forget_map(); // must be called for another map
	// Must be called when the map changed, see GrassMap.
	void map_changed(const godot::TypedArray<godot::Vector2i> &p_chunks);
	bool is_map_bare() const; // no grass grows on it, and no rule will fill it
	void leave() { _terrain.leave(); } // must be called when the field leaves the tree
	bool hides(std::string_view p_property) const; // from the inspector: it has nothing to do
	// Append warnings: about the map; about the rule and the terrain.
	void warn_of_map(godot::PackedStringArray &r_warnings) const;
	void warn(godot::PackedStringArray &r_warnings) const;
	void add_to(FieldStatistics &r_statistics) const;
	int64_t get_memory_usage() const { return _terrain.get_memory_usage(); } // bytes

private:
	FieldFiller::Place place() const;
	void watch_bare_map();

	FieldHost &_host;
	const FieldProperties &_properties;
	const StandingField &_standing;
	FieldSettings &_settings;
	TerrainSource::Handlers _handlers;
	FieldFiller _filler;
	FieldTerrain _terrain;
	bool _is_map_bare = false; // as last shown in the editor
};

} // namespace grass
