// SPDX-License-Identifier: MIT
// How one species of a field is drawn with a mesh.
#pragma once

#include "core/lod/plant_cull.h"
#include "core/species/species.h"
#include "draw/plant_impostor.h"
#include "draw/plant_model.h"

#include <algorithm>
#include <memory>
#include <span>

namespace grass {

struct DrawnPlant {
	std::shared_ptr<const PlantModel> model; // null: draw as blades
	std::shared_ptr<const PlantImpostor> impostor; // null: from `distance` on they are drawn as blades
	float distance = 0.0f; // metres, up to which the mesh is drawn
	float impostor_distance = 0.0f; // metres, up to which the impostor is drawn; farther plants are blades
	float length = 0.0f, max_length = 0.0f; // of the mean blade, and of the longest; metres
	float blade_area = 0.0f; // width times length of the mean blade, m^2
	int stems = 1; // blades that make one plant

	bool operator==(const DrawnPlant &) const = default;
	// Returns how far the mesh extends from its blade at most, metres.
	float size() const { return model ? model->reach * max_length : 0.0f; }
	float width() const { return model ? 2.0f * model->reach * length : 0.0f; } // of the mean plant, metres
	bool has(int p_stage) const { return p_stage == GRASS_PLANT_MESH ? model != nullptr : impostor != nullptr; }
	float blade_distance() const { return impostor ? impostor_distance : distance; } // from which on it is drawn as a blade, metres
	// Returns the plants that are drawn as p_stage (GRASS_PLANT_MESH, GRASS_PLANT_IMPOSTOR), in the form for culling. p_reach: share of
	// their distances; p_tile_size: metres.
	PlantKind kind(int p_stage, float p_reach, double p_tile_size) const {
		const float cover = model ? model->area * length * length / float(p_tile_size * p_tile_size) : 0.0f;
		const bool is_mesh = p_stage == GRASS_PLANT_MESH;
		// The distance at which the first ones begin to change.
		const float nearest = is_mesh ? 0.0f : p_reach * distance * float(GRASS_PLANT_FIRST * GRASS_PLANT_FADE);
		return { p_reach * (is_mesh ? distance : impostor_distance), length, cover, stems, nearest };
	}
	float cover() const { return model ? model->area * length * length / std::max(blade_area, 1e-6f) : 0.0f; } // relative to its blade's
};

// Returns whether all of them can be drawn at once; if not, threads still draw pictures for their impostors.
inline bool are_pictured(std::span<const DrawnPlant> p_plants) {
	return std::ranges::all_of(p_plants, [](const DrawnPlant &p_plant) { return !p_plant.impostor || p_plant.impostor->is_drawn(); });
}

} // namespace grass
