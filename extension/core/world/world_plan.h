// SPDX-License-Identifier: MIT
// Which plots of a world are to be in memory: those near its cameras and its moving bodies, nearest first, as many as the budget holds.
#pragma once

#include "core/world/world_grid.h"

#include <limits>
#include <map>
#include <span>
#include <vector>

namespace grass {

// Metres around the cameras; around bodies that move. More: plots, and memory.
inline constexpr Tunable WORLD_RADIUS{ "radius", "m", 0.0, 8192.0, 1.0, 400.0 };
inline constexpr Tunable WORLD_BODY_RADIUS{ "body_radius", "m", 0.0, 1024.0, 1.0, 32.0 };
// For all plots together, on the GPU and beside it.
inline constexpr Tunable WORLD_BUDGET{ "budget", "MB", 1.0, 65536.0, 1.0, 256.0 };

// Where somebody looks or moves: plots within `radius` metres of `place` are wanted.
struct WorldEye {
	Eigen::Vector2d place = Eigen::Vector2d::Zero();
	double radius = 0.0;
};

struct WorldPlan {
	std::vector<PlotKey> wanted; // that the budget holds, nearest first
	std::vector<PlotKey> leaving; // that are in memory and must go, the farthest first
	// Metres around the eyes within which all plots are wanted and held: less than the radius where the budget is too small.
	double reach = std::numeric_limits<double>::infinity();
	bool is_short = false; // the budget does not hold all that is wanted
};

class WorldPlanner {
public:
	// Plots that are no longer wanted stay, as long as there is room, up to so many metres beyond the radius: an eye that turns round at
	// a border reads nothing again.
	static constexpr double LINGER = 64.0;

	// Bytes that a plot took when it was last in memory.
	void learn(const PlotKey &p_key, size_t p_bytes);
	// What to expect of a plot that was never in memory: what the largest took.
	size_t expected(const PlotKey &p_key) const;
	void forget();

	// p_loaded: the plots in memory, in no order; p_budget: bytes for all of them.
	WorldPlan plan(const WorldGrid &p_grid, std::span<const WorldEye> p_eyes, std::span<const PlotKey> p_loaded, size_t p_budget) const;

private:
	std::map<PlotKey, size_t> _bytes;
	size_t _most = 0;
};

} // namespace grass
