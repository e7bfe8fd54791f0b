// SPDX-License-Identifier: MIT
// Which plants are drawn by a mesh: those near the cameras that see their tiles. Twin of shaders/species/plants.glsl.
#pragma once

#include "core/base/standing_plant.h"
#include "core/lod/cull.h"

#include <unordered_map>

namespace grass {

// Plants of one species that are drawn by a mesh.
struct PlantKind {
	float distance = 0.0f; // metres, from there on they are blades; 0: no mesh
	float length = 0.0f; // of the mean one, metres
	float cover = 0.0f; // what one shows to an eye beside it, over a tile's ground
	int stems = 1; // that stay together
};

class PlantCull {
public:
	// Adds the plants of a tile to a list.
	using PlantsOf = std::function<void(int p_x, int p_z, std::vector<StandingPlant> &r_plants)>;
	using Kinds = std::array<PlantKind, GRASS_MAX_SPECIES>;

	// What is known of tiles no longer holds: another field or another map.
	void forget() { _known.clear(); }
	void choose(const CullField &p_field, const FieldView &p_view, const TileCover *p_cover, const TileCull::SlotOf &p_slot_of,
			const PlantsOf &p_plants_of, const Kinds &p_kinds);
	// Of the last choice: GRASS_INSTANCE_FLOATS each.
	std::span<const float> get_instances(int p_species) const { return _instances[size_t(p_species)]; }
	int get_count(int p_species) const { return int(_instances[size_t(p_species)].size()) / GRASS_INSTANCE_FLOATS; }
	size_t get_memory_usage() const; // bytes

private:
	using Plants = std::vector<StandingPlant>;

	const Plants &find(int p_index, int p_x, int p_z, const PlantsOf &p_plants_of);

	std::unordered_map<int, Plants> _known; // by tile; looked up only, so its order does not matter
	std::array<std::vector<float>, GRASS_MAX_SPECIES> _instances;
};

} // namespace grass
