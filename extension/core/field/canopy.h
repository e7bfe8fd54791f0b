// SPDX-License-Identifier: MIT
// The grass at a place as a layer above the ground, bent as it is now: how much of a view it hides, and whom it touches. Field space,
// metres.
#pragma once

#include "core/field/field.h"

#include <functional>

namespace grass {

struct Canopy {
	double ground = 0.0; // height of the layer's lower side
	double height = 0.0; // between its sides; 0: nothing grows
	double blades = 0.0; // that grow on a square metre
	double blade_area = 0.0; // one face of a blade, m^2
	// The mean of the unit vectors along blades, from root to tip. Shorter than 1: they lean and curve to all sides.
	Eigen::Vector3d along = Eigen::Vector3d::Zero();
};

// Returns the layers of the map in which a place lies; null: there is no map.
using LayersAt = std::function<const MapLayers *(const Eigen::Vector2f &p_place)>;

// Returns the canopy at a place (x, z); p_layers: of the map there.
Canopy canopy_at(const Field &p_field, const Eigen::Vector2f &p_place, const MapLayers *p_layers);

// [Eq V1] Returns the optical depth of a canopy for each metre along a line within it. p_line: unit vector.
double canopy_density(const Canopy &p_canopy, const Eigen::Vector3d &p_line);

// [Eq V2] Returns the share of a view between two points that blades hide, 0 (none) to 1 (all).
double hidden_share(const Field &p_field, const LayersAt &p_layers, const Eigen::Vector3d &p_from, const Eigen::Vector3d &p_to);

} // namespace grass
