// SPDX-License-Identifier: MIT
// Which plots of a world are to be in memory: those under its cameras and its moving bodies, their pools, and then the others around them,
// nearest first, as many as the budget holds.
#pragma once

#include "core/world/eye_groups.h"

#include <limits>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

namespace grass {

// Metres around the cameras; around bodies that move. More: plots, and memory.
inline constexpr Tunable WORLD_RADIUS{ "radius", "m", 0.0, 8192.0, 1.0, 400.0 };
inline constexpr Tunable WORLD_BODY_RADIUS{ "body_radius", "m", 0.0, 1024.0, 1.0, 32.0 };
// For all plots together, on the GPU and beside it.
inline constexpr Tunable WORLD_BUDGET{ "budget", "MB", 1.0, 65536.0, 1.0, 256.0 };

// A plot in memory, as it was measured last.
struct LoadedPlot {
	PlotKey key;
	size_t rest = 0; // bytes, without its pool; 0: not known
	size_t pool = 0; // bytes of its pool
	int64_t pool_tiles = 0;
};

// The pools of plots, in tiles: where nothing moves, and where something does.
struct PlotPools {
	int64_t quiet = 0, busy = 0;
	size_t tile_bytes = 0; // bytes a tile needs, used or not
};

// What a plan is made from.
struct WorldNeeds {
	std::span<const WorldEye> eyes; // those that matter most first
	std::span<const PlotKey> busy; // plots that want a pool, in the order of keys
	std::span<const LoadedPlot> loaded; // in no order
	PlotPools pools;
	size_t budget = 0; // bytes for all of them
	size_t held_back = 0; // bytes of it that only the plots under the eyes may take
};

struct WorldPlan {
	std::vector<PlotKey> wanted; // that the budget holds: those under the eyes, then the nearest first
	size_t under_eyes = 0; // how many of them must be in memory, whatever the budget is
	std::vector<PlotKey> leaving; // that are in memory and must go, the farthest first
	std::unordered_map<PlotKey, int64_t, PlotHash> pools; // tiles; of wanted plots that want more than a quiet pool
	// Metres around the eyes within which all plots are wanted and held: less than the radius where the budget is too small.
	double reach = std::numeric_limits<double>::infinity();
	bool is_short = false; // the budget does not hold all that is wanted
	size_t missing = 0; // bytes: what the plots under the eyes take beyond the budget
	int64_t tests = 0; // distances that were computed
};

class WorldPlanner {
public:
	// Plots that are no longer wanted stay, as long as there is room, up to so many metres beyond the radius: an eye that turns round at
	// a border reads nothing again.
	static constexpr double LINGER = 64.0;

	// What plots take now. It is remembered of those that leave, so that a plan that is followed is the same plan again.
	void learn(std::span<const LoadedPlot> p_loaded);
	// Expected bytes of a plot without its pool: what it needed last, or else the median of the plots in memory.
	size_t expected(const PlotKey &p_key) const;
	size_t get_typical() const { return _typical; }

	WorldPlan plan(const WorldGrid &p_grid, const WorldNeeds &p_needs) const;

private:
	std::unordered_map<PlotKey, size_t, PlotHash> _rest;
	size_t _typical = 0;
};

} // namespace grass
