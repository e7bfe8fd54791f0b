// SPDX-License-Identifier: MIT
// A body that changes its form as a few convex parts: each holds the same faces for ever, and is bounded anew in every step.
#pragma once

#include "core/bodies/hull.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace grass {

class SoftParts {
public:
	static constexpr int MAX_PARTS = 8;
	static constexpr int MAX_POINTS = 128; // of a part; of more every second, third, ... counts
	// Parts are wider than their points to each side, so that cloth is no sheet without a thickness. Metres.
	static constexpr double MARGIN = 0.01;

	SoftParts() = default; // has no parts
	// As it is made: places of its points, and three of them a face. Faces of points that do not exist are left out.
	SoftParts(std::span<const Eigen::Vector3d> p_points, std::span<const int> p_faces);

	int get_count() const { return int(_parts.size()); }
	// Which points have to be known, ascending.
	const std::vector<int> &get_points() const { return _points; }
	// p_places: of these points, in the same order. One hull a part; without planes where a place is not finite.
	void bound(std::span<const Eigen::Vector3d> p_places, std::vector<Hull> &r_hulls) const;

private:
	std::vector<int> _points;
	std::vector<std::vector<int>> _parts; // in _points
	bool _is_closed = false; // it encloses something, which presses as well
};

} // namespace grass
