// SPDX-License-Identifier: MIT
// A game's tools on the map: cutting with a solid shape, measuring how much of a region is mown, regrowing.
#pragma once

#include "core/map/map_layers.h"
#include "core/paint/brush.h"
#include "core/paint/footprint.h"

#include <functional>

#include <functional>

namespace grass {

// The grass of one texel where nothing was painted or cut.
struct GrassKind {
	double height = 0.0; // mean of the blades at rest, metres
	double tallest = 0.0; // metres; cuts at this height and above cut nothing
	double per_area = 0.0; // blades per square metre
	std::function<double(const Eigen::Vector2d &)> height_at; // replaces `height` where species differ by place
};

struct CutResult : BrushResult {
	double area = 0.0; // m^2 on which grass became shorter, weighted by its density
	double volume = 0.0; // m^3: that area times the height removed
	double blades = 0.0; // number of blades that became shorter
};

// A rectangle or, if `footprint` is set, the part of the footprint inside the rectangle.
struct MowRegion {
	const Footprint *footprint = nullptr;
	MapRegion rectangle{ Eigen::Vector2d::Constant(-1e9), Eigen::Vector2d::Constant(1e9) }; // everything
};

// Cuts the grass in the region's shape: every blade ends at the underside of the shape. A shape that covers no texel's centre (they are 0.5
// m apart) cuts the texel below its middle.
CutResult cut_grass(PaintMap &r_map, const MowRegion &p_region, const GrassKind &p_kind);

// Returns the share of the region's grass, weighted by density, that is shorter than it would be without cuts; 0 where nothing grows.
double mown_share(const PaintMap &p_map, const MowRegion &p_region, const GrassKind &p_kind);

// Grows cut grass in the region by p_height metres and reduces its wear by p_wear. Removes cuts that no longer cut anything. Visits only
// chunks with cuts or wear. The amount in the result is that of the cuts: metres times m^2.
BrushResult regrow_grass(PaintMap &r_map, const MowRegion &p_region, const GrassKind &p_kind, double p_height, double p_wear);
// Does the same with a wear that differs by place (metres). Only worn texels read it; null: wear stays.
using WearAt = std::function<double(const Eigen::Vector2d &p_place)>;
BrushResult regrow_grass(PaintMap &r_map, const MowRegion &p_region, const GrassKind &p_kind, double p_height, const WearAt &p_wear);

} // namespace grass
