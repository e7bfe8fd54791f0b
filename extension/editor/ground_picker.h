// SPDX-License-Identifier: MIT
// Finds where the cursor meets the ground: on the physics body there, unless that moves about, otherwise on the field's own plane.
#pragma once

#include "editor/painted_fields.h"

#include <godot_cpp/classes/camera3d.hpp>

#include <optional>
#include <span>
#include <vector>

namespace grass {

struct GroundPoint {
	Eigen::Vector3d position; // in PaintedFields::space, metres
	bool on_body = false; // otherwise on the plane of a field

	Eigen::Vector2d place() const { return { position.x(), position.z() }; }
};

// Returns the ground under the cursor. p_mouse: in the 3D editor's viewport, as in its input events. Returns nothing if the ray meets
// neither a field nor a body within p_margin metres of one.
std::optional<GroundPoint> pick_ground(
		const PaintedFields &p_painted, const godot::Camera3D *p_camera, const godot::Vector2 &p_mouse, double p_margin);

// Returns how far up and down to search for the ground around a cursor, for slopes up to 60 degrees. Metres.
inline double search_height(double p_radius) {
	return 2.0 * p_radius + 1.0;
}

// Returns points of the ground at places around p_centre, at most p_radius from it, in PaintedFields::space. Without a body nearby they are
// level with the centre.
std::vector<Eigen::Vector3d> drape(
		const PaintedFields &p_painted, const GroundPoint &p_centre, std::span<const Eigen::Vector2d> p_places, double p_radius);

} // namespace grass
