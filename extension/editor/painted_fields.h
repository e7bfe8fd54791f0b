// SPDX-License-Identifier: MIT
// The fields that one brush paints: the chosen one and those that adjoin it, or the plots of the chosen world.
#pragma once

#include "world/grass_world.h"

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace grass {

struct PaintedFields {
	godot::Node3D *chosen; // field or world
	Eigen::Isometry3d space; // of it, to global: places under the cursor are in it
	std::vector<GrassField *> fields; // at least one; the first numbers the species
	GrassWorld *world = nullptr; // whose plots they are

	// Metres around the brush in which a field is painted, too: a plot shows its neighbour's edge.
	double margin() const { return world != nullptr ? MapLayers::CHANGE_MARGIN : 0.0; }
};

// Global to the field's own space, metres.
Eigen::Isometry3d to_field_of(const GrassField &p_field);

// Whether a brush at a place of the field (x, z in metres) reaches the field's ground.
bool is_reached(const GrassField &p_field, const Eigen::Vector2d &p_place, double p_radius);

// One field alone.
PaintedFields painted_field(GrassField *p_field);

// With its neighbours in the edited scene. No neighbours are what is hidden or locked, what the scene would not save, and fields that lie
// on one another (the middle of one within the other): these are painted one by one.
PaintedFields painted_neighbours(GrassField *p_chosen);

// A world's plots in memory. Nothing where there is none.
std::optional<PaintedFields> painted_plots(GrassWorld *p_world);

// The number that p_field has for a species of p_chosen: the same resource, else one of the same name. Nothing where it does not
// grow there. 0, as the species are mixed, is 0 everywhere.
std::optional<int64_t> find_species(const GrassField &p_chosen, int64_t p_species, const GrassField &p_field);

} // namespace grass
