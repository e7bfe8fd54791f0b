// SPDX-License-Identifier: MIT
#include "core/map/map_shape.h"

#include "core/base/plane.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace grass {

namespace {

bool is_before(const Eigen::Vector2d &p_a, const Eigen::Vector2d &p_b) {
	return p_a.x() != p_b.x() ? p_a.x() < p_b.x() : p_a.y() < p_b.y();
}

// Returns the corners of the convex hull, counter-clockwise (x to the right, z up): Andrew's monotone chain.
std::vector<Eigen::Vector2d> hull_of(std::span<const Eigen::Vector2d> p_points) {
	std::vector<Eigen::Vector2d> points(p_points.begin(), p_points.end());
	std::sort(points.begin(), points.end(), is_before);
	points.erase(std::unique(points.begin(), points.end()), points.end());
	if (points.size() < 3) {
		return points;
	}
	std::vector<Eigen::Vector2d> hull;
	for (int side = 0; side < 2; side++) {
		const size_t first = hull.size();
		for (const Eigen::Vector2d &point : points) {
			while (hull.size() >= first + 2 && cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0) {
				hull.pop_back();
			}
			hull.push_back(point);
		}
		hull.pop_back(); // it is the start of the other side
		std::reverse(points.begin(), points.end());
	}
	return hull;
}

double fade(double p_t, Falloff p_falloff) {
	switch (p_falloff) {
		case Falloff::LINEAR:
			return p_t;
		case Falloff::SPHERE:
			return std::sqrt(p_t * (2.0 - p_t));
		case Falloff::SHARP:
			return p_t * p_t;
		default:
			return p_t * p_t * (3.0 - 2.0 * p_t);
	}
}

} // namespace

MapShape::MapShape(std::span<const Eigen::Vector2d> p_points, double p_radius, double p_softness, Falloff p_falloff) {
	bool usable = !p_points.empty() && p_radius >= 0.0 && p_radius <= MAX_EXTENT && p_softness >= 0.0;
	Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
	for (const Eigen::Vector2d &point : p_points) {
		usable = usable && point.allFinite();
		low = low.min(point.array());
		high = high.max(point.array());
	}
	if (!usable || ((high - low) > MAX_EXTENT).any()) {
		return;
	}
	_corners = hull_of(p_points);
	_radius = p_radius;
	_softness = p_softness;
	_falloff = p_falloff;
	_min = low - p_radius;
	_max = high + p_radius;
}

MapShape MapShape::stroke(
		const Eigen::Vector2d &p_from, const Eigen::Vector2d &p_to, double p_radius, double p_hardness, Falloff p_falloff) {
	const Eigen::Vector2d ends[] = { p_from, p_to };
	return MapShape(ends, p_radius, p_radius * (1.0 - std::clamp(p_hardness, 0.0, 1.0)), p_falloff);
}

MapShape MapShape::stamped(
		const Eigen::Vector2d &p_middle, double p_radius, double p_turn, const std::shared_ptr<const MapStamp> &p_stamp) {
	if (!std::isfinite(p_turn) || !(p_radius > 0.0)) {
		return MapShape();
	}
	const Eigen::Vector2d across = p_radius * Eigen::Vector2d(std::cos(p_turn), std::sin(p_turn)), down(-across.y(), across.x());
	const Eigen::Vector2d corners[] = { p_middle - across - down, p_middle + across - down, p_middle + across + down,
		p_middle - across + down };
	MapShape shape(corners, 0.0);
	shape._stamp = p_stamp;
	shape._middle = p_middle;
	shape._across = across;
	return shape;
}

double MapShape::get_distance(const Eigen::Vector2d &p_place) const {
	if (_corners.empty()) {
		return std::numeric_limits<double>::infinity();
	}
	double nearest = std::numeric_limits<double>::infinity();
	bool inside = _corners.size() > 2;
	for (size_t i = 0; i < _corners.size(); i++) {
		const Eigen::Vector2d &a = _corners[i], &b = _corners[(i + 1) % _corners.size()];
		nearest = std::min(nearest, distance_to_segment(p_place, a, b));
		inside = inside && cross(b - a, p_place - a) >= 0.0;
	}
	return (inside ? -nearest : nearest) - _radius;
}

Eigen::Vector2d MapShape::get_nearest(const Eigen::Vector2d &p_place) const {
	Eigen::Vector2d nearest = p_place;
	double least = std::numeric_limits<double>::infinity();
	bool inside = _corners.size() > 2;
	for (size_t i = 0; i < _corners.size(); i++) {
		const Eigen::Vector2d &a = _corners[i], &b = _corners[(i + 1) % _corners.size()];
		const Eigen::Vector2d point = nearest_on_segment(p_place, a, b);
		if (const double distance = (p_place - point).norm(); distance < least) {
			least = distance;
			nearest = point;
		}
		inside = inside && cross(b - a, p_place - a) >= 0.0;
	}
	return inside ? p_place : nearest;
}

// Projects back and forth between the two convex sets, which converges to their nearest points.
double MapShape::get_most_weight(const Eigen::Vector2d &p_centre, double p_half) const {
	constexpr int ROUNDS = 8; // one suffices for a disc
	if (_corners.empty() || get_distance(p_centre) > p_half * std::numbers::sqrt2) {
		return 0.0;
	}
	Eigen::Vector2d place = p_centre;
	for (int round = 0; round < (_corners.size() > 1 ? ROUNDS : 1); round++) {
		place = get_nearest(place).array().max(p_centre.array() - p_half).min(p_centre.array() + p_half).matrix();
	}
	return std::max(get_weight(place), get_weight(p_centre));
}

double MapShape::get_weight(const Eigen::Vector2d &p_place) const {
	if (_stamp != nullptr && !is_empty()) {
		const Eigen::Vector2d from = p_place - _middle, down(-_across.y(), _across.x());
		const double scale = 0.5 / _across.squaredNorm();
		return _stamp->get_weight({ 0.5 + scale * from.dot(_across), 0.5 + scale * from.dot(down) });
	}
	const double depth = -get_distance(p_place);
	if (!(depth >= 0.0)) {
		return 0.0;
	}
	return depth >= _softness ? 1.0 : fade(depth / _softness, _falloff);
}

} // namespace grass
