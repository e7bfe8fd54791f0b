// SPDX-License-Identifier: MIT
#include "core/world/world_movers.h"

#include <algorithm>

namespace grass {

namespace {

// Returns whether a line meets the square of a plot, grown by BUSY_AROUND.
bool meets(const WorldGrid &p_grid, const PlotKey &p_key, const Eigen::Vector2d &p_from, const Eigen::Vector2d &p_way) {
	const double reach = 0.5 * p_grid.get_plot_size() + BUSY_AROUND;
	const Eigen::Vector2d from = p_from - p_grid.centre(p_key);
	double begin = 0.0, end = 1.0; // the part of the line inside the square
	for (int axis = 0; axis < 2; axis++) {
		if (p_way[axis] == 0.0) {
			if (std::abs(from[axis]) > reach) {
				return false;
			}
			continue;
		}
		const double one = (-reach - from[axis]) / p_way[axis], other = (reach - from[axis]) / p_way[axis];
		begin = std::max(begin, std::min(one, other));
		end = std::min(end, std::max(one, other));
	}
	return begin <= end;
}

} // namespace

bool BusyPlots::has(const PlotKey &p_key) const {
	return std::ranges::binary_search(plots, p_key);
}

BusyPlots find_busy(const WorldGrid &p_grid, std::span<const WorldMover> p_movers, double p_seconds) {
	BusyPlots busy;
	const Eigen::Vector2d around = Eigen::Vector2d::Constant(BUSY_AROUND);
	for (const WorldMover &mover : p_movers) {
		if (!mover.place.allFinite()) {
			continue;
		}
		Eigen::Vector2d way = mover.velocity * p_seconds;
		if (!way.allFinite()) {
			way.setZero();
		} else if (const double length = way.stableNorm(); length > BUSY_WAY) {
			way *= BUSY_WAY / length;
		}
		const Eigen::Vector2d to = mover.place + way;
		const PlotKey first = p_grid.at(mover.place.cwiseMin(to) - around), last = p_grid.at(mover.place.cwiseMax(to) + around);
		for (int z = first.z; z <= last.z; z++) {
			for (int x = first.x; x <= last.x; x++) {
				busy.tests++;
				if (p_grid.has({ x, z }) && meets(p_grid, { x, z }, mover.place, way)) {
					busy.plots.push_back({ x, z });
				}
			}
		}
	}
	std::ranges::sort(busy.plots);
	const auto rest = std::unique(busy.plots.begin(), busy.plots.end());
	busy.plots.erase(rest, busy.plots.end());
	return busy;
}

} // namespace grass
