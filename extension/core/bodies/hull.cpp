// SPDX-License-Identifier: MIT
#include "core/bodies/hull.h"

#include "core/base/plane.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace grass {

namespace {

using HullPoints = std::vector<Eigen::Vector3d>;

struct HullPlane {
	Eigen::Vector3d normal;
	double distance;
};

// Returns how far the points reach along p_normal.
double get_support(const HullPoints &p_points, const Eigen::Vector3d &p_normal) {
	double support = p_normal.dot(p_points.front());
	for (const Eigen::Vector3d &point : p_points) {
		support = std::max(support, p_normal.dot(point));
	}
	return support;
}

// Returns the valid points, each once.
HullPoints collect(std::span<const Eigen::Vector3d> p_points) {
	HullPoints points;
	std::copy_if(p_points.begin(), p_points.end(), std::back_inserter(points),
			[](const Eigen::Vector3d &p_point) { return p_point.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= Hull::MAX_COORDINATE; });
	const auto is_less = [](const Eigen::Vector3d &p_a, const Eigen::Vector3d &p_b) {
		return std::lexicographical_compare(p_a.begin(), p_a.end(), p_b.begin(), p_b.end());
	};
	std::sort(points.begin(), points.end(), is_less);
	points.erase(std::unique(points.begin(), points.end()), points.end());
	return points;
}

// Moves the points so that their box is centred at the origin. Returns where its centre was.
Eigen::Vector3d centre_points(HullPoints &r_points) {
	Eigen::Vector3d low = r_points.front(), high = r_points.front();
	for (const Eigen::Vector3d &point : r_points) {
		low = low.cwiseMin(point);
		high = high.cwiseMax(point);
	}
	const Eigen::Vector3d centre = 0.5 * (low + high);
	for (Eigen::Vector3d &point : r_points) {
		point -= centre;
	}
	return centre;
}

// Doubles points that lie in a plane, on a line or in one place, to both sides of each direction in which they are thinner than
// MIN_THICKNESS.
void thicken(HullPoints &r_points) {
	Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
	for (const Eigen::Vector3d &point : r_points) {
		covariance += (point - r_points.front()) * (point - r_points.front()).transpose();
	}
	const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
	for (int i = 0; i < 3; i++) {
		const Eigen::Vector3d axis = solver.eigenvectors().col(i);
		if (get_support(r_points, axis) + get_support(r_points, -axis) < 2.0 * Hull::MIN_THICKNESS) {
			const size_t count = r_points.size();
			for (size_t j = 0; j < count; j++) {
				r_points.push_back(r_points[j] + axis * Hull::MIN_THICKNESS);
				r_points[j] -= axis * Hull::MIN_THICKNESS;
			}
		}
	}
}

// Adds the plane through p_point, unless points lie beyond it or it was added already.
void add_face(const HullPoints &p_points, const Eigen::Vector3d &p_point, const Eigen::Vector3d &p_normal, double p_tolerance,
		std::vector<HullPlane> &r_planes) {
	constexpr double SAME_DIRECTION = 1.0 - 5e-9; // cosine of 1e-4 rad
	const double distance = get_support(p_points, p_normal);
	const auto is_same = [&](const HullPlane &p_plane) {
		return p_plane.normal.dot(p_normal) > SAME_DIRECTION && std::abs(p_plane.distance - distance) <= 4.0 * p_tolerance;
	};
	if (distance - p_normal.dot(p_point) <= p_tolerance && std::none_of(r_planes.begin(), r_planes.end(), is_same)) {
		r_planes.push_back({ p_normal, distance });
	}
}

// Looks along the line through two points. If all others are within half a turn of it, the line is an edge of the hull, and the outermost
// points on either side span the two faces that meet there.
void add_faces_at_edge(const HullPoints &p_points, size_t p_from, size_t p_to, const Eigen::Vector3d &p_inside, double p_tolerance,
		std::vector<HullPlane> &r_planes) {
	const Eigen::Vector3d along = (p_points[p_to] - p_points[p_from]).normalized();
	const Eigen::Vector3d u = along.unitOrthogonal(), v = along.cross(u);
	const auto see = [&](const Eigen::Vector3d &p_point) {
		const Eigen::Vector3d offset = p_point - p_points[p_from];
		return Eigen::Vector2d(u.dot(offset), v.dot(offset));
	};
	const Eigen::Vector2d middle = see(p_inside);
	if (middle.norm() <= p_tolerance) {
		return; // the line passes through the inside
	}
	Eigen::Vector2d left = middle, right = middle;
	for (const Eigen::Vector3d &point : p_points) {
		const Eigen::Vector2d direction = see(point);
		if (direction.norm() <= p_tolerance) {
			continue; // the point is on the line
		}
		if (cross(middle, direction) >= 0.0) {
			left = cross(left, direction) > 0.0 ? direction : left;
		} else {
			right = cross(right, direction) < 0.0 ? direction : right;
		}
		if (cross(right, left) < -1e-3 * right.norm() * left.norm()) {
			return; // more than half a turn
		}
	}
	left.normalize();
	right.normalize();
	add_face(p_points, p_points[p_from], left.x() * v - left.y() * u, p_tolerance, r_planes);
	add_face(p_points, p_points[p_from], right.y() * u - right.x() * v, p_tolerance, r_planes);
}

// Returns the hull's faces. If there are more than MAX_PLANES, it stops soon after that number.
std::vector<HullPlane> find_planes(const HullPoints &p_points, double p_size) {
	Eigen::Vector3d inside = Eigen::Vector3d::Zero();
	for (const Eigen::Vector3d &point : p_points) {
		inside += point / double(p_points.size());
	}
	std::vector<HullPlane> planes;
	for (size_t i = 0; i < p_points.size(); i++) {
		for (size_t j = i + 1; j < p_points.size() && planes.size() <= size_t(Hull::MAX_PLANES); j++) {
			add_faces_at_edge(p_points, i, j, inside, p_size * 1e-6, planes); // the points may come from single precision
		}
	}
	return planes;
}

// Returns a bound whose normals are the directions to the faces, edges and corners of a cube.
std::vector<HullPlane> find_bound(const HullPoints &p_points) {
	std::vector<HullPlane> planes;
	for (int i = 0; i < 27; i++) {
		const Eigen::Vector3d direction = Eigen::Vector3i(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1).cast<double>();
		if (i != 13) { // skip the cube's centre
			planes.push_back({ direction.normalized(), get_support(p_points, direction.normalized()) });
		}
	}
	return planes;
}

void set_size(const HullPoints &p_points, double p_margin, Hull &r_hull) {
	for (const Eigen::Vector3d &point : p_points) {
		r_hull.half_extents = r_hull.half_extents.cwiseMax(point.cwiseAbs());
		r_hull.radius = std::max(r_hull.radius, point.norm());
	}
	r_hull.half_extents.array() += p_margin;
	r_hull.radius += std::sqrt(3.0) * p_margin;
}

void add_planes(const std::vector<HullPlane> &p_planes, double p_margin, Hull &r_hull) {
	for (const HullPlane &plane : p_planes) {
		const Eigen::Vector3f normal = plane.normal.cast<float>();
		r_hull.planes.emplace_back(normal.x(), normal.y(), normal.z(), float(plane.distance + p_margin));
	}
}

} // namespace

Hull Hull::make(std::span<const Eigen::Vector3d> p_points) {
	Hull hull;
	HullPoints points = collect(p_points);
	if (points.empty()) {
		return hull;
	}
	hull.centre = centre_points(points);
	thicken(points);
	set_size(points, 0.0, hull);
	std::vector<HullPlane> planes;
	if (points.size() <= size_t(MAX_POINTS)) {
		planes = find_planes(points, hull.radius);
	}
	if (planes.size() < 4 || planes.size() > size_t(MAX_PLANES)) {
		planes = find_bound(points);
		hull.is_bound = true;
	}
	add_planes(planes, 0.0, hull);
	return hull;
}

Hull Hull::make_bound(std::span<const Eigen::Vector3d> p_points, double p_margin) {
	Hull hull;
	hull.is_bound = true;
	if (p_points.empty()) {
		return hull;
	}
	HullPoints points(p_points.begin(), p_points.end());
	hull.centre = centre_points(points);
	set_size(points, p_margin, hull);
	add_planes(find_bound(points), p_margin, hull);
	return hull;
}

} // namespace grass
