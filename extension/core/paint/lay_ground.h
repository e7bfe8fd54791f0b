// SPDX-License-Identifier: MIT
// Writes the shape of the ground into a map: heights, and the normals that follow from them.
#pragma once

#include "core/map/map_layers.h"
#include "core/paint/brush.h"
#include "core/paint/ground_reading.h"

#include <functional>

namespace grass {

// Returns the normal of the ground at a place, of any length; not finite or zero where there is none.
using NormalAt = std::function<Eigen::Vector3d(const Eigen::Vector2d &p_place)>;

struct LaidGround : BrushResult { // amount: 0
	int64_t sampled = 0; // number of places
	int64_t missing = 0; // texels for which there was no height; see MissingGround
};

// Returns the height of the ground at a place, which outside of p_field goes on in a straight line where there is none: a terrain that ends
// with its field has no ledge there, for which the whole field would pay. p_here: what p_height returns for the place.
double continued_ground(double p_here, const HeightAt &p_height, const MapRegion &p_field, const Eigen::Vector2d &p_place);

// Returns whether the map has no ground outside of p_region: then ground that is laid there may have its own grid.
bool is_all_ground_in(const PaintMap &p_map, const MapRegion &p_region);

// Writes ground that has been read, for a map with the grid that it was read for. Normals follow from the heights where p_normal gives
// none. A height closes a hole. Where the ground jumps, MAP_LEDGE says which heights count.
LaidGround lay_ground(PaintMap &r_map, const GroundReading &p_ground, const NormalAt &p_normal = nullptr);

struct LedgeSearch {
	HeightAt between; // at any place; null: between the centres of texels the ground is one sheet
	double slope = LEDGE_SLOPE.initial; // degrees
};

// Reads ground and writes it at once. p_height runs once a texel, and once for each texel of the margin around the region.
LaidGround lay_ground(PaintMap &r_map, const MapRegion &p_region, const HeightAt &p_height, MissingGround p_missing = MissingGround::STAYS,
		const NormalAt &p_normal = nullptr, const LedgeSearch &p_search = {});

} // namespace grass
