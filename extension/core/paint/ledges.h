// SPDX-License-Identifier: MIT
// Ledges: where the ground jumps between heights one texel apart. In a cell (a square between the centres of four texels of the ground)
// with a ledge, each spot knows which of the four heights are on its side. [Eq M7]
#pragma once

#include "core/base/tunable.h"
#include "core/map/ground_grid.h"
#include "core/paint/height_block.h"

#include <array>
#include <cstdint>

namespace grass {

// Steeper ground is a ledge: nothing is blended across it, and nothing grows on its face.
inline constexpr Tunable LEDGE_SLOPE{ "ledge_slope", "\u00b0", 30.0, 89.0, 0.5, 70.0 };

// Returns the height at a place of a cell that a blend of its corners' heights gives; p_x, p_z: of the way through it. Corners: (0, 0), (1,
// 0), (0, 1), (1, 1).
double blend_corners(const std::array<double, 4> &p_corners, double p_x, double p_z);
// Returns the rise over run of a slope in degrees.
double ledge_tangent(double p_slope);

struct LedgeCell {
	static constexpr int SPOTS = info_of(MAP_LEDGE).side / info_of(MAP_GROUND).side; // along a side
	static constexpr int POINTS = SPOTS + 1;
	int i = 0, j = 0; // the cell's first texel
	static Eigen::Array2i first_spot(int p_i, int p_j) { return Eigen::Array2i(p_i, p_j) * SPOTS + SPOTS / 2; } // texel of MAP_LEDGE
	// Returns how many texels of MAP_LEDGE farther that is where the ground has a grid of its own (grass_ledge_place()).
	static Eigen::Array2i moved_spots(const GroundGrid &p_grid) {
		return (p_grid.offset() * SPOTS + Eigen::Vector2d(0.5, 0.5)).array().floor().cast<int>();
	}
	std::array<double, size_t(POINTS *POINTS)> heights{}; // at the corners of its spots, row by row along x

	double &at(int p_column, int p_row) { return heights[size_t(p_row * POINTS + p_column)]; }
	double at(int p_column, int p_row) const { return heights[size_t(p_row * POINTS + p_column)]; }
};

// One of the texels at a cell's corners, as the map has it.
struct LedgeCorner {
	double height = 0.0; // metres
	Eigen::Vector2d normal = Eigen::Vector2d::Zero(); // x, z
	bool is_missing = false; // there is no ground at the corner
};

// Returns the codes of a cell's spots, row by row along x. p_corners: (0, 0), (1, 0), (0, 1), (1, 1) along x, z.
std::array<uint8_t, size_t(LedgeCell::SPOTS *LedgeCell::SPOTS)> ledge_codes(
		const LedgeCell &p_cell, const std::array<LedgeCorner, 4> &p_corners, double p_slope);

// The slope of the ground at a texel whose neighbours may lie beyond a ledge: rise over run along x, z. p_is_sheet: between the centres of
// texels the ground is one sheet; else it reads SLOPE_PLACES.
inline constexpr int SLOPE_PLACES = 4;
Eigen::Vector2d slope_beside_ledge(const HeightBlock &p_heights, double p_slope, bool p_is_sheet, int p_i, int p_j, GroundPlaces &r_places);

} // namespace grass
