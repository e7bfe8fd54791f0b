// SPDX-License-Identifier: MIT
// What tests measure of several hulls.
#pragma once

#include "core/bodies/hull.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace grass::test {

// Returns how far a place is outside of all hulls; below 0: inside of one. Metres.
inline double outside_of(const std::vector<Hull> &p_hulls, const Eigen::Vector3d &p_place) {
	double least = std::numeric_limits<double>::infinity();
	for (const Hull &hull : p_hulls) {
		double most = -std::numeric_limits<double>::infinity();
		for (const Eigen::Vector4f &plane : hull.planes) {
			most = std::max(most, plane.head<3>().cast<double>().dot(p_place - hull.centre) - double(plane.w()));
		}
		least = hull.planes.empty() ? least : std::min(least, most);
	}
	return least;
}

} // namespace grass::test
