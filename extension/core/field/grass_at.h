// SPDX-License-Identifier: MIT
// What grows at a place of a field, at rest. Places: x and z in field space, metres.
#pragma once

#include "core/field/field.h"
#include "core/paint/mow.h"

namespace grass {

// Share of the blades that stand, 0 to 1. p_layers: what is painted there, or null.
double density_at(const Field &p_field, const Eigen::Vector2f &p_place, const MapLayers *p_layers);
// Of the grass, metres; 0 where none stands.
double height_at(const Field &p_field, const Eigen::Vector2f &p_place, const MapLayers *p_layers);
// The grass as mowing, mending and bodies in it read it. Valid until the field is set anew.
GrassKind kind_of(const Field &p_field);

} // namespace grass
