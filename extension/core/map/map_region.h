// SPDX-License-Identifier: MIT
// A rectangle on the ground, and the chunks that it meets.
#pragma once

#include "core/base/tile_grid.h"
#include "core/map/paint_map.h"

namespace grass {

// A rectangle of places, metres.
struct MapRegion {
	Eigen::Vector2d min = Eigen::Vector2d::Zero(), max = Eigen::Vector2d::Zero();
	static MapRegion of_chunk(const MapKey &p_key);
	static MapRegion of_grid(const TileGrid &p_grid); // the whole field
	bool contains(const Eigen::Vector2d &p_place) const {
		return (p_place.array() >= min.array()).all() && (p_place.array() <= max.array()).all();
	}
	bool has_area() const { return (min.array() < max.array()).all(); }
	MapRegion grown(double p_metres) const;
	MapRegion joined(const MapRegion &p_other) const;
	MapRegion shared(const MapRegion &p_other) const; // empty if min > max along an axis
	bool operator==(const MapRegion &) const = default;
};

} // namespace grass
