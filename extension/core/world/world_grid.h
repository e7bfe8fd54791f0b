// SPDX-License-Identifier: MIT
// The plots of a world: adjacent squares, each with its own field and map. Places are x, z in metres from the world's centre, where four
// plots meet.
#pragma once

#include "core/base/tunable.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace grass {

// A plot, which covers x * size to (x + 1) * size metres, and z likewise.
struct PlotKey {
	int x = 0, z = 0;
	auto operator<=>(const PlotKey &) const = default;
};

struct PlotHash {
	size_t operator()(const PlotKey &p_key) const {
		return size_t((uint64_t(uint32_t(p_key.x)) << 32 | uint32_t(p_key.z)) * 0x9e3779b97f4a7c15u >> 16);
	}
};

class WorldGrid {
public:
	// The side of a plot, in metres. A plot has whole chunks of the map, so that the chunks of neighbours meet.
	static constexpr Tunable SIZE{ "size", "m", 128.0, 65536.0, 1.0, 16384.0 };
	static constexpr Tunable PLOT_SIZE{ "plot_size", "m", 64.0, 1024.0, 64.0, 256.0 };

	WorldGrid() = default;
	// Makes a world of p_size metres along x and z, rounded up to whole plots on both sides of its centre.
	WorldGrid(const Eigen::Vector2d &p_size, double p_plot) :
			_plot(p_plot), _reach_x(int(std::ceil(0.5 * p_size.x() / p_plot))), _reach_z(int(std::ceil(0.5 * p_size.y() / p_plot))) {}

	double get_plot_size() const { return _plot; } // metres
	bool has(const PlotKey &p_key) const {
		return p_key.x >= -_reach_x && p_key.x < _reach_x && p_key.z >= -_reach_z && p_key.z < _reach_z;
	}
	// Returns the plot of a place, which may be outside the world.
	PlotKey at(const Eigen::Vector2d &p_place) const { return { index(p_place.x()), index(p_place.y()) }; }
	Eigen::Vector2d centre(const PlotKey &p_key) const { return _plot * Eigen::Vector2d(p_key.x + 0.5, p_key.z + 0.5); }
	// Returns the distance in metres from a place to the nearest point of the plot: 0 inside.
	double distance(const PlotKey &p_key, const Eigen::Vector2d &p_place) const {
		return ((p_place - centre(p_key)).cwiseAbs().array() - 0.5 * _plot).cwiseMax(0.0).matrix().norm();
	}
	// Returns the distance to the nearest point of a line. The distance is convex along the line.
	double distance(const PlotKey &p_key, const Eigen::Vector2d &p_from, const Eigen::Vector2d &p_to) const {
		double low = 0.0, high = 1.0;
		const auto at = [&](double p_share) { return distance(p_key, p_from + p_share * (p_to - p_from)); };
		for (int halvings = 0; halvings < 48; halvings++) {
			const double third = (high - low) / 3.0;
			if (at(low + third) <= at(high - third)) {
				high -= third;
			} else {
				low += third;
			}
		}
		return at(0.5 * (low + high));
	}
	bool operator==(const WorldGrid &) const = default;

private:
	int index(double p_place) const {
		constexpr double FAR = 1 << 20; // outside every world
		return int(std::floor(std::clamp(p_place / _plot, -FAR, FAR)));
	}

	double _plot = PLOT_SIZE.initial;
	int _reach_x = 0, _reach_z = 0; // plots on each side of the centre
};

} // namespace grass
