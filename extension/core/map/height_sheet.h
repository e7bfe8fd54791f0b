// SPDX-License-Identifier: MIT
// Heights of a triangle mesh at the centres of the texels of a map's ground. lay_ground() reads them if the terrain's triangles are known.
#pragma once

#include "core/map/map_layers.h"

#include <vector>

namespace grass {

class HeightSheet {
public:
	// Makes a sheet for lay_ground() over p_region, into a map with this grid.
	explicit HeightSheet(const MapRegion &p_region, const GroundGrid &p_grid = GroundGrid());

	// Adds a triangle with its corners in field space, metres. Where triangles overlap, the highest counts. Triangles that are vertical or
	// not finite add nothing.
	void add(const Eigen::Vector3d &p_a, const Eigen::Vector3d &p_b, const Eigen::Vector3d &p_c);

	// Returns the height of the texel whose height lies nearest to p_place, in metres above the field; NaN where there is no triangle, and
	// outside the region.
	double at(const Eigen::Vector2d &p_place) const;
	// Returns the height at p_place itself.
	double between(const Eigen::Vector2d &p_place) const;

private:
	Eigen::Array2d texel_at(const Eigen::Vector2d &p_place) const; // relative to the first texel; centres have integer coordinates

	Eigen::Array2d _first; // centre of the first texel, metres
	struct Triangle {
		Eigen::Array2d a, b, c; // corners in the coordinates of texel_at()
		Eigen::Array3d heights;
		// Returns its height at a place; NaN outside the triangle.
		double at(const Eigen::Array2d &p_texel) const;
	};

	int _width = 0, _depth = 0;
	std::vector<Triangle> _triangles;
	std::vector<std::vector<uint32_t>> _above; // by texel: the triangles above the square around its centre
	std::vector<double> _heights; // row by row along x
};

} // namespace grass
