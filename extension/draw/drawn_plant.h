// SPDX-License-Identifier: MIT
// Describes how one species of a field is drawn by a mesh.
#pragma once

#include "core/lod/plant_cull.h"
#include "draw/plant_model.h"

#include <algorithm>
#include <memory>

namespace grass {

struct DrawnPlant {
	std::shared_ptr<const PlantModel> model; // null: draw as blades
	float distance = 0.0f; // metres; draw as blades beyond it
	float length = 0.0f, max_length = 0.0f; // of the mean blade, and of the longest; metres
	float blade_area = 0.0f; // width times length of the mean blade, m^2
	int stems = 1; // blades that make one plant

	bool operator==(const DrawnPlant &) const = default;
	// Returns how far the mesh extends from its blade at most, metres.
	float size() const { return model ? model->reach * max_length : 0.0f; }
	float width() const { return model ? 2.0f * model->reach * length : 0.0f; } // of the mean plant, metres
	// Returns these plants in the form for culling. p_tile_size: metres.
	PlantKind kind(double p_tile_size) const {
		return { distance, length, model ? model->area * length * length / float(p_tile_size * p_tile_size) : 0.0f, stems };
	}
	float cover() const { return model ? model->area * length * length / std::max(blade_area, 1e-6f) : 0.0f; } // relative to its blade's
};

} // namespace grass
