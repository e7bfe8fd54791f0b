// SPDX-License-Identifier: MIT
// Finds which of the many tiles below a large body have blades whose motion can be seen: those around its outline in the grass, not those
// wholly under it.
#pragma once

#include "core/base/tile_grid.h"
#include "core/bodies/body_shape.h"
#include "core/tiles/tile_params.h"

#include <Eigen/Core>

#include <vector>

namespace grass {

class TileFootprint {
public:
	// Tiles begin <= x < end of a row.
	struct Span {
		int begin = 0, end = 0;
		bool is_empty() const { return end <= begin; }
	};

	// p_swept: the box around the collider's way.
	TileFootprint(const ColliderShape &p_collider, const Bounds &p_swept, const TileGrid &p_grid, const TileParams &p_params);

	// Returns, of a row within p_limits, the tiles whose blades it may meet, including some that it does not meet.
	Span find_reached(int p_z, const Span &p_limits) const { return clip(_outer, p_z, p_limits); }
	// Returns the tiles that are wholly under it, at the start of the step and at its end.
	Span find_covered(int p_z, const Span &p_limits) const { return clip(_inner, p_z, p_limits); }
	// Returns true if it is taller than the grass, so that nobody sees what is under it.
	bool is_tall() const { return _is_tall; }

private:
	// A tile is within if x * its column + z * its row <= room.
	struct Side {
		double x, z, room;
	};

	void add_outer(const ColliderShape &p_collider, const Bounds &p_swept);
	void add_inner(const ColliderShape &p_collider, const ColliderPose &p_pose);
	void add_side(const Eigen::Vector3d &p_normal, double p_room, std::vector<Side> &r_sides) const;
	static Span clip(const std::vector<Side> &p_sides, int p_z, const Span &p_limits);

	const TileGrid &_grid;
	const TileParams &_params;
	std::vector<Side> _outer, _inner;
	bool _is_tall = false;
};

} // namespace grass
