// SPDX-License-Identifier: MIT
// The area where a brush or a game's tool acts on the map: a convex shape on the ground, with a soft border.
#pragma once

#include "core/map/map_stamp.h"

#include <Eigen/Core>

#include <memory>
#include <span>
#include <vector>

namespace grass {

// How the effect fades from full to none across the soft border.
enum class Falloff {
	SMOOTH,
	LINEAR,
	SPHERE, // stays strong, drops near the border
	SHARP, // drops at once, fades out slowly
};

// All places within `radius` of the convex hull of `points`: one point makes a disc, two make a stroke from one to the other, more make a
// polygon. Metres.
class MapShape {
public:
	static constexpr double MAX_EXTENT = 4096.0; // metres from one end to the other

	MapShape() = default; // empty
	// p_softness: width of the soft border, inside which the effect fades, metres; 0: a hard border. Values that are not finite, negative
	// or too large make an empty shape.
	MapShape(std::span<const Eigen::Vector2d> p_points, double p_radius, double p_softness = 0.0, Falloff p_falloff = Falloff::SMOOTH);
	// Makes the shape of a stroke. p_hardness: share of the radius that gets the full effect, 0..1.
	static MapShape stroke(
			const Eigen::Vector2d &p_from, const Eigen::Vector2d &p_to, double p_radius, double p_hardness, Falloff p_falloff);

	// Makes a square of 2 * p_radius metres around p_middle, in which p_stamp sets the strength of the effect. p_turn: radians, from x
	// towards z.
	static MapShape stamped(
			const Eigen::Vector2d &p_middle, double p_radius, double p_turn, const std::shared_ptr<const MapStamp> &p_stamp);

	bool is_empty() const { return _corners.empty(); }
	// Returns the distance to the border in metres, negative inside.
	double get_distance(const Eigen::Vector2d &p_place) const;
	// Returns the strength of the effect, from 0 outside to 1.
	double get_weight(const Eigen::Vector2d &p_place) const;
	// Returns the greatest strength in a square of 2 * p_half metres around p_centre.
	double get_most_weight(const Eigen::Vector2d &p_centre, double p_half) const;
	Eigen::Vector2d get_min() const { return _min; }
	Eigen::Vector2d get_max() const { return _max; }

private:
	Eigen::Vector2d get_nearest(const Eigen::Vector2d &p_place) const; // of the hull

	std::vector<Eigen::Vector2d> _corners; // of the hull, in order
	std::shared_ptr<const MapStamp> _stamp; // null: the effect is full inside the soft border
	Eigen::Vector2d _middle = Eigen::Vector2d::Zero(), _across = Eigen::Vector2d::Zero(); // of the stamp; _across: half its width, metres
	double _radius = 0.0, _softness = 0.0;
	Falloff _falloff = Falloff::SMOOTH;
	Eigen::Vector2d _min = Eigen::Vector2d::Zero(), _max = Eigen::Vector2d::Zero();
};

} // namespace grass
