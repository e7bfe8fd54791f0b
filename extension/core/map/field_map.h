// SPDX-License-Identifier: MIT
// A map laid out on a field: its layers, and the cover of each tile. It is updated chunk by chunk, so that a large change can be spread
// over frames.
#pragma once

#include "core/map/tile_cover.h"

#include <map>
#include <memory>

namespace grass {

class FieldMap {
public:
	// Makes the whole map wait to be laid out. p_tallest: metres, of the longest blade; p_follow: FOLLOW_SLOPE.
	FieldMap(const TileGrid &p_grid, double p_tallest, float p_follow);

	// Queues a region whose texels changed.
	void touch(const MapRegion &p_region);
	struct Changes {
		std::vector<int> layers; // that look different now, in no order
		TileRange tiles; // that may have changed
		void add(const Changes &p_changes);
	};
	// Lays out one of the waiting chunks, if any.
	Changes work(const PaintMap &p_map);
	// Lays out a region, and all waiting chunks, at once.
	Changes update(const PaintMap &p_map, const MapRegion &p_region);

	int get_waiting() const { return int(_waiting.size()); } // chunks
	bool is_waiting_at(const Eigen::Vector2f &p_place) const; // field-space x, z in metres
	int count_painted(const PaintMap &p_map) const; // chunks under the field that have or get a layer
	MapRegion get_region() const { return MapRegion::of_grid(_grid); } // the whole field

	const MapLayers &get_layers() const { return _layers; }
	const std::shared_ptr<TileCover> &get_cover() const { return _cover; }
	float get_follow() const { return _follow; }
	size_t get_memory_usage() const; // bytes

private:
	TileGrid _grid;
	float _follow;
	MapLayers _layers;
	std::shared_ptr<TileCover> _cover = std::make_shared<TileCover>();
	std::map<std::pair<int, int>, MapRegion> _waiting; // by chunk, row by row (z, x): the waiting part of it, and a little around
};

} // namespace grass
