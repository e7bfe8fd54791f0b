// SPDX-License-Identifier: MIT
// Something that keeps filled grass away, or plants it: a solid shape, an outline on the ground, a point or a line to keep a distance from,
// a mesh above the ground. Map space: x, z in metres from the field's centre, heights above the field.
#pragma once

#include "core/bodies/body_shape.h"

#include <span>

namespace grass {

// A place on the ground.
struct FillPlace {
	Eigen::Vector2d at = Eigen::Vector2d::Zero(); // x, z in metres
	double ground = 0.0; // metres above the field
};

class FillObstacle {
public:
	static constexpr double MAX_POSITION = 1e6; // metres; anything farther away is ignored

	// Covers a solid shape. p_pose: from the shape's space, may scale. p_height: grass grows under a shape that begins higher above the
	// ground than this, metres.
	static FillObstacle solid(const ColliderShape &p_shape, const Eigen::Affine3d &p_pose, double p_height);
	// Covers the inside of an outline, convex or not, at any height.
	static FillObstacle outline(std::vector<Eigen::Vector2d> p_corners);
	// Covers one point, or a line through several.
	static FillObstacle line(std::vector<Eigen::Vector2d> p_points);
	// Covers the ground under triangles (three corners each), where they are above it and no higher than p_height.
	static FillObstacle mesh(std::vector<Eigen::Vector3d> p_corners, double p_height);

	// Sets the distance up to which nothing grows, and the further distance over which grass returns to full. Metres.
	void set_clearance(double p_distance, double p_fade);
	// If set, grass grows here whatever the rule's conditions say, instead of being kept away.
	void set_planting(bool p_plants) { _plants = p_plants; }
	bool is_planting() const { return _plants; }

	// Returns the share of the grass that is left: 0 within its distance .. 1. For an obstacle that plants, 1 minus this is the share that
	// it plants.
	double get_share(const FillPlace &p_place) const;
	// Returns whether it changes the grass there with the ground at some height, or lies in the box around such places.
	bool may_change(const Eigen::Vector2d &p_at) const;
	// Returns the distance in metres, horizontal for all but solid shapes; 0 or less inside.
	double get_distance(const FillPlace &p_place) const;
	// The rectangle outside which it changes nothing; empty (min > max) if it affects no place.
	Eigen::Vector2d get_min() const { return _min.array() - (_distance + _fade); }
	Eigen::Vector2d get_max() const { return _max.array() + (_distance + _fade); }
	// Returns false if it changes nothing in this square.
	bool reaches(const Eigen::Array2d &p_low, const Eigen::Array2d &p_high) const;
	bool is_nowhere() const { return !(_min.array() <= _max.array()).all(); }

private:
	enum class Kind { SOLID, OUTLINE, LINE, MESH };

	FillObstacle(Kind p_kind, std::span<const Eigen::Vector2d> p_extent);
	double solid_distance(const FillPlace &p_place) const;
	double outline_distance(const Eigen::Vector2d &p_at) const;
	double mesh_distance(const FillPlace &p_place) const;

	Kind _kind;
	bool _plants = false;
	double _distance = 0.0, _fade = 0.0, _height = 0.0;
	Eigen::Vector2d _min, _max; // bounds of the shape itself
	ColliderShape _shape;
	Eigen::Matrix<double, 3, 4, Eigen::DontAlign> _to_shape; // transform from map space
	double _scale = 1.0; // metres of the map for each metre of the shape
	std::vector<Eigen::Vector2d> _points; // outline, line
	std::vector<Eigen::Vector3d> _corners; // mesh
};

} // namespace grass
