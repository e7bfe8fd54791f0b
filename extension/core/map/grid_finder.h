// SPDX-License-Identifier: MIT
// Finds the grid on which a terrain has its vertices, from its triangles.
#pragma once

#include "core/map/ground_grid.h"

#include <array>
#include <optional>
#include <vector>

namespace grass {

class GridFinder {
public:
	// Adds a triangle with its corners in field space, metres. Some thousands of a terrain suffice.
	void add(const Eigen::Vector3d &p_a, const Eigen::Vector3d &p_b, const Eigen::Vector3d &p_c);
	// Returns the grid of nearly all corners. Nothing if they lie closer together than a metre or on no grid, or if the ground is a plane,
	// which needs none.
	std::optional<GroundGrid> find() const;

private:
	using Triangle = std::array<Eigen::Vector2d, 3>; // x, z of its corners

	bool have_vertices_at(const GroundGrid &p_grid) const;
	GroundSplit find_split() const;

	std::vector<Triangle> _triangles;
	Eigen::Vector3d _normal = Eigen::Vector3d::Zero(); // of the first
	bool _is_plane = true;
};

} // namespace grass
