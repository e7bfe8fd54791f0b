// SPDX-License-Identifier: MIT
// Finds out where the ground under a field has its vertices, before its heights are read by rays.
#pragma once

#include "core/map/ground_grid.h"
#include "core/map/map_region.h"
#include "physics/ground_rays.h"

namespace grass {

// Returns the grid of the largest terrain in p_region (field space) that has one; the ordinary grid if none has. p_field: global, without
// scale.
GroundGrid search_grid(GroundRays &r_rays, const MapRegion &p_region, const godot::Transform3D &p_field);

} // namespace grass
