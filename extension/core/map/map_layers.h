// SPDX-License-Identifier: MIT
// The map as a field shows it: for each chunk, one layer of texels that determine what grows there, combined from all channels, with a
// border of one texel so that a layer can be sampled by itself. The shaders read textures of these bytes; the simulation samples the same
// bytes.
#pragma once

#include "core/map/growth.h"
#include "core/map/map_layer.h"

#include <vector>

namespace grass {

class MapLayers {
public:
	// The chunks under a field, all without a layer. p_tallest: metres, of its longest blade. Uncut grass counts as cut at
	// this length: what is blended between it and a cut beside it then changes where blades are.
	void reset(const TileGrid &p_grid, double p_tallest = MAP_UNCUT);
	// Updates a chunk's layer in p_region. Returns the layer if it changed, else GRASS_NO_LAYER. Chunks get layers in order of arrival.
	int update(const PaintMap &p_map, const MapKey &p_key, const MapRegion &p_region);
	// Updates all layers in p_region. Returns those that changed, rising.
	std::vector<int> update(const PaintMap &p_map, const MapRegion &p_region);
	// Makes r_there the same field's layers of p_map as it is now, but around p_place only: field-space x, z in metres. The memory of
	// r_there is used again.
	void read(const PaintMap &p_map, const Eigen::Vector2f &p_place, MapLayers &r_there) const;

	int get_count() const { return int(_layers.size()); }
	const MapLayer &get_layer(int p_layer) const { return _layers[size_t(p_layer)]; }
	bool is_full() const { return _is_full; } // chunks were left out
	float get_base_density() const { return _base_density; }

	// The chunks under the field: the first one, how many along x and z, and each one's layer or GRASS_NO_LAYER, row by row.
	MapKey get_first() const { return _first; }
	int get_width() const { return _width; }
	int get_depth() const { return _depth; }
	const std::vector<float> &get_pages() const { return _pages; }
	// The layers that have ledges, in the order in which they got them.
	const std::vector<int> &get_ledge_layers() const { return _ledge_layers; }

	bool has_chunk(const MapKey &p_key) const; // under the field
	int find(const MapKey &p_key) const; // the chunk's layer or GRASS_NO_LAYER
	std::vector<MapKey> get_chunks(const MapRegion &p_region) const; // under the field, in which a change of p_region shows; row by row
	// How much farther out a change shows, in metres: in the borders of layers, and where coarse texels blend into finer ones.
	static constexpr double CHANGE_MARGIN = 2.0 * info_of(MAP_HEIGHT).texel_size();

	// Returns what grows at a place: field-space x, z in metres. p_follow: FOLLOW_SLOPE.
	Growth sample(const Eigen::Vector2f &p_place, float p_follow) const;
	// Returns the species painted into a texel, counted from the map's origin: 0: none, n: species n - 1.
	int get_species(int p_texel_x, int p_texel_z) const;

private:
	size_t index_of(const MapKey &p_key) const { return size_t(p_key.z - _first.z) * size_t(_width) + size_t(p_key.x - _first.x); }
	int add_layer(const MapKey &p_key);

	MapKey _first;
	int _width = 0, _depth = 0;
	bool _is_full = false;
	int32_t _uncut = MAP_UNCUT_CODE; // code of cuts that cut nothing
	float _base_density = 0.0f;
	std::vector<float> _pages;
	std::vector<MapLayer> _layers;
	std::vector<int> _ledge_layers;
};

} // namespace grass
