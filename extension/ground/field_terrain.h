// SPDX-License-Identifier: MIT
// A field's terrain. Queries it for heights, holes, textures and colours, some places a frame, nearest to a camera first, and lays them
// into the map. Notices what changes.
#pragma once

#include "core/field/field_statistics.h"
#include "draw/frame_share.h"
#include "ground/terrain_source.h"
#include "resources/grass_map.h"
#include "shared/script_call.h"

#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/node_path.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

#include <functional>
#include <memory>
#include <optional>

namespace grass {

// Methods of a terrain and listeners of the map are scripts: see shared/script_call.h. What says so returns false where one of them freed
// the field, and this with it.
class FieldTerrain {
public:
	explicit FieldTerrain(godot::VisualInstance3D &p_field) : _node(p_field) {}

	void set_path(const godot::NodePath &p_path);
	void look_soon() { _frames_to_look = _source ? _frames_to_look : 0; } // for a terrain that was not found
	const godot::NodePath &get_path() const { return _path; }

	// Once a frame, first: finds the terrain, and what has changed of it. The field is in the tree; p_transform: of it, global, without
	// scale; p_region: what it covers.
	[[nodiscard]] bool look(const godot::Transform3D &p_transform, const MapRegion &p_region, const TerrainSource::Handlers &p_handlers);
	// Whether look() found a terrain that can be read now: not while it is being read.
	bool can_read() const { return _can_read && _source != nullptr && !_is_asking; }
	// Then: reads a frame's share, and lays what is complete into the map. p_touched: called for every region whose textures are others.
	[[nodiscard]] bool read(godot::Ref<GrassMap> p_map, double p_ledge_slope, const std::function<void(const MapRegion &)> &p_touched);

	// Something changed: everything (an empty area), or the area (global).
	void area_changed(const godot::AABB &p_area);
	void anything_changed() { _is_all_changed = true; }
	[[nodiscard]] bool cells_changed(const godot::Vector2 &p_first, const godot::Vector2 &p_count);
	// Another map: all is laid again. p_is_elsewhere: and the field serves another place, so that no colours are known.
	void read_all(bool p_is_elsewhere);
	// The field leaves the tree.
	void leave();

	// Null where no terrain reports textures.
	std::shared_ptr<const TerrainIds> get_ids() const { return _ids; }
	// The terrain's colours over the field; null where it reports none.
	const godot::Ref<godot::ImageTexture> &get_colors() const { return _shown_colors; }
	bool is_found() const { return _source != nullptr; }
	void warn(godot::PackedStringArray &r_warnings) const;
	// Whether warn() has changed since the last call.
	bool has_new_warning();
	void add_to(FieldStatistics &r_statistics) const;
	int64_t get_memory_usage() const; // bytes

private:
	// Runs p_ask, which calls methods of the terrain. Until it returns, the field asks nothing more of it.
	template <typename F> bool ask(F &&p_ask) {
		_is_asking = true;
		if (!outlives(_node, p_ask)) {
			return false;
		}
		_is_asking = false;
		return true;
	}
	bool find(const TerrainSource::Handlers &p_handlers);
	void listen(const TerrainSource::Handlers &p_handlers);
	void forget();
	bool watch_place(const godot::Transform3D &p_transform, const MapRegion &p_region);
	void take_changes();
	bool begin_piece(std::vector<Eigen::Vector2d> &r_eyes);
	bool read_places();
	bool may_go_on(bool p_is_first, int64_t p_begun, uint64_t p_since, FrameShare::Turn &r_turn) const;
	void show_colors();
	bool lay(const godot::Ref<GrassMap> &p_map, double p_ledge_slope, const std::function<void(const MapRegion &)> &p_touched);

	godot::VisualInstance3D &_node; // the field
	godot::NodePath _path;
	std::shared_ptr<TerrainSource> _source; // null: not found
	bool _can_read = false; // see can_read()
	bool _is_asking = false; // a method of the terrain runs, and may call the field
	std::vector<TerrainSource::Notice> _notices; // connected
	godot::String _problem, _warned; // with the terrain
	godot::Transform3D _field; // global
	std::optional<godot::Transform3D> _beside, _beside_when_read; // the field as the terrain sees it: at the last look; when it was read
	MapRegion _region; // what the field covers
	TerrainQueue _queue;
	std::optional<TerrainPiece> _piece; // being read
	std::vector<Eigen::Vector2d> _row; // of it, being read
	std::vector<TerrainSample> _row_samples; // of the first places of _row
	std::shared_ptr<TerrainIds> _ids;
	std::optional<TerrainColors> _colors;
	godot::Ref<godot::ImageTexture> _shown_colors;
	bool _has_old_colors = false; // it shows those of another place
	std::vector<godot::AABB> _areas; // that changed since the last frame, global
	bool _is_all_changed = false;
	int _frames_to_look = 0;
	uint64_t _frame = UINT64_MAX; // the process's, in which queries were last counted
	int64_t _last_query = 0; // of that frame
	int64_t _queries = 0, _calls_before = 0; // places queried so far; calls of terrains before this one
};

} // namespace grass
