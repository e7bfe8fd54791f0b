// SPDX-License-Identifier: MIT
// A map laid out for a field: for each chunk, one layer of texels that determine what grows there, combined from all channels, with a
// border of one texel so that a layer can be sampled by itself; and the cover of each tile. The shaders read textures of these bytes; the
// simulation samples the same bytes. It is laid out chunk by chunk, so that a large change can be spread over frames.
#pragma once

#include "core/map/growth.h"
#include "core/map/map_layer.h"
#include "core/map/tile_cover.h"

#include <map>
#include <memory>
#include <vector>

namespace grass {

// The properties of a field that determine how a map is laid out for it and drawn.
struct MapPlace {
	TileGrid grid;
	// Metres, of the longest blade. Uncut grass counts as cut at this length, so that the blend between it and a cut beside it lies where
	// blades are.
	double tallest = MAP_UNCUT;
	float follow = 0.0f; // FOLLOW_SLOPE
	bool has_species = false; // several, so that its shaders read which of them is painted
	float sparse_height = float(SPARSE_HEIGHT.initial);
	bool operator==(const MapPlace &) const = default;
};

class MapLayers {
public:
	MapLayers() = default; // of no field, until read()
	// Makes the whole map wait to be laid out.
	explicit MapLayers(const MapPlace &p_place);
	// It is only moved, since others share the cover.
	MapLayers(MapLayers &&) = default;
	MapLayers &operator=(MapLayers &&) = default;

	// Queues a region whose texels changed.
	void touch(const MapRegion &p_region);
	// Queues everything in which p_now differs from p_before, which these layers are of.
	void touch(const PaintMap &p_before, const PaintMap &p_now);
	struct Changes {
		std::vector<int> layers; // that look different now, in no order
		TileRange tiles; // that may have changed
		void add(const Changes &p_changes);
	};
	// Lays out one of the waiting chunks, if any. Chunks get layers in order of arrival.
	Changes work(const PaintMap &p_map);
	// Lays out a region, and all waiting chunks, at once.
	Changes update(const PaintMap &p_map, const MapRegion &p_region);
	int get_waiting() const { return int(_waiting.size()); } // chunks
	bool is_waiting_at(const Eigen::Vector2f &p_place) const; // field-space x, z in metres

	// Becomes the layers of p_map as it is now on a field, but only around p_at (field-space x, z in metres), and without cover. Its memory
	// is reused.
	void read(const PaintMap &p_map, const MapPlace &p_place, const Eigen::Vector2f &p_at);

	const MapPlace &get_place() const { return _place; }
	MapRegion get_region() const { return MapRegion::of_grid(_place.grid); } // the whole field
	const std::shared_ptr<TileCover> &get_cover() const { return _cover; } // null after read()
	int count_painted(const PaintMap &p_map) const; // chunks under the field that have or get a layer
	size_t get_memory_usage() const; // bytes

	int get_count() const { return int(_layers.size()); }
	const MapLayer &get_layer(int p_layer) const { return _layers[size_t(p_layer)]; }
	bool is_full() const { return _is_full; } // chunks were left out
	float get_base_density() const { return _base_density; }
	const GroundGrid &get_ground_grid() const { return _ground_grid; }

	// The chunks under the field: the first one, how many along x and z, and each one's layer or GRASS_NO_LAYER, row by row.
	MapKey get_first() const { return _first; }
	int get_width() const { return _width; }
	int get_depth() const { return _depth; }
	const std::vector<float> &get_pages() const { return _pages; }
	// Returns the layers with ledges, in the order in which they got them.
	const std::vector<int> &get_ledge_layers() const { return _ledge_layers; }

	bool has_chunk(const MapKey &p_key) const; // under the field
	int find(const MapKey &p_key) const; // the chunk's layer or GRASS_NO_LAYER
	std::vector<MapKey> get_chunks(const MapRegion &p_region) const; // under the field, that show a change of p_region; row by row
	// How much farther out a change is visible, in metres: in the borders of layers, and where coarse texels blend into finer ones.
	static constexpr double CHANGE_MARGIN = 2.0 * info_of(MAP_HEIGHT).texel_size();

	// Returns what grows at a place: field-space x, z in metres.
	Growth sample(const Eigen::Vector2f &p_place) const;
	// Returns the species painted into a texel, counted from the map's origin: 0: none, n: species n - 1.
	int get_species(int p_texel_x, int p_texel_z) const;

private:
	size_t index_of(const MapKey &p_key) const { return size_t(p_key.z - _first.z) * size_t(_width) + size_t(p_key.x - _first.x); }
	void begin(const MapPlace &p_place);
	Growth read_texels(const Eigen::Vector2f &p_place) const; // sample() as it was painted
	int add_layer(const MapKey &p_key);
	void follow(const PaintMap &p_map);
	int lay_out(const PaintMap &p_map, const MapKey &p_key, const MapRegion &p_region);

	MapPlace _place;
	MapKey _first;
	int _width = 0, _depth = 0;
	bool _is_full = false;
	int32_t _uncut = MAP_UNCUT_CODE; // code of cuts that cut nothing
	float _base_density = 0.0f;
	GroundGrid _ground_grid;
	std::vector<float> _pages;
	std::vector<MapLayer> _layers;
	std::vector<int> _ledge_layers;
	std::shared_ptr<TileCover> _cover;
	std::map<std::pair<int, int>, MapRegion> _waiting; // by chunk, row by row (z, x): the waiting part of it, and a little around
};

} // namespace grass
