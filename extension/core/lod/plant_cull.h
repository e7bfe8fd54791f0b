// SPDX-License-Identifier: MIT
// Chooses which plants are drawn by a mesh: those near the cameras that see their tiles. Twin of shaders/species/plants.glsl.
#pragma once

#include "core/base/standing_plant.h"
#include "core/lod/cull.h"

#include "species/stages.inc"

#include <array>
#include <unordered_map>

namespace grass {

// The plants of one species that are drawn by a mesh, or by its impostor.
struct PlantKind {
	float distance = 0.0f; // metres; farther plants are drawn otherwise; 0: none are drawn so
	float length = 0.0f; // of the mean plant, metres
	float cover = 0.0f; // the cover of one plant over its tile's ground, seen from the side
	int stems = 1; // blades that make one plant
	float nearest = 0.0f; // metres; nearer plants are drawn otherwise
};

class PlantCull {
public:
	// Appends the plants of a tile to a list.
	using PlantsOf = std::function<void(int p_x, int p_z, std::vector<StandingPlant> &r_plants)>;
	// Meshes by species, and from GRASS_MAX_SPECIES on impostors by species.
	using Kinds = std::array<PlantKind, size_t(GRASS_MAX_SPECIES) * GRASS_PLANT_STAGES>;

	// Discards what is cached of tiles, for another field or another map.
	void forget() { _known.clear(); }
	void choose(const CullField &p_field, const FieldView &p_view, const TileCover *p_cover, const TileCull::SlotOf &p_slot_of,
			const PlantsOf &p_plants_of, const Kinds &p_kinds);
	// Returns the instances of a kind by the last choice, numbered as Kinds: GRASS_INSTANCE_FLOATS for each.
	std::span<const float> get_instances(int p_number) const { return _instances[size_t(p_number)]; }
	int get_count(int p_number) const { return int(_instances[size_t(p_number)].size()) / GRASS_INSTANCE_FLOATS; }
	size_t get_memory_usage() const; // bytes

private:
	using Plants = std::vector<StandingPlant>;

	const Plants &find(int p_index, int p_x, int p_z, const PlantsOf &p_plants_of);

	std::unordered_map<int, Plants> _known; // by tile; only looked up, so its order does not matter
	std::array<std::vector<float>, std::tuple_size_v<Kinds>> _instances;
};

} // namespace grass
