// SPDX-License-Identifier: MIT
#include "core/world/eye_groups.h"

#include <bit>
#include <cstdlib>
#include <unordered_map>

namespace grass {

namespace {

struct GroupKey {
	PlotKey plot;
	double radius;
	bool operator==(const GroupKey &) const = default;
};

struct GroupHash {
	size_t operator()(const GroupKey &p_key) const { return PlotHash()(p_key.plot) ^ size_t(std::bit_cast<uint64_t>(p_key.radius)); }
};

// Returns the distance in metres along one axis from plot p_plot to the span from p_min to p_max in plot p_own.
double gap(double p_side, int p_plot, int p_own, double p_min, double p_max) {
	const double low = p_side * p_plot;
	return std::max(0.0, p_plot > p_own ? low - p_max : (p_plot < p_own ? p_min - (low + p_side) : 0.0));
}

} // namespace

double EyeGroup::distance(const WorldGrid &p_grid, const PlotKey &p_plot) const {
	const int dx = p_plot.x - plot.x, dz = p_plot.z - plot.z;
	if (std::abs(dx) == 1 && std::abs(dz) == 1) {
		return corners[size_t(dz > 0) * 2 + size_t(dx > 0)];
	}
	const double side = p_grid.get_plot_size();
	return std::hypot(gap(side, p_plot.x, plot.x, min.x(), max.x()), gap(side, p_plot.z, plot.z, min.y(), max.y()));
}

std::vector<EyeGroup> group_eyes(const WorldGrid &p_grid, std::span<const WorldEye> p_eyes) {
	std::vector<EyeGroup> groups;
	std::unordered_map<GroupKey, size_t, GroupHash> places;
	places.reserve(p_eyes.size());
	const double side = p_grid.get_plot_size();
	for (const WorldEye &eye : p_eyes) {
		if (!eye.place.allFinite() || !std::isfinite(eye.radius)) {
			continue;
		}
		const PlotKey plot = p_grid.at(eye.place);
		std::array<double, 4> corners;
		for (size_t i = 0; i < corners.size(); i++) {
			corners[i] = (eye.place - side * Eigen::Vector2d(plot.x + int(i % 2), plot.z + int(i / 2))).norm();
		}
		const auto [found, is_new] = places.try_emplace({ plot, eye.radius }, groups.size());
		if (is_new) {
			groups.push_back({ plot, eye.radius, eye.place, eye.place, corners });
			continue;
		}
		EyeGroup &group = groups[found->second];
		group.min = group.min.cwiseMin(eye.place);
		group.max = group.max.cwiseMax(eye.place);
		for (size_t i = 0; i < corners.size(); i++) {
			group.corners[i] = std::min(group.corners[i], corners[i]);
		}
	}
	return groups;
}

} // namespace grass
