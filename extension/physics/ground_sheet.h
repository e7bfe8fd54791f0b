// SPDX-License-Identifier: MIT
// Converts shapes of the ground to heights.
#pragma once

#include "core/map/height_sheet.h"
#include "core/map/map_region.h"
#include "physics/ground_triangles.h"

namespace grass {

// Returns true for height maps and trimeshes.
bool is_ground_shape(const godot::Ref<godot::Shape3D> &p_shape);
// Returns the rectangle of the field above which its ground lies, and a little around; p_to_field: from the shape's space. Empty (min >
// max) if it has none.
MapRegion ground_bounds(const GroundTriangles &p_ground, const Eigen::Affine3d &p_to_field);
void add_ground(HeightSheet &r_sheet, const GroundTriangles &p_ground, const Eigen::Affine3d &p_to_field);

} // namespace grass
