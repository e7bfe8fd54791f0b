// SPDX-License-Identifier: MIT
// The fields that one brush paints: the chosen field and its neighbours, or the plots of the chosen world.
#pragma once

#include "world/grass_world.h"

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace grass {

struct PaintedFields {
	godot::Node3D *chosen; // field or world
	Eigen::Isometry3d space; // transform from it to global space: places under the cursor are in it
	std::vector<GrassField *> fields; // at least one; the first one defines the numbers of species
	GrassWorld *world = nullptr; // set if they are its plots

	// Returns the distance in metres around the brush within which fields are painted too, since a plot shows its neighbour's edge.
	double margin() const { return world != nullptr ? MapLayers::CHANGE_MARGIN : 0.0; }
};

// Returns the transform from global space to the field's own space, metres.
Eigen::Isometry3d to_field_of(const GrassField &p_field);

// Returns whether a brush at a place of the field (x, z in metres) reaches the field's ground.
bool is_reached(const GrassField &p_field, const Eigen::Vector2d &p_place, double p_radius);

// Returns whether ground at a place of the field (metres) may be the field's own, p_margin metres beyond its sides as well.
bool is_ground_of(const GrassField &p_field, const Eigen::Vector3d &p_place, double p_margin);

// Returns only this field.
PaintedFields painted_field(GrassField *p_field);

// Returns the field with its neighbours in the edited scene. Leaves out fields that are hidden or locked, or that the scene would not save.
// Also leaves out those that must be painted one by one: fields that overlap (the centre of one is inside the other, and within the band of
// its ground), and fields that are turned away by more than FACING, such as walls beside a floor.
PaintedFields painted_neighbours(GrassField *p_chosen);

// Returns the plots of a world that are in memory. Returns nothing if there are none.
std::optional<PaintedFields> painted_plots(GrassWorld *p_world);

// Returns the number that p_field has for a species of p_chosen: the same resource, or one with the same name. Returns nothing if it does
// not grow there. 0, the mix of species, is 0 everywhere.
std::optional<int64_t> find_species(const GrassField &p_chosen, int64_t p_species, const GrassField &p_field);
std::optional<int64_t> find_species(
		const godot::TypedArray<GrassSpecies> &p_ours, int64_t p_species, const godot::TypedArray<GrassSpecies> &p_theirs);

} // namespace grass
