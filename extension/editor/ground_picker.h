// SPDX-License-Identifier: MIT
// Where the cursor meets the ground: on the physics body there, unless it moves about, else on the field's own plane.
#pragma once

#include "editor/painted_fields.h"

#include <godot_cpp/classes/camera3d.hpp>

#include <optional>
#include <span>
#include <vector>

namespace grass {

struct GroundPoint {
	Eigen::Vector3d position; // in PaintedFields::space, metres
	bool on_body = false; // else on the plane of a field

	Eigen::Vector2d place() const { return { position.x(), position.z() }; }
};

// p_mouse: in the 3D editor's viewport, as in its input events. Nothing where the ray meets neither the fields nor a body within p_margin
// metres of one.
std::optional<GroundPoint> pick_ground(
		const PaintedFields &p_painted, const godot::Camera3D *p_camera, const godot::Vector2 &p_mouse, double p_margin);

// How far up and down to search for the ground around a cursor: it may be as steep as 60 degrees. Metres.
inline double search_height(double p_radius) {
	return 2.0 * p_radius + 1.0;
}

// Points of the ground at places around p_centre, no further than p_radius from it; in PaintedFields::space. Where there is no body near,
// level with the centre.
std::vector<Eigen::Vector3d> drape(
		const PaintedFields &p_painted, const GroundPoint &p_centre, std::span<const Eigen::Vector2d> p_places, double p_radius);

} // namespace grass
