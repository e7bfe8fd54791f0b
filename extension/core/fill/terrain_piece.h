// SPDX-License-Identifier: MIT
// A part of a terrain that is being read, row by row, and the queue of parts to read: what changed, the nearest to a camera first.
#pragma once

#include "core/fill/terrain_colors.h"
#include "core/fill/terrain_ids.h"
#include "core/paint/lay_ground.h"

#include <limits>
#include <optional>

namespace grass {

// What a terrain reports about a place.
struct TerrainSample {
	double height = std::numeric_limits<double>::quiet_NaN(); // metres above the field; not finite: a hole
	Eigen::Vector3d normal = Eigen::Vector3d::Zero(); // field space; zero: not reported
	TerrainTexel texture;
	TerrainColor color;
};

class TerrainPiece {
public:
	// Reads the texels whose heights are in p_region, its far borders excepted, for a map with p_grid. The texels around it are queried
	// too, since slopes need them.
	explicit TerrainPiece(const MapRegion &p_region, const GroundGrid &p_grid = GroundGrid());

	bool is_complete() const { return _samples.size() >= size_t(_size.x()) * size_t(_size.y()); }
	// Returns where the heights of the next texels are: x, z in metres. They are at most p_most, and of one row.
	std::vector<Eigen::Vector2d> get_next(size_t p_most = SIZE_MAX) const;
	void put_next(std::span<const TerrainSample> p_samples); // in the order of get_next()

	// These write the result once all rows are read.
	LaidGround lay(PaintMap &r_map, double p_ledge_slope = LEDGE_SLOPE.initial) const; // degrees
	// Returns true if any texture changed.
	bool put_textures(TerrainIds &r_ids) const;
	void put_colors(TerrainColors &r_colors) const;
	const MapRegion &get_region() const { return _region; }
	const GroundGrid &get_grid() const { return _grid; }

private:
	const TerrainSample &at(const Eigen::Vector2d &p_place) const;

	MapRegion _region;
	GroundGrid _grid;
	Eigen::Array2i _first, _size; // texels to query
	std::vector<TerrainSample> _samples;
};

class TerrainQueue {
public:
	// Sets the area to read, and empties the queue.
	void set_area(const MapRegion &p_area);
	const MapRegion &get_area() const { return _area; }
	void add(const MapRegion &p_region);
	void add_all() { add(_area); }
	void clear() { _waiting.clear(); }
	int64_t get_waiting() const { return int64_t(_waiting.size()); } // chunks
	// Removes and returns the waiting part nearest to one of the places (x, z in metres; none: the map's origin), no larger than a chunk.
	// Returns nothing if the queue is empty.
	std::optional<MapRegion> take(std::span<const Eigen::Vector2d> p_eyes);

private:
	MapRegion _area;
	std::map<MapKey, MapRegion> _waiting;
};

} // namespace grass
