// SPDX-License-Identifier: MIT
// A map laid out on a field: what each of its tiles and blades makes of it. Lives as long as the field is built.
#pragma once

#include "core/map/tile_cover.h"
#include "core/patch.h"
#include "core/step.h"

#include <memory>

namespace grass {

class FieldMap {
public:
	// p_follow: FOLLOW_SLOPE.
	FieldMap(const TileGrid &p_grid, std::shared_ptr<const Patch> p_patch, const ClumpParams &p_clump, float p_follow);

	struct Changes {
		std::vector<int> layers; // that look different now, rising
		TileRange tiles; // that may have changed
	};
	// Takes over what p_map says about a region.
	Changes update(const PaintMap &p_map, const MapRegion &p_region);
	MapRegion get_region() const { return MapRegion::of_grid(_grid); } // the whole field

	// How blade p_blade of the patch grows in a tile, and the ground below it.
	struct BladePose {
		Clump clump;
		float ground = 0.0f; // metres above the field
		float density = 0.0f;
	};
	BladePose get_pose(int p_tile_x, int p_tile_z, int p_blade) const;
	// The same for all blades of an awake tile, as the simulation takes it.
	SlotGrowth grow(const GrassSlot &p_slot) const;

	const MapLayers &get_layers() const { return _layers; }
	const std::shared_ptr<TileCover> &get_cover() const { return _cover; }
	float get_follow() const { return _follow; }
	size_t get_memory_usage() const; // bytes

private:
	TileGrid _grid;
	std::shared_ptr<const Patch> _patch;
	ClumpParams _clump;
	float _follow;
	MapLayers _layers;
	std::shared_ptr<TileCover> _cover = std::make_shared<TileCover>();
};

} // namespace grass
