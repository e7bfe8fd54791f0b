// SPDX-License-Identifier: MIT
// The convex hull of a cloud of points, as planes: how the solver takes Godot's ConvexPolygonShape3D.
#pragma once

#include "core/base/layout.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace grass {

struct Hull {
	static constexpr int MAX_PLANES = GRASS_HULL_PLANES; // Faces a collider may have: each costs every knot near it one dot product.
	static constexpr int MAX_POINTS = 200; // Different ones, with those that thickening adds; above, a bound is taken.

	// Around its centre: n.xyz, d; inside: n.x <= d. Unit normals outwards, coplanar faces merged. Metres. Empty if no
	// point was finite.
	std::vector<Eigen::Vector4f> planes;
	Eigen::Vector3d centre = Eigen::Vector3d::Zero(); // Of the points' box, in the points' space. Metres.
	Eigen::Vector3d half_extents = Eigen::Vector3d::Zero(); // Of that box, as thick as the planes are. Metres.
	double radius = 0.0; // Of a sphere around the centre that holds it. Metres.
	bool is_bound = false; // The planes are not the hull's own: too many points or faces, so a 26-sided bound.

	// Points of a plane, a line or a single place get MIN_THICKNESS in the missing directions. Points that are not
	// finite or beyond 100 km are left out.
	static constexpr double MIN_THICKNESS = 1e-3; // Metres, each side of the plane.
	static constexpr double MAX_COORDINATE = 1e5; // Metres.
	static Hull make(std::span<const Eigen::Vector3d> p_points);
	// The 26-sided bound of points that are finite, p_margin metres wider to each side: for points that move from tick to tick.
	static Hull make_bound(std::span<const Eigen::Vector3d> p_points, double p_margin);
};

} // namespace grass
