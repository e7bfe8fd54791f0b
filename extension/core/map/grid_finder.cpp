// SPDX-License-Identifier: MIT
#include "core/map/grid_finder.h"

#include <Eigen/Geometry>

namespace grass {

namespace {

constexpr double NEARLY_ALL = 0.99; // of the corners, or of the edges; the others are of a border
constexpr double TOLERANCE = 0.01; // metres that a corner may be off: places of scenes have single precision
constexpr double LEVEL = 1e-4; // sine of the angle by which triangles of a plane may differ

double to_whole(double p_metres) {
	return std::abs(p_metres - std::round(p_metres));
}

} // namespace

void GridFinder::add(const Eigen::Vector3d &p_a, const Eigen::Vector3d &p_b, const Eigen::Vector3d &p_c) {
	Eigen::Vector3d normal = (p_b - p_a).cross(p_c - p_a);
	const double area = normal.norm();
	if (!normal.allFinite() || !(std::abs(normal.y()) > 1e-3 * area)) {
		return;
	}
	normal /= normal.y() < 0.0 ? -area : area;
	_normal = _triangles.empty() ? normal : _normal;
	_is_plane = _is_plane && normal.cross(_normal).norm() < LEVEL;
	const auto flat = [](const Eigen::Vector3d &p_corner) { return Eigen::Vector2d(p_corner.x(), p_corner.z()); };
	_triangles.push_back({ flat(p_a), flat(p_b), flat(p_c) });
}

bool GridFinder::have_vertices_at(const GroundGrid &p_grid) const {
	const Eigen::Vector2d height = p_grid.offset() + Eigen::Vector2d(0.5, 0.5);
	size_t count = 0;
	for (const Triangle &triangle : _triangles) {
		for (const Eigen::Vector2d &corner : triangle) {
			count += to_whole(corner.x() - height.x()) < TOLERANCE && to_whole(corner.y() - height.y()) < TOLERANCE ? 1 : 0;
		}
	}
	return double(count) >= NEARLY_ALL * 3.0 * double(_triangles.size());
}

// Finds the split by the edges that run aslant.
GroundSplit GridFinder::find_split() const {
	double across = 0.0, beside = 0.0;
	for (const Triangle &triangle : _triangles) {
		for (size_t n = 0; n < 3; n++) {
			const Eigen::Vector2d edge = triangle[(n + 1) % 3] - triangle[n];
			const bool is_diagonal = std::abs(edge.x()) > 0.5 && std::abs(std::abs(edge.x()) - std::abs(edge.y())) < TOLERANCE;
			across += is_diagonal && edge.x() * edge.y() > 0.0 ? 1.0 : 0.0;
			beside += is_diagonal && edge.x() * edge.y() < 0.0 ? 1.0 : 0.0;
		}
	}
	const double most = NEARLY_ALL * double(_triangles.size()); // each triangle has one
	return across >= most ? GroundSplit::ACROSS : (beside >= most ? GroundSplit::BESIDE : GroundSplit::BLENDED);
}

std::optional<GroundGrid> GridFinder::find() const {
	if (_is_plane) {
		return {};
	}
	for (const size_t n : { size_t(0), _triangles.size() / 2, _triangles.size() - 1 }) { // one of them may be of a border
		const GroundGrid grid = GroundGrid::at(_triangles[n][0], GroundSplit::BLENDED);
		if (have_vertices_at(grid)) {
			return GroundGrid{ grid.x, grid.z, find_split() };
		}
	}
	return {};
}

} // namespace grass
