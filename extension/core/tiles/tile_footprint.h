// SPDX-License-Identifier: MIT
// Finds which of the many tiles below a large body have blades whose motion is visible: those around its outline in the grass, not those
// completely under it.
#pragma once

#include "core/base/tile_grid.h"
#include "core/bodies/body_shape.h"
#include "core/tiles/tile_params.h"

#include <Eigen/Core>

#include <vector>

namespace grass {

class TileFootprint {
public:
	// The tiles begin <= x < end of a row.
	struct Span {
		int begin = 0, end = 0;
		bool is_empty() const { return end <= begin; }
	};

	// Finds the sides of the footprint. p_swept: the box around the collider's path.
	TileFootprint(const ColliderShape &p_collider, const Bounds &p_swept, const TileGrid &p_grid, const TileParams &p_params);

	// Returns the tiles of a row within p_limits whose blades the body may meet. May include some that it does not meet.
	Span find_reached(int p_z, const Span &p_limits) const { return clip(_outer, p_z, p_limits); }
	// Returns the tiles that are completely under it, both at the start of the step and at its end.
	Span find_covered(int p_z, const Span &p_limits) const { return clip(_inner, p_z, p_limits); }
	// Returns true if it is taller than the grass, so that what is under it is hidden.
	bool is_tall() const { return _is_tall; }

private:
	// A tile is inside if x * its column + z * its row <= room.
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
