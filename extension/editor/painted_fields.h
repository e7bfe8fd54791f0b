// SPDX-License-Identifier: MIT
// The fields that one brush paints: the chosen one and those that adjoin it.
#pragma once

#include "nodes/grass_field.h"

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace grass {

// Global to the field's own space, metres.
Eigen::Isometry3d to_field_of(const GrassField &p_field);

// Whether a brush at a place of the field (x, z in metres) reaches the field's ground.
bool is_reached(const GrassField &p_field, const Eigen::Vector2d &p_place, double p_radius);

// The chosen field first, then its neighbours in the edited scene. No neighbours are what is hidden or locked, what the scene
// would not save, and fields that lie on one another (the middle of one within the other): these are painted one by one.
std::vector<GrassField *> find_painted_fields(GrassField *p_chosen);

// The number that p_field has for a species of p_chosen: the same resource, else one of the same name. Nothing where it does not
// grow there. 0, as the species are mixed, is 0 everywhere.
std::optional<int64_t> find_species(const GrassField &p_chosen, int64_t p_species, const GrassField &p_field);

} // namespace grass
