// SPDX-License-Identifier: MIT
// Computes how far along its axis a dragged handle is.
#pragma once

#include <Eigen/Core>

#include <optional>

namespace grass {

// Returns where the line through the origin along p_axis (unit) comes closest to the ray from p_eye along p_way: metres along the axis.
// Returns nothing if the ray is parallel to the axis, or points away from that place.
inline std::optional<double> drag_along(const Eigen::Vector3d &p_axis, const Eigen::Vector3d &p_eye, const Eigen::Vector3d &p_way) {
	constexpr double PARALLEL = 1e-6; // square of the sine of the angle between them
	const double along = p_axis.dot(p_way), way = p_way.squaredNorm(), across = way - along * along;
	if (!(across > PARALLEL * way)) {
		return {};
	}
	const double place = (way * p_axis.dot(p_eye) - along * p_eye.dot(p_way)) / across;
	if (!((place * p_axis - p_eye).dot(p_way) > 0.0)) {
		return {};
	}
	return place;
}

} // namespace grass
