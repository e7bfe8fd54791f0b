// SPDX-License-Identifier: MIT
// The convex hull of a cloud of points, as planes: the solver's form of Godot's ConvexPolygonShape3D.
#pragma once

#include "core/base/layout.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace grass {

struct Hull {
	static constexpr int MAX_PLANES = GRASS_HULL_PLANES; // Most faces of a collider: each costs one dot product for every knot near it.
	static constexpr int MAX_POINTS = 200; // Most distinct points, with those that thickening adds; a bound replaces larger hulls.

	// Planes around the centre: n.xyz, d; inside: n.x <= d. Normals have unit length and point outwards; coplanar faces are merged. Metres.
	// Empty if no point was finite.
	std::vector<Eigen::Vector4f> planes;
	Eigen::Vector3d centre = Eigen::Vector3d::Zero(); // Centre of the points' box, in the points' space. Metres.
	Eigen::Vector3d half_extents = Eigen::Vector3d::Zero(); // Half extents of that box, thickened like the planes. Metres.
	double radius = 0.0; // Radius of a sphere around the centre that encloses the hull. Metres.
	bool is_bound = false; // True if the planes form a 26-sided bound, since the hull had too many points or faces.

	// Points in a plane, on a line or in a single place get MIN_THICKNESS in the missing directions. Points that are not finite or lie
	// beyond 100 km are left out.
	static constexpr double MIN_THICKNESS = 1e-3; // Metres, each side of the plane.
	static constexpr double MAX_COORDINATE = 1e5; // Metres.
	static Hull make(std::span<const Eigen::Vector3d> p_points);
	// Returns the 26-sided bound of finite points, p_margin metres wider on each side: for points that move from tick to tick.
	static Hull make_bound(std::span<const Eigen::Vector3d> p_points, double p_margin);
};

} // namespace grass
