// SPDX-License-Identifier: MIT
// A field's terrain. Queries heights, holes, textures and colours, some places in each frame, nearest to a camera first, and lays them into
// the map. Notices what changes.
#pragma once

#include "core/field/field_statistics.h"
#include "ground/shown_colors.h"
#include "ground/terrain_share.h"
#include "ground/terrain_source.h"
#include "resources/grass_map.h"
#include "shared/script_call.h"

#include <godot_cpp/classes/visual_instance3d.hpp>
#include <godot_cpp/variant/node_path.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace grass {

// Methods of a terrain and listeners of the map are scripts: see shared/script_call.h. Functions marked [[nodiscard]] return false if a
// script freed the field, and this object with it.
class FieldTerrain {
public:
	explicit FieldTerrain(godot::VisualInstance3D &p_field) : _node(p_field) {}

	void set_path(const godot::NodePath &p_path);
	void look_soon() { _frames_to_look = _source ? _frames_to_look : 0; } // for a terrain that was not found
	const godot::NodePath &get_path() const { return _path; }

	// Must be called first in each frame: finds the terrain and what has changed in it. The field must be in the tree. p_transform: of the
	// field, global, without scale; p_region: the area that it covers.
	[[nodiscard]] bool look(const godot::Transform3D &p_transform, const MapRegion &p_region, const TerrainSource::Handlers &p_handlers);
	// Returns whether look() found a terrain that can be read now; false while it is being read.
	bool can_read() const { return _can_read && _source != nullptr && !_is_asking; }
	// Reads a frame's share, and lays what is complete into the map. Must be called after look(). p_touched: called for every region whose
	// textures changed.
	[[nodiscard]] bool read(godot::Ref<GrassMap> p_map, double p_ledge_slope, const std::function<void(const MapRegion &)> &p_touched);

	// Report a change: in an area (global; empty: everywhere), or everywhere.
	void area_changed(const godot::AABB &p_area);
	void anything_changed() { _is_all_changed = true; }
	[[nodiscard]] bool cells_changed(const godot::Vector2 &p_first, const godot::Vector2 &p_count);
	// Must be called for another map: everything is laid again. p_is_elsewhere: the field also moved to another place, so no colours are
	// known.
	void read_all(bool p_is_elsewhere);
	// Must be called when the field leaves the tree.
	void leave();

	// Returns the textures; null where no terrain reports any.
	std::shared_ptr<const TerrainIds> get_ids() const { return _ids; }
	// Returns the terrain's colours over the field; null where it reports none.
	const godot::Ref<godot::ImageTexture> &get_colors() const { return _colors.get_texture(); }
	bool is_found() const { return _source != nullptr; }
	void warn(godot::PackedStringArray &r_warnings) const;
	// Returns whether warn() has changed since the last call.
	bool has_new_warning();
	void add_to(FieldStatistics &r_statistics) const;
	int64_t get_memory_usage() const; // bytes

private:
	// Runs p_ask, which calls methods of the terrain. The field makes no other calls to the terrain until this returns.
	template <typename F> bool ask(F &&p_ask) {
		const bool was_asking = std::exchange(_is_asking, true); // such a method may report a change, which calls another one
		if (!outlives(_node, p_ask)) {
			return false;
		}
		_is_asking = was_asking;
		return true;
	}
	bool find(const TerrainSource::Handlers &p_handlers);
	void listen(const TerrainSource::Handlers &p_handlers);
	void forget();
	bool watch_place(const godot::Transform3D &p_transform, const MapRegion &p_region);
	void take_changes();
	bool take_grid(const godot::Ref<GrassMap> &p_map);
	bool begin_piece(const GroundGrid &p_grid, std::vector<Eigen::Vector2d> &r_eyes);
	bool read_places();
	bool lay(const godot::Ref<GrassMap> &p_map, double p_ledge_slope, const std::function<void(const MapRegion &)> &p_touched);

	godot::VisualInstance3D &_node; // the field
	godot::NodePath _path;
	std::shared_ptr<TerrainSource> _source; // null: not found
	bool _can_read = false; // see can_read()
	bool _is_asking = false; // a method of the terrain is running, and may call the field
	std::vector<TerrainSource::Notice> _notices; // connected
	godot::String _problem, _warned; // with the terrain
	godot::Transform3D _field; // global
	std::optional<godot::Transform3D> _beside, _beside_when_read; // the field as the terrain sees it: at the last look; when it was read
	MapRegion _region; // the area that the field covers
	TerrainQueue _queue;
	std::optional<TerrainPiece> _piece; // being read
	std::shared_ptr<TerrainIds> _ids;
	ShownColors _colors;
	TerrainShare _share;
	std::vector<godot::AABB> _areas; // changed since the last frame, global
	bool _is_all_changed = false;
	bool _is_grid_due = false; // all is going to be read, so the ground may get another grid
	int _frames_to_look = 0;
	int64_t _calls_before = 0; // of terrains before this one
};

} // namespace grass
