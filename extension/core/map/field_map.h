// SPDX-License-Identifier: MIT
// A map laid out on a field: its layers, and what each tile makes of them. Lives as long as the field is built.
#pragma once

#include "core/map/tile_cover.h"

#include <memory>

namespace grass {

class FieldMap {
public:
	// p_tallest: metres, of the longest blade; p_follow: FOLLOW_SLOPE.
	FieldMap(const TileGrid &p_grid, double p_tallest, float p_follow);

	struct Changes {
		std::vector<int> layers; // that look different now, rising
		TileRange tiles; // that may have changed
	};
	// Takes over what p_map says about a region.
	Changes update(const PaintMap &p_map, const MapRegion &p_region);
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
};

} // namespace grass
