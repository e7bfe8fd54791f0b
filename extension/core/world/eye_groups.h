// SPDX-License-Identifier: MIT
// Groups the eyes of a world by the plot that each is in: a plot far from a crowd uses the distance to the crowd, not to each of its
// bodies.
#pragma once

#include "core/world/world_grid.h"

#include <array>
#include <span>
#include <vector>

namespace grass {

// A place where somebody looks or moves: plots within `radius` metres of `place` are wanted.
struct WorldEye {
	Eigen::Vector2d place = Eigen::Vector2d::Zero();
	double radius = 0.0;
};

// The eyes in one plot that have the same radius.
struct EyeGroup {
	PlotKey plot;
	double radius = 0.0;
	Eigen::Vector2d min = Eigen::Vector2d::Zero(), max = Eigen::Vector2d::Zero(); // the box around them, metres
	// Metres from each corner of the plot to the nearest of them, ordered by x, then by z, the lower one first.
	std::array<double, 4> corners = {};

	// Returns the distance in metres from a plot to the nearest of them. Exact for their own plot, its eight neighbours, all plots in its
	// row and column, and for a single eye; elsewhere a lower bound.
	double distance(const WorldGrid &p_grid, const PlotKey &p_plot) const;
};

// Returns the groups in the order of their first eyes. Eyes that are not finite see nothing.
std::vector<EyeGroup> group_eyes(const WorldGrid &p_grid, std::span<const WorldEye> p_eyes);

} // namespace grass
