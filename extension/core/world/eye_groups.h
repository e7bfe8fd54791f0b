// SPDX-License-Identifier: MIT
// The eyes of a world, put together by the plot that each is in: a plot far from a crowd uses the distance to the crowd, not to each
// of its bodies.
#pragma once

#include "core/world/world_grid.h"

#include <array>
#include <span>
#include <vector>

namespace grass {

// Where somebody looks or moves: plots within `radius` metres of `place` are wanted.
struct WorldEye {
	Eigen::Vector2d place = Eigen::Vector2d::Zero();
	double radius = 0.0;
};

// The eyes of one radius in one plot.
struct EyeGroup {
	PlotKey plot;
	double radius = 0.0;
	Eigen::Vector2d min = Eigen::Vector2d::Zero(), max = Eigen::Vector2d::Zero(); // the box around them, metres
	// Metres from each corner of the plot to the nearest of them: x first, then z, each the lower one first.
	std::array<double, 4> corners = {};

	// Metres from a plot to the nearest of them. Exact for the plot, its eight neighbours, all plots of its row and column, and for a
	// single eye; elsewhere no more than that.
	double distance(const WorldGrid &p_grid, const PlotKey &p_plot) const;
};

// In the order in which the first eye of each came. Eyes that are not finite see nothing.
std::vector<EyeGroup> group_eyes(const WorldGrid &p_grid, std::span<const WorldEye> p_eyes);

} // namespace grass
