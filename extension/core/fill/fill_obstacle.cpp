// SPDX-License-Identifier: MIT
#include "core/fill/fill_obstacle.h"

#include "core/base/plane.h"
#include "core/fill/fill_rule.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace grass {

namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();
// A shape that ends up to this far below the ground still counts as lying on it: a floor flush with the ground. Metres.
constexpr double SUNK = 0.25;
// Iterations of the search for the nearest height. Each cuts a third off the column; together they narrow it to 1/400.
constexpr int SEARCH_STEPS = 15;

// Returns a point's distance from a box, given its distances from the sides; negative inside.
template <int N> double out_of(const Eigen::Array<double, N, 1> &p_distances) {
	return p_distances.max(0.0).matrix().norm() + std::min(p_distances.maxCoeff(), 0.0);
}

// Returns a distance in the shape's own space. It is convex along every line.
double distance_to(const ColliderShape &p_shape, const Eigen::Vector3d &p_at) {
	switch (p_shape.type) {
		case GRASS_CAPSULE:
			return (p_at - Eigen::Vector3d(0.0, std::clamp(p_at.y(), -p_shape.size.y(), p_shape.size.y()), 0.0)).norm() - p_shape.size.x();
		case GRASS_BOX:
			return out_of<3>(p_at.array().abs() - p_shape.size.array());
		case GRASS_CYLINDER:
			return out_of<2>({ std::hypot(p_at.x(), p_at.z()) - p_shape.size.x(), std::abs(p_at.y()) - p_shape.size.y() });
		case GRASS_HULL: {
			double distance = -INFINITE;
			for (const Eigen::Vector4f &plane : p_shape.planes) {
				distance = std::max(distance, plane.head<3>().cast<double>().dot(p_at) - double(plane.w()));
			}
			return p_shape.planes.empty() ? INFINITE : distance;
		}
		default:
			return p_at.norm() - p_shape.size.x();
	}
}

std::vector<Eigen::Vector2d> corners_of(const ColliderShape &p_shape, const Eigen::Affine3d &p_pose) {
	const Eigen::Vector3d half = p_shape.get_half_extents();
	std::vector<Eigen::Vector2d> corners;
	for (int n = 0; n < 8; n++) {
		const Eigen::Vector3d sign(n & 1 ? 1.0 : -1.0, n & 2 ? 1.0 : -1.0, n & 4 ? 1.0 : -1.0);
		const Eigen::Vector3d corner = p_pose * half.cwiseProduct(sign).eval();
		corners.push_back({ corner.x(), corner.z() });
	}
	return corners;
}

std::vector<Eigen::Vector2d> from_above(std::span<const Eigen::Vector3d> p_points) {
	std::vector<Eigen::Vector2d> places;
	for (const Eigen::Vector3d &point : p_points) {
		places.push_back({ point.x(), point.z() });
	}
	return places;
}

} // namespace

FillObstacle::FillObstacle(Kind p_kind, std::span<const Eigen::Vector2d> p_extent) : _kind(p_kind) {
	_min.setConstant(INFINITE);
	_max.setConstant(-INFINITE);
	for (const Eigen::Vector2d &point : p_extent) {
		if (!(point.array().abs() <= MAX_POSITION).all()) {
			_min.setConstant(INFINITE);
			return;
		}
		_min = _min.cwiseMin(point);
		_max = _max.cwiseMax(point);
	}
}

FillObstacle FillObstacle::solid(const ColliderShape &p_shape, const Eigen::Affine3d &p_pose, double p_height) {
	const double volume = std::abs(p_pose.linear().determinant());
	const bool is_usable = volume > 1e-12 && std::isfinite(volume);
	FillObstacle made(Kind::SOLID, is_usable ? corners_of(p_shape, p_pose) : std::vector<Eigen::Vector2d>());
	made._shape = p_shape;
	made._height = p_height;
	if (is_usable) {
		made._to_shape = p_pose.inverse().affine();
		made._scale = std::cbrt(volume);
	}
	return made;
}

FillObstacle FillObstacle::outline(std::vector<Eigen::Vector2d> p_corners) {
	const bool is_area = p_corners.size() >= 3;
	FillObstacle made(Kind::OUTLINE, is_area ? std::span<const Eigen::Vector2d>(p_corners) : std::span<const Eigen::Vector2d>());
	made._points = std::move(p_corners);
	return made;
}

FillObstacle FillObstacle::line(std::vector<Eigen::Vector2d> p_points) {
	FillObstacle made(Kind::LINE, p_points);
	made._points = std::move(p_points);
	return made;
}

FillObstacle FillObstacle::mesh(std::vector<Eigen::Vector3d> p_corners, double p_height) {
	p_corners.resize(p_corners.size() / 3 * 3);
	FillObstacle made(Kind::MESH, from_above(p_corners));
	made._corners = std::move(p_corners);
	made._height = p_height;
	return made;
}

void FillObstacle::set_clearance(double p_distance, double p_fade) {
	_distance = std::max(p_distance, 0.0);
	_fade = std::max(p_fade, 0.0);
}

