// SPDX-License-Identifier: MIT
// Converts shapes of the ground to heights.
#pragma once

#include "core/map/height_sheet.h"

#include <Eigen/Geometry>

#include <godot_cpp/classes/shape3d.hpp>

namespace grass {

// Returns true for height maps and trimeshes.
bool is_ground_shape(const godot::Ref<godot::Shape3D> &p_shape);
// p_to_field: from the shape's space.
void add_ground_shape(HeightSheet &r_sheet, const godot::Ref<godot::Shape3D> &p_shape, const Eigen::Affine3d &p_to_field);

} // namespace grass
