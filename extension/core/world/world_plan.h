// SPDX-License-Identifier: MIT
// Decides which plots of a world should be in memory: those under its cameras and its moving bodies, then the others around them, nearest
// first, as many as the budget holds.
#pragma once

#include "core/world/eye_groups.h"

#include <algorithm>
#include <limits>
#include <span>
#include <unordered_map>
#include <vector>

namespace grass {

// Metres around the cameras, and around moving bodies. More: more plots and more memory.
inline constexpr Tunable WORLD_CAMERA_RADIUS{ "camera_radius", "m", 0.0, 8192.0, 1.0, 400.0 };
inline constexpr Tunable WORLD_BODY_RADIUS{ "body_radius", "m", 0.0, 1024.0, 1.0, 32.0 };
// For all plots together, in GPU and main memory.
inline constexpr Tunable WORLD_MEMORY_BUDGET{ "memory_budget", "MB", 1.0, 65536.0, 1.0, 256.0 };

// A plot in memory, with its last measured size.
struct LoadedPlot {
	PlotKey key;
	size_t rest = 0; // bytes without its pool; 0: unknown
	size_t pool = 0; // bytes of the slots for its awake tiles
};

// The input of a plan.
struct WorldNeeds {
	std::span<const WorldEye> eyes; // most important first
	std::span<const LoadedPlot> loaded; // in any order
	size_t budget = 0; // bytes for all plots together
	size_t held_back = 0; // bytes of the budget reserved for the plots under the eyes
};

struct WorldPlan {
	std::vector<PlotKey> wanted; // and held by the budget: those under the eyes, then the nearest first
	size_t under_eyes = 0; // number of them that must be in memory, whatever the budget is
	std::vector<PlotKey> leaving; // in memory and must go, farthest first
	// Metres around the eyes within which all wanted plots are held: less than the radius if the budget is too small.
	double reach = std::numeric_limits<double>::infinity();
	bool is_short = false; // the budget does not hold everything that is wanted
	size_t missing = 0; // bytes by which the plots under the eyes exceed the budget
	int64_t tests = 0; // number of distances computed
};

class WorldPlanner {
public:
	// Plots that are no longer wanted stay while there is room, up to this many metres beyond the radius: an eye that turns back at a
	// border reads nothing again.
	static constexpr double LINGER = 64.0;

	// Learns the current size of plots. The size of plots that leave is remembered, so that a plan that was followed gives the same plan
	// again.
	void learn(std::span<const LoadedPlot> p_loaded);
	// Returns the expected bytes of a plot without its pool: its last size, or else the median of the plots in memory.
	size_t expected(const PlotKey &p_key) const;
	size_t get_typical() const { return _typical; }

	WorldPlan plan(const WorldGrid &p_grid, const WorldNeeds &p_needs) const;

private:
	std::unordered_map<PlotKey, size_t, PlotHash> _rest;
	size_t _typical = 0;
};

} // namespace grass
