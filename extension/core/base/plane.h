// SPDX-License-Identifier: MIT
// Geometry in the plane.
#pragma once

#include <Eigen/Core>

#include <algorithm>

namespace grass {

// Returns the cross product of two vectors: positive where p_b is counter-clockwise of p_a.
inline double cross(const Eigen::Vector2d &p_a, const Eigen::Vector2d &p_b) {
	return p_a.x() * p_b.y() - p_a.y() * p_b.x();
}

inline Eigen::Vector2d nearest_on_segment(const Eigen::Vector2d &p_at, const Eigen::Vector2d &p_a, const Eigen::Vector2d &p_b) {
	const Eigen::Vector2d along = p_b - p_a;
	const double length = along.squaredNorm();
	const double t = length > 0.0 ? std::clamp((p_at - p_a).dot(along) / length, 0.0, 1.0) : 0.0;
	return p_a + t * along;
}

inline double distance_to_segment(const Eigen::Vector2d &p_at, const Eigen::Vector2d &p_a, const Eigen::Vector2d &p_b) {
	return (p_at - nearest_on_segment(p_at, p_a, p_b)).norm();
}

} // namespace grass