// The height of the ground counts for the distance from solids and meshes only.
bool FillObstacle::may_change(const Eigen::Vector2d &p_at) const {
	const bool is_near = (p_at.array() >= get_min().array()).all() && (p_at.array() <= get_max().array()).all();
	return is_near && (_kind == Kind::SOLID || _kind == Kind::MESH || get_share({ p_at, 0.0 }) < 1.0);
}

// The box around a winding path contains many squares that the path does not come near to.
bool FillObstacle::reaches(const Eigen::Array2d &p_low, const Eigen::Array2d &p_high) const {
	if (is_nowhere() || (get_min().array() > p_high).any() || (get_max().array() < p_low).any()) {
		return false;
	}
	const Eigen::Vector2d centre = 0.5 * (p_low + p_high).matrix(), half = 0.5 * (p_high - p_low).matrix();
	return _kind != Kind::LINE || outline_distance(centre) <= half.norm() + _distance + _fade;
}

double FillObstacle::get_share(const FillPlace &p_place) const {
	const Eigen::Array2d at = p_place.at.array();
	if (is_nowhere() || (at < get_min().array()).any() || (at > get_max().array()).any()) {
		return 1.0;
	}
	return 1.0 - fade_out(get_distance(p_place), _distance, _fade);
}

double FillObstacle::get_distance(const FillPlace &p_place) const {
	if (is_nowhere()) {
		return INFINITE;
	}
	switch (_kind) {
		case Kind::SOLID:
			return solid_distance(p_place);
		case Kind::MESH:
			return mesh_distance(p_place);
		default:
			return outline_distance(p_place.at);
	}
}

// Returns the distance to the column above the ground at p_place. The distance to a convex shape is convex along the column, so a ternary
// search finds its minimum.
double FillObstacle::solid_distance(const FillPlace &p_place) const {
	const auto distance_at = [&](double p_y) {
		const Eigen::Vector4d at(p_place.at.x(), p_y, p_place.at.y(), 1.0);
		return distance_to(_shape, _to_shape * at) * _scale;
	};
	double low = p_place.ground - SUNK, high = p_place.ground + _height;
	for (int step = 0; step < SEARCH_STEPS; step++) {
		const double third = (high - low) / 3.0;
		if (distance_at(low + third) < distance_at(high - third)) {
			high -= third;
		} else {
			low += third;
		}
	}
	return distance_at(0.5 * (low + high));
}

double FillObstacle::outline_distance(const Eigen::Vector2d &p_at) const {
	const bool is_closed = _kind == Kind::OUTLINE;
	double nearest = _points.size() == 1 ? (p_at - _points[0]).norm() : INFINITE;
	bool inside = false;
	for (size_t i = is_closed ? 0 : 1; i < _points.size(); i++) {
		const Eigen::Vector2d &a = _points[i == 0 ? _points.size() - 1 : i - 1], &b = _points[i];
		nearest = std::min(nearest, distance_to_segment(p_at, a, b));
		if (is_closed && (a.y() > p_at.y()) != (b.y() > p_at.y())) { // an edge that a ray along x may cross
			inside = inside != (cross(b - a, p_at - a) * (b.y() - a.y()) > 0.0);
		}
	}
	return inside ? 0.0 : nearest;
}

double FillObstacle::mesh_distance(const FillPlace &p_place) const {
	const double margin = _distance + _fade;
	const Eigen::Array2d near_min = p_place.at.array() - margin, near_max = p_place.at.array() + margin;
	double nearest = INFINITE;
	for (size_t i = 0; i < _corners.size() && nearest > 0.0; i += 3) {
		const Eigen::Vector3d *corner = &_corners[i];
		const Eigen::Vector2d flat[] = { { corner[0].x(), corner[0].z() }, { corner[1].x(), corner[1].z() },
			{ corner[2].x(), corner[2].z() } };
		const Eigen::Array2d low = flat[0].cwiseMin(flat[1]).cwiseMin(flat[2]), high = flat[0].cwiseMax(flat[1]).cwiseMax(flat[2]);
		const double lowest = std::min({ corner[0].y(), corner[1].y(), corner[2].y() }),
					 highest = std::max({ corner[0].y(), corner[1].y(), corner[2].y() });
		if ((low > near_max).any() || (high < near_min).any() || lowest > p_place.ground + _height || highest < p_place.ground - SUNK) {
			continue;
		}
		int left = 0, right = 0;
		for (int side = 0; side < 3; side++) {
			const Eigen::Vector2d &a = flat[side], &b = flat[(side + 1) % 3];
			nearest = std::min(nearest, distance_to_segment(p_place.at, a, b));
			const double turn = cross(b - a, p_place.at - a);
			left += turn >= 0.0;
			right += turn <= 0.0;
		}
		const bool has_area = std::abs(cross(flat[1] - flat[0], flat[2] - flat[0])) > 1e-12; // a vertical triangle has none from above
		nearest = has_area && (left == 3 || right == 3) ? 0.0 : nearest;
	}
	return nearest;
}

} // namespace grass
