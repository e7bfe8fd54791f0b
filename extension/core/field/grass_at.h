// SPDX-License-Identifier: MIT
// Finds what grows at a place of a field, at rest. Places: x and z in field space, metres.
#pragma once

#include "core/field/field.h"
#include "core/paint/mow.h"

namespace grass {

// Returns the share of the blades that grow, from 0 to 1. p_layers: what is painted there, or null.
double density_at(const Eigen::Vector2f &p_place, const MapLayers *p_layers);
// Returns the height of the grass in metres; 0 where none grows.
double height_at(const Field &p_field, const Eigen::Vector2f &p_place, const MapLayers *p_layers);
// Returns the grass as mowing, regrowing and bodies need it. Valid until the field is set again.
GrassKind kind_of(const Field &p_field);

} // namespace grass
