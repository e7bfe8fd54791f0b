// SPDX-License-Identifier: MIT
// The ring on the ground that shows where a brush will act.
#pragma once

#include <Eigen/Core>

#include <span>
#include <vector>

namespace grass {

// Returns p_count places at even angles around a circle, from +x towards +z.
std::vector<Eigen::Vector2d> circle_places(const Eigen::Vector2d &p_centre, double p_radius, int p_count);

// Returns the centre of a disc, then p_rings circles of p_count places each, outwards.
std::vector<Eigen::Vector2d> disc_places(const Eigen::Vector2d &p_centre, double p_radius, int p_rings, int p_count);
// Returns the triangles between these places, three indices each.
std::vector<int> disc_triangles(int p_rings, int p_count);

// Returns a closed band along a loop of points that looks p_width wide everywhere. p_width is in units of the distance from the eye, so 2 *
// tan(fov / 2) / height makes it one pixel. The result is triangles, three vertices each, six for each point. Where the loop runs towards
// the eye or does not move, the band has no width.
std::vector<Eigen::Vector3d> ring_band(std::span<const Eigen::Vector3d> p_loop, const Eigen::Vector3d &p_eye, double p_width);

} // namespace grass
