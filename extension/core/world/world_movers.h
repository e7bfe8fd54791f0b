// SPDX-License-Identifier: MIT
// What moves in a world, and in which plots it will be soon: there more grass is simulated at once.
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
	std::vector<PlotKey> plots; // in order, each once
	int64_t tests = 0; // of a way and a plot
	bool has(const PlotKey &p_key) const;
};

// Metres around a mover, however slow it is, and of its way, however fast it is.
inline constexpr double BUSY_AROUND = 16.0, BUSY_WAY = 400.0;

// Plots within BUSY_AROUND of what a mover covers in p_seconds.
BusyPlots find_busy(const WorldGrid &p_grid, std::span<const WorldMover> p_movers, double p_seconds);

} // namespace grass
