// SPDX-License-Identifier: MIT
// The ground below a solid shape: what a mower's deck, or the region of a game's query, covers.
#pragma once

#include "core/bodies/body_shape.h"

#include <optional>

namespace grass {

class Footprint {
public:
	// Takes p_shape at its pose `now`, field space. A shape that ColliderShape::sanitise() rejects covers nothing.
	explicit Footprint(const ColliderShape &p_shape);

	bool is_empty() const { return !_usable; }
	Eigen::Vector2d get_min() const { return _min; }
	Eigen::Vector2d get_max() const { return _max; }
	Eigen::Vector2d get_centre() const { return 0.5 * (_min + _max); }

	// The lowest and the highest point of the shape above a place (x, z in metres), in metres above the field.
	struct Span {
		double low, high;
	};
	std::optional<Span> get_span(const Eigen::Vector2d &p_place) const;

private:
	ColliderShape _shape;
	bool _usable = false;
	Eigen::Matrix3d _to_shape;
	Eigen::Vector2d _min = Eigen::Vector2d::Zero(), _max = Eigen::Vector2d::Zero();
};

} // namespace grass
