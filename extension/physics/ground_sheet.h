// SPDX-License-Identifier: MIT
// Converts shapes of the ground to heights.
#pragma once

#include "core/map/height_sheet.h"
#include "core/map/map_region.h"

#include <Eigen/Geometry>

#include <godot_cpp/classes/shape3d.hpp>

namespace grass {

// Returns true for height maps and trimeshes.
bool is_ground_shape(const godot::Ref<godot::Shape3D> &p_shape);
// Returns the rectangle of the field above which its ground lies, and a little around; p_to_field: from the shape's space. Empty (min >
// max) if it has none.
MapRegion ground_shape_bounds(const godot::Ref<godot::Shape3D> &p_shape, const Eigen::Affine3d &p_to_field);
void add_ground_shape(HeightSheet &r_sheet, const godot::Ref<godot::Shape3D> &p_shape, const Eigen::Affine3d &p_to_field);

} // namespace grass
