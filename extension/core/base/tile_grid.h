// SPDX-License-Identifier: MIT
// The field's tiles: their number, their places, and which of them a rectangle overlaps. Field space: metres, y up, ground at y = 0,
// centred; tile (0, 0) is the -x, -z corner.
#pragma once

#include "core/base/layout.h"

#include <Eigen/Core>

#include <algorithm>

namespace grass {

// Tiles x_begin <= x < x_end, z_begin <= z < z_end.
struct TileRange {
	int x_begin = 0, x_end = 0, z_begin = 0, z_end = 0;

	int width() const { return x_end > x_begin ? x_end - x_begin : 0; }
	int depth() const { return z_end > z_begin ? z_end - z_begin : 0; }
	int64_t count() const { return int64_t(width()) * depth(); }
	bool has(int p_x, int p_z) const { return p_x >= x_begin && p_x < x_end && p_z >= z_begin && p_z < z_end; }
	// Returns the smallest range that contains both; neither may be empty.
	TileRange joined(const TileRange &p_other) const {
		return { std::min(x_begin, p_other.x_begin), std::max(x_end, p_other.x_end), std::min(z_begin, p_other.z_begin),
			std::max(z_end, p_other.z_end) };
	}
	bool operator==(const TileRange &) const = default;
};

// A point as a tile and the offset from that tile's centre on the ground, so that single precision holds anywhere.
struct TilePlace {
	int x = 0, z = 0; // The tile; outside the grid if the point is.
	Eigen::Vector3f offset = Eigen::Vector3f::Zero(); // Metres.
};

class TileGrid {
public:
	static constexpr double MIN_DENSITY = 0.25, MAX_DENSITY = 4096.0; // Blades/m^2: tiles of 16 m to 0.125 m.
	static constexpr int MAX_TILES_PER_SIDE = 8192; // 2^26 tiles in all: 4 x 4 km at 256 blades/m^2.

	// A grid of one tile.
	TileGrid() = default;

	// Returns the grid for a field of p_size_x by p_size_z metres with p_density blades/m^2. A field has whole tiles only: its size is
	// rounded to the nearest number of them, at least one. Values that are not finite or exceed the limits are brought within them, and
	// was_limited() then returns true.
	static TileGrid make(double p_size_x, double p_size_z, double p_density);

	double get_tile_size() const { return _tile_size; } // Metres; exact as a float.
	int get_tiles_x() const { return _tiles_x; }
	int get_tiles_z() const { return _tiles_z; }
	int get_tile_count() const { return _tiles_x * _tiles_z; }
	double get_size_x() const { return _tile_size * _tiles_x; } // Metres.
	double get_size_z() const { return _tile_size * _tiles_z; }
	bool was_limited() const { return _limited; }

	bool has_tile(int p_x, int p_z) const { return p_x >= 0 && p_z >= 0 && p_x < _tiles_x && p_z < _tiles_z; }
	int get_index(int p_x, int p_z) const { return p_x + p_z * _tiles_x; }
	int get_x(int p_index) const { return p_index % _tiles_x; }
	int get_z(int p_index) const { return p_index / _tiles_x; }

	// Returns the centre of a tile on the ground in field space, metres.
	Eigen::Vector3d get_centre(int p_x, int p_z) const {
		return { (p_x + 0.5 - 0.5 * _tiles_x) * _tile_size, 0.0, (p_z + 0.5 - 0.5 * _tiles_z) * _tile_size };
	}

	// Returns the tile that contains a point in field space (finite, metres), which may be outside the field.
	TilePlace get_place(const Eigen::Vector3d &p_position) const;

	// Returns p_position relative to the centre of the given tile: subtracted in double, rounded once.
	Eigen::Vector3f get_offset(const Eigen::Vector3d &p_position, int p_x, int p_z) const {
		return (p_position - get_centre(p_x, p_z)).cast<float>();
	}

	// Returns the tiles whose square, grown by p_margin metres on every side, meets the rectangle. Empty if none does, or if a limit is
	// NaN.
	TileRange get_range(double p_min_x, double p_max_x, double p_min_z, double p_max_z, double p_margin) const;

	bool operator==(const TileGrid &) const = default;

private:
	double _tile_size = 0.5;
	int _tiles_x = 1, _tiles_z = 1;
	bool _limited = false;
};

} // namespace grass
