// SPDX-License-Identifier: MIT
// A field's terrain: asks it for heights, holes, textures and colours, some places a frame and the nearest to a camera first, and lays them
// into the map. Notices what changes.
#pragma once

#include "core/field/field_statistics.h"
#include "nodes/grass_map.h"
#include "nodes/terrain_source.h"

#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/node_path.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

#include <functional>
#include <memory>
#include <optional>

namespace grass {

class FieldTerrain {
public:
	void set_path(const godot::NodePath &p_path);
	const godot::NodePath &get_path() const { return _path; }

	// Once a frame, first: finds the terrain, and what has changed of it. p_field: in the tree; p_transform: of it, global, without scale;
	// p_region: what the field covers. True if there is a terrain to read.
	bool look(godot::Node3D &p_field, const godot::Transform3D &p_transform, const MapRegion &p_region,
			const TerrainSource::Handlers &p_handlers);
	// Then: reads a frame's share, and lays what is complete into the map. p_touched: called for every region whose textures are others.
	void read(const godot::Node3D &p_field, const godot::Ref<GrassMap> &p_map, double p_ledge_slope,
			const std::function<void(const MapRegion &)> &p_touched);

	// Something changed: everything (an empty area), or what lies in the area (global).
	void area_changed(const godot::AABB &p_area);
	void anything_changed() { _is_all_changed = true; }
	void cells_changed(const godot::Vector2 &p_first, const godot::Vector2 &p_count);
	// Another map: all is laid again. p_is_elsewhere: and the field serves another place, so that no colours are known.
	void read_all(bool p_is_elsewhere);
	// The field leaves the tree.
	void leave();

	// Null where no terrain tells textures.
	std::shared_ptr<const TerrainIds> get_ids() const { return _ids; }
	// The terrain's colours over the field; null where it tells none.
	const godot::Ref<godot::ImageTexture> &get_colors() const { return _shown_colors; }
	bool is_found() const { return _source != nullptr; }
	void warn(godot::PackedStringArray &r_warnings) const;
	// Whether warn() says something else than when last asked this.
	bool has_new_warning();
	void add_to(FieldStatistics &r_statistics) const;

private:
	void find(godot::Node3D &p_field, const TerrainSource::Handlers &p_handlers);
	void listen(const TerrainSource::Handlers &p_handlers);
	void forget();
	void watch_place(const godot::Transform3D &p_transform, const MapRegion &p_region);
	void take_changes();
	void read_row();
	void show_colors();
	void lay(const godot::Ref<GrassMap> &p_map, double p_ledge_slope, const std::function<void(const MapRegion &)> &p_touched);

	godot::NodePath _path;
	std::unique_ptr<TerrainSource> _source; // null: not found
	std::vector<TerrainSource::Notice> _notices; // connected
	godot::String _problem, _warned; // with the terrain
	godot::Transform3D _field; // global
	std::optional<godot::Transform3D> _beside, _beside_when_read; // the field as the terrain sees it: at the last look; when it was read
	MapRegion _region; // what the field covers
	TerrainQueue _queue;
	std::optional<TerrainPiece> _piece; // being read
	std::shared_ptr<TerrainIds> _ids;
	std::optional<TerrainColors> _colors;
	godot::Ref<godot::ImageTexture> _shown_colors;
	bool _has_old_colors = false; // it shows those of another place
	std::vector<godot::AABB> _areas; // that changed since the last frame, global
	bool _is_all_changed = false;
	int _frames_to_look = 0;
	uint64_t _frame = UINT64_MAX; // the process's, in which queries were last counted
	int64_t _last_query = 0; // of that frame
	int64_t _queries = 0, _calls_before = 0; // places asked so far; calls of terrains before this one
};

} // namespace grass
