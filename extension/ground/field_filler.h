// SPDX-License-Identifier: MIT
// Keeps a map filled by a rule or, without one, clear of the scene's GrassExclusion3D and GrassPath3D. Works over several frames, and only
// where something changed.
#pragma once

#include "core/base/tile_grid.h"
#include "core/field/field_statistics.h"
#include "core/fill/live_fill.h"
#include "ground/fill_gatherer.h"
#include "resources/grass_map.h"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/callable.hpp>

#include <optional>
#include <utility>

namespace grass {

// Listeners of the map are scripts: see shared/script_call.h. Functions marked [[nodiscard]] return false if a script freed the field, and
// this object with it.
class FieldFiller {
public:
	explicit FieldFiller(const godot::Node3D &p_field) : _node(p_field) {}

	// What to fill.
	struct Place {
		godot::Transform3D transform; // of the field: global, without scale
		MapRegion region; // its rectangle
		Eigen::Vector2d noise_origin; // metres, see FieldProperties
	};

	// Sets the rule. p_changed: called when the rule changes, or a mesh that it reads; it must call rule_changed(). Without a rule, removes
	// from p_map (may be null) what the last one filled.
	[[nodiscard]] bool set_rule(
			const godot::Ref<GrassFillRule> &p_rule, const godot::Callable &p_changed, const godot::Ref<GrassMap> &p_map);
	const godot::Ref<GrassFillRule> &get_rule() const { return _rule; }
	void set_live(bool p_live, const godot::Ref<GrassMap> &p_map);
	bool is_live() const { return _is_live; }
	bool has_live_rule() const { return _rule.is_valid() && _is_live; }
	// Returns whether a map must be filled: without a rule, once a node clears or plants some of p_place.
	bool is_needed(const Place &p_place);
	bool may_fill() const; // start() or update() may have something to do in the next frames
	bool is_set() const { return _state.is_set(); } // has begun to fill
	void rule_changed() {
		_has_changed = true;
		_gatherer.set_mesh_changed();
	}
	// Must be called for another map, in which nothing is filled yet.
	void forget_map() {
		_state = LiveFill();
		_maps++;
		_frames_to_look = 0;
	}

	// Reads the rule. p_at_once: fills the whole map by it.
	[[nodiscard]] bool start(godot::Ref<GrassMap> p_map, const Place &p_place, bool p_at_once);
	// Must be called once in each frame, after start().
	[[nodiscard]] bool update(godot::Ref<GrassMap> p_map, const Place &p_place);
	// Returns true once after filling has finished.
	bool take_finished() { return std::exchange(_has_finished, false); }
	// Must be called when others changed chunks of the map.
	void touch(const godot::Ref<GrassMap> &p_map, const godot::TypedArray<godot::Vector2i> &p_chunks);
	// Set the terrain's textures (null: none), and report that they changed in a region.
	void set_terrain(const std::shared_ptr<const TerrainIds> &p_ids);
	void touch_textures(const MapRegion &p_region) { _state.touch_textures(p_region); }
	// Fills by any rule, once. Returns the square metres of full grass added.
	double fill(godot::Ref<GrassMap> p_map, godot::Ref<GrassFillRule> p_rule, const Place &p_place);

	// Reads the meshes that the rule needs, which may be scripts. Must be called before gather().
	[[nodiscard]] bool read_meshes(const Place &p_place);
	// The rule that fills the map, and what it needs now; empty if the map is not filled, and outside of the tree.
	struct Gathered {
		FillRule rule;
		FillSources sources;
	};
	std::optional<Gathered> gather(const Place &p_place);
	godot::Node3D *find_node(const FillObstacle *p_obstacle) const; // from which it was gathered last; null: it no longer exists

	void warn(const godot::Ref<GrassMap> &p_map, bool p_has_terrain, godot::PackedStringArray &r_warnings) const;

	void add_to(FieldStatistics &r_statistics) const;

private:
	bool look(const Place &p_place);
	Gathered read(const Place &p_place);
	template <typename F> bool change(const godot::Ref<GrassMap> &p_map, FillResult &r_result, F &&p_change);
	bool work(const godot::Ref<GrassMap> &p_map, int p_chunks);

	const godot::Node3D &_node; // the field
	godot::Ref<GrassFillRule> _rule;
	godot::Ref<GrassFillRule> _no_rule; // for fields without one: fills by the base density, and gathers only nodes that need no rule
	bool _is_live = true;
	LiveFill _state; // not set: nothing is filled yet
	FillGatherer _gatherer;
	std::shared_ptr<const TerrainIds> _terrain;
	bool _has_changed = false; // whether the rule has, since it was last read
	bool _is_filling = false; // the field itself is changing the map
	uint64_t _revision = 0; // of exclusions and paths, when last read
	bool _has_finished = false; // since take_finished()
	uint64_t _maps = 0; // calls of forget_map(), by which look() notices one
	uint64_t _replacements = 0; // of the map's contents, as last seen
	double _base_density = 1.0; // of the map, as last seen
	int _frames_to_look = 0;
	int64_t _cells = 0; // number of texels on which rules have run
};

} // namespace grass
