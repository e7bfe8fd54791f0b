// SPDX-License-Identifier: MIT
// A body that changes its form, as a few convex parts. Each part always has the same faces, and gets a new bound in every step.
#pragma once

#include "core/bodies/hull.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace grass {

class SoftParts {
public:
	static constexpr int MAX_PARTS = 8;
	static constexpr int MAX_POINTS = 128; // of a part; a larger part uses every second, third, ... point
	// How much wider than their points parts are on each side, so that cloth has a thickness. Metres.
	static constexpr double MARGIN = 0.01;

	SoftParts() = default; // without parts
	// p_points: the places of its points as it was made; p_faces: three indices for each face. Faces with invalid indices are left out.
	SoftParts(std::span<const Eigen::Vector3d> p_points, std::span<const int> p_faces);

	int get_count() const { return int(_parts.size()); }
	// Returns the indices of the points whose places bound() needs, ascending.
	const std::vector<int> &get_points() const { return _points; }
	// Bounds the parts. p_places: the places of get_points(), in the same order. r_hulls: one for each part, without planes where a place
	// is not finite.
	void bound(std::span<const Eigen::Vector3d> p_places, std::vector<Hull> &r_hulls) const;

private:
	std::vector<int> _points;
	std::vector<std::vector<int>> _parts; // indices into _points
	bool _is_closed = false; // it encloses a volume, which presses as well
};

} // namespace grass
