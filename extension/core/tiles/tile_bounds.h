// SPDX-License-Identifier: MIT
// The box around a tile's blades at rest: what Algorithm 1 tests a body's box against. Much tighter than the longest
// overhang on all sides, and still only a few numbers for each of the 2,040 places where a tile may start in the patch.
#pragma once

#include "core/blades/clump.h"
#include "core/blades/patch.h"
#include "core/bodies/body_shape.h"
#include "core/map/tile_cover.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace grass {

class TileBounds {
public:
	// Without blades: no tile is ever met.
	TileBounds() = default;
	TileBounds(const Patch &p_patch, const TileGrid &p_grid, const ClumpParams &p_clump, uint32_t p_seed);
	// The same blades on another grid: much less work.
	TileBounds(const TileBounds &p_other, const TileGrid &p_grid);

	// A tile's place in the grid.
	struct Tile {
		uint16_t x = 0, z = 0;
	};
	// Whether p_bounds (field space, metres) meets the box around the blades of tile x, z.
	bool meets(int p_x, int p_z, const Bounds &p_bounds) const;
	// The same for all tiles of the range: writes those that are met, row by row, to r_tiles, which has room for all. Returns how many.
	int find_met(const TileRange &p_range, const Bounds &p_bounds, Tile *r_tiles) const;
	// The ground that the tiles stand on, and those that are bare; null: all stand on level ground. p_lean: metres by which
	// blades lean farther on slopes.
	void set_cover(std::shared_ptr<const TileCover> p_cover, double p_lean) {
		_cover = std::move(p_cover);
		_lean = p_lean;
	}
	// Of all tiles: how far the blades lean out over the tile's square; their lowest ground and their highest tip. Metres.
	double get_overhang() const { return _overhang + _lean; }
	double get_low() const { return _cover ? double(_cover->get_low()) : 0.0; }
	double get_height() const { return _height + _lean + (_cover ? double(_cover->get_high()) : 0.0); }
	// Prefetches what the next find_met() of many tiles reads: it lies in the order of a hash.
	void prefetch() const;
	size_t get_memory_usage() const; // bytes

private:
	// A blade's box from its root, and where in its tile the root stands, 0..1 each.
	struct Blade;
	struct Box {
		float min_x, max_x, min_z, max_z, height; // metres from the tile's centre, above the ground

		// Branch-free: which of the sides decides is unpredictable.
		bool meets(const Box &p_other, float p_other_bottom) const {
			const float x = std::min(max_x - p_other.min_x, p_other.max_x - min_x),
						z = std::min(max_z - p_other.min_z, p_other.max_z - min_z);
			return std::min(std::min(x, z), height - p_other_bottom) >= 0.0f;
		}
	};

	static void extend(Box &r_box, const Patch &p_patch, int p_blade, float p_taller, float p_chord);
	void find_boxes();

	TileGrid _grid;
	uint32_t _seed = 0;
	std::shared_ptr<const std::vector<Blade>> _blades; // of the patch
	std::vector<Box> _boxes; // by start in the patch / GRASS_START_STRIDE
	double _overhang = 0.0, _height = 0.0;
	double _lean = 0.0;
	std::shared_ptr<const TileCover> _cover;
};

} // namespace grass
