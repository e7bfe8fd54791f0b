// SPDX-License-Identifier: MIT
// Things that move in a world, and the plots in which they will be soon: more grass is simulated there at once.
#pragma once

#include "core/world/world_grid.h"

#include <span>
#include <vector>

namespace grass {

struct WorldMover {
	Eigen::Vector2d place = Eigen::Vector2d::Zero();
	Eigen::Vector2d velocity = Eigen::Vector2d::Zero(); // metres a second
};

struct BusyPlots {
	std::vector<PlotKey> plots; // ascending, each once
	int64_t tests = 0; // tests of a path against a plot
	bool has(const PlotKey &p_key) const;
};

// Metres around a mover, even a slow one, and the longest path of a fast one.
inline constexpr double BUSY_AROUND = 16.0, BUSY_WAY = 400.0;

// Returns the plots within BUSY_AROUND of the path of a mover in p_seconds.
BusyPlots find_busy(const WorldGrid &p_grid, std::span<const WorldMover> p_movers, double p_seconds);

} // namespace grass
