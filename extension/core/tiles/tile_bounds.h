// SPDX-License-Identifier: MIT
// The box around a tile's blades at rest, against which Algorithm 1 tests a body's box. It is much tighter than the longest overhang on all
// sides, and still needs only a few numbers for each of the 2,040 places where a tile may start in the patch.
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
	// Without blades, no body ever meets a tile.
	TileBounds() = default;
	TileBounds(const Patch &p_patch, const TileGrid &p_grid, const ClumpParams &p_clump, uint32_t p_seed);
	// Uses the same blades on another grid, which is much less work.
	TileBounds(const TileBounds &p_other, const TileGrid &p_grid);

	// A body that rises no higher above the ground bends nothing: a deck below a field, with its rounding. Metres.
	static constexpr double LEAST_RISE = 1e-3;

	// A tile's place in the grid.
	struct Tile {
		uint16_t x = 0, z = 0;
	};
	// Returns true if p_bounds (field space, metres) meets the box around the blades of tile x, z.
	bool meets(int p_x, int p_z, const Bounds &p_bounds) const;
	// Removes the tiles that are not met from p_count tiles (of any type with x and z). Returns the number of tiles left, which keep their
	// order. Branch-free, since it is unpredictable whether a tile is met.
	template <typename T> int keep_met(T *r_tiles, int p_count, const Bounds &p_bounds) const {
		if (_boxes.empty()) {
			return 0;
		}
		const TileGrid grid = _grid; // a copy, so that the compiler knows that writing r_tiles does not change it
		const TileCover *cover = _cover.get();
		const Box *boxes = _boxes.data();
		const uint32_t seed = _seed;
		const double lean = _lean;
		int kept = 0;
		for (int n = 0; n < p_count; n++) {
			const T tile = r_tiles[n];
			const TileCover::Tile ground = cover != nullptr ? cover->get(tile.x, tile.z) : TileCover::FULL;
			// Rounded once, after the difference: accurate to a few nanometres on any field.
			const Eigen::Vector3d centre = grid.get_centre(tile.x, tile.z);
			const Box box{ float(p_bounds.min.x() - centre.x() - lean), float(p_bounds.max.x() - centre.x() + lean),
				float(p_bounds.min.z() - centre.z() - lean), float(p_bounds.max.z() - centre.z() + lean), 0.0f };
			const float bottom = float(p_bounds.min.y() - lean - double(ground.high));
			const Box &blades = boxes[grass_tile_start(tile.x, tile.z, seed) / GRASS_START_STRIDE];
			r_tiles[kept] = tile;
			kept += int(blades.meets(box, bottom)) & int(!ground.is_bare()) & int(p_bounds.max.y() > double(ground.low) + LEAST_RISE);
		}
		return kept;
	}
	// Sets the ground below the tiles, and the bare ones; null: the ground is level everywhere. p_lean: metres by which blades lean
	// farther on slopes.
	void set_cover(std::shared_ptr<const TileCover> p_cover, double p_lean) {
		_cover = std::move(p_cover);
		_lean = p_lean;
	}
	// Return, over all tiles: how far blades lean out over their tile's square; the lowest ground and the highest tip. Metres.
	double get_overhang() const { return _overhang + _lean; }
	double get_low() const { return _cover ? double(_cover->get_low()) : 0.0; }
	double get_height() const { return _height + _lean + (_cover ? double(_cover->get_high()) : 0.0); }
	// Prefetches what the next keep_met() of many tiles reads, since it is scattered by a hash.
	void prefetch() const;
	size_t get_memory_usage() const; // bytes

private:
	// A blade's box relative to its root, and the place of the root in its tile, 0..1 each.
	struct Blade;
	struct Box {
		float min_x, max_x, min_z, max_z, height; // metres from the tile's centre, above the ground

		// Returns whether two boxes meet. Branch-free, since it is unpredictable which side decides.
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
