// SPDX-License-Identifier: MIT
#include "core/paint/footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace grass {

namespace {

// The part of a straight line, origin + t * direction, inside a convex solid.
class Line {
public:
	Line(const Eigen::Vector3d &p_origin, const Eigen::Vector3d &p_direction) : _origin(p_origin), _direction(p_direction) {}

	// Keeps the part with n.x <= d.
	void clip(const Eigen::Vector3d &p_normal, double p_distance) {
		const double speed = p_normal.dot(_direction), left = p_distance - p_normal.dot(_origin);
		if (speed > 0.0) {
			_high = std::min(_high, left / speed);
		} else if (speed < 0.0) {
			_low = std::max(_low, left / speed);
		} else if (left < 0.0) {
			_is_empty = true;
		}
	}
	// Keeps the part within p_radius of the y axis, or of a point on it if p_centre is given.
	void clip_round(double p_radius, std::optional<double> p_centre = {}) {
		const Eigen::Vector3d weights(1.0, p_centre ? 1.0 : 0.0, 1.0);
		const Eigen::Vector3d from = (_origin - Eigen::Vector3d(0.0, p_centre.value_or(0.0), 0.0)).cwiseProduct(weights);
		const Eigen::Vector3d along = _direction.cwiseProduct(weights);
		const double a = along.squaredNorm(), b = from.dot(along), c = from.squaredNorm() - p_radius * p_radius;
		const double inside = b * b - a * c;
		if (a < 1e-18) {
			_is_empty = _is_empty || c > 0.0;
		} else if (inside < 0.0) {
			_is_empty = true;
		} else {
			_low = std::max(_low, (-b - std::sqrt(inside)) / a);
			_high = std::min(_high, (-b + std::sqrt(inside)) / a);
		}
	}
	void clip_ends(double p_half) {
		clip(Eigen::Vector3d::UnitY(), p_half);
		clip(-Eigen::Vector3d::UnitY(), p_half);
	}
	bool is_empty() const { return _is_empty || !(_low <= _high); }
	double get_low() const { return _low; }
	double get_high() const { return _high; }

private:
	Eigen::Vector3d _origin, _direction;
	bool _is_empty = false;
	double _low = -std::numeric_limits<double>::infinity(), _high = std::numeric_limits<double>::infinity();
};

} // namespace

Footprint::Footprint(const ColliderShape &p_shape) : _shape(p_shape) {
	const char *reason = nullptr;
	_shape.before = _shape.now;
	_usable = _shape.sanitise(reason);
	if (_usable) {
		const Bounds bounds = _shape.get_swept_bounds();
		_min = { bounds.min.x(), bounds.min.z() };
		_max = { bounds.max.x(), bounds.max.z() };
		_to_shape = _shape.now.rotation.toRotationMatrix().transpose();
	}
}

std::optional<Footprint::Span> Footprint::get_span(const Eigen::Vector2d &p_place) const {
	if (!_usable || (p_place.array() < _min.array()).any() || (p_place.array() > _max.array()).any()) {
		return {};
	}
	const Eigen::Vector3d foot(p_place.x(), 0.0, p_place.y());
	Line line(_to_shape * (foot - _shape.now.position), _to_shape * Eigen::Vector3d::UnitY());
	switch (_shape.type) {
		case GRASS_SPHERE:
			line.clip_round(_shape.size.x(), 0.0);
			break;
		case GRASS_CYLINDER:
			line.clip_round(_shape.size.x());
			line.clip_ends(_shape.size.y());
			break;
		case GRASS_CAPSULE: { // a cylinder and two balls: the hull of the line's parts in each
			Line parts[] = { line, line, line };
			parts[0].clip_round(_shape.size.x());
			parts[0].clip_ends(_shape.size.y());
			parts[1].clip_round(_shape.size.x(), _shape.size.y());
			parts[2].clip_round(_shape.size.x(), -_shape.size.y());
			std::optional<Span> span;
			for (const Line &part : parts) {
				if (!part.is_empty()) {
					span = span ? Span{ std::min(span->low, part.get_low()), std::max(span->high, part.get_high()) }
								: Span{ part.get_low(), part.get_high() };
				}
			}
			return span;
		}
		case GRASS_BOX:
			for (int axis = 0; axis < 3; axis++) {
				line.clip(Eigen::Vector3d::Unit(axis), _shape.size[axis]);
				line.clip(-Eigen::Vector3d::Unit(axis), _shape.size[axis]);
			}
			break;
		default:
			for (const Eigen::Vector4f &plane : _shape.planes) {
				line.clip(plane.head<3>().cast<double>(), double(plane.w()));
			}
	}
	return line.is_empty() || !std::isfinite(line.get_low()) || !std::isfinite(line.get_high())
			? std::nullopt
			: std::optional<Span>({ line.get_low(), line.get_high() });
}

} // namespace grass
