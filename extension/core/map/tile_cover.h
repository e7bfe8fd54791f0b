// SPDX-License-Identifier: MIT
// The map for whole tiles: whether anything grows on a tile, how much, and the lowest and highest ground. Only fields with a map have a
// cover. Culling and the waking of tiles read it.
#pragma once

#include "core/map/map_region.h"

#include <array>
#include <span>
#include <vector>

namespace grass {

class MapLayers;

class TileCover {
public:
	struct Tile {
		float low = 1.0f, high = -1.0f; // The ground below it, metres above the field. Bare: nothing grows there; low > high.
		float grown = 0.0f; // Mean share of the grass of a field without a map: density times height, 0..1.
		float cut = 0.0f; // Greatest height of its grass, metres above the ground.
		float slope = 0.0f; // Of the ground, from one end to the other: rise over run.
		bool is_bare() const { return low > high; }
		bool operator==(const Tile &) const = default;
	};
	// A level tile full of uncut grass, as in a field without a map.
	static constexpr Tile FULL = { 0.0f, 0.0f, 1.0f, float(GRASS_UNCUT), 0.0f };

	// Makes all tiles bare.
	void reset(const TileGrid &p_grid);
	// Updates the tiles that p_region concerns from the layers. Returns these tiles.
	TileRange update(const MapLayers &p_layers, const MapRegion &p_region);

	const Tile &get(int p_x, int p_z) const { return _tiles[size_t(_grid.get_index(p_x, p_z))]; }
	std::span<const Tile> get_tiles() const { return _tiles; } // by index
	int get_bare_count() const { return _bare; }
	float get_low() const { return _extremes.low; } // of all ground, including the field's plane
	float get_high() const { return _extremes.high; }
	// Returns bounds of all tiles that are not bare: of the ground, and the least grown, the shortest and the steepest there may be. Bare
	// if all of them are.
	Tile get_extremes() const { return _bare < int(_tiles.size()) ? _extremes : Tile(); }
	size_t get_memory_usage() const { return _tiles.capacity() * sizeof(Tile); } // bytes

private:
	// For one axis: the chunks that contain a row or column of tiles, and in each of them the texels of its layer that contribute to
	// samples within these tiles.
	struct Stretch {
		struct Texels {
			int first = 0, last = 0;
			int count() const { return last - first + 1; }
		};
		int first_chunk = 0, chunks = 0; // at most two: no tile is as large as a chunk
		std::array<Texels, 2> fine, coarse;
		double get_metres() const; // between the heights at its ends
	};

	void widen(const Tile &p_tile);
	std::vector<Stretch> stretches(int p_begin, int p_end, int p_count, double p_offset) const;
	Tile find(const MapLayers &p_layers, const Stretch &p_column, const Stretch &p_row) const;

	TileGrid _grid;
	std::vector<Tile> _tiles;
	int _bare = 0;
	Tile _extremes = FULL;
};

} // namespace grass
