// SPDX-License-Identifier: MIT
#include "core/paint/brush_ring.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace grass {

std::vector<Eigen::Vector2d> circle_places(const Eigen::Vector2d &p_centre, double p_radius, int p_count) {
	std::vector<Eigen::Vector2d> places;
	for (int i = 0; i < p_count; i++) {
		const double angle = 2.0 * std::numbers::pi * i / p_count;
		places.push_back(p_centre + p_radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
	}
	return places;
}

std::vector<Eigen::Vector2d> disc_places(const Eigen::Vector2d &p_centre, double p_radius, int p_rings, int p_count) {
	std::vector<Eigen::Vector2d> places = { p_centre };
	for (int ring = 1; ring <= p_rings; ring++) {
		const std::vector<Eigen::Vector2d> circle = circle_places(p_centre, p_radius * ring / p_rings, p_count);
		places.insert(places.end(), circle.begin(), circle.end());
	}
	return places;
}

std::vector<int> disc_triangles(int p_rings, int p_count) {
	std::vector<int> triangles;
	const auto number = [&](int p_ring, int p_i) { return p_ring < 0 ? 0 : 1 + p_ring * p_count + p_i % p_count; };
	for (int ring = 0; ring < p_rings; ring++) {
		for (int i = 0; i < p_count; i++) {
			const int inner = number(ring - 1, i), outer = number(ring, i), next = number(ring, i + 1);
			triangles.insert(triangles.end(), { inner, outer, next });
			if (ring > 0) {
				triangles.insert(triangles.end(), { inner, next, number(ring - 1, i + 1) });
			}
		}
	}
	return triangles;
}

std::vector<Eigen::Vector3d> ring_band(std::span<const Eigen::Vector3d> p_loop, const Eigen::Vector3d &p_eye, double p_width) {
	const size_t count = p_loop.size();
	std::vector<Eigen::Vector3d> sides; // half the band's width at each point
	for (size_t i = 0; i < count; i++) {
		const Eigen::Vector3d along = p_loop[(i + 1) % count] - p_loop[(i + count - 1) % count], sight = p_loop[i] - p_eye;
		sides.push_back(along.cross(sight).stableNormalized() * (0.5 * p_width * sight.stableNorm()));
	}
	std::vector<Eigen::Vector3d> triangles;
	for (size_t i = 0; i < count; i++) {
		const size_t j = (i + 1) % count;
		const Eigen::Vector3d a = p_loop[i] - sides[i], b = p_loop[i] + sides[i], c = p_loop[j] - sides[j], d = p_loop[j] + sides[j];
		triangles.insert(triangles.end(), { a, b, c, c, b, d });
	}
	return triangles;
}

} // namespace grass
