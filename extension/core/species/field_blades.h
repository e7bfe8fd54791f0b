// SPDX-License-Identifier: MIT
// Each blade of a field at rest: its species, the clump it grows in, and what a map makes of both. The CPU's
// twin of begin_point() in shaders/draw/pose.gdshaderinc. Lives as long as the field is built.
#pragma once

#include "core/base/standing_plant.h"
#include "core/blades/patch.h"
#include "core/map/map_layers.h"
#include "core/solver/step.h"
#include "core/species/species.h"

#include <vector>

namespace grass {

class FieldBlades {
public:
	FieldBlades() = default;
	// p_species: null: one species. p_map: null: grass everywhere; else it must outlive this.
	FieldBlades(const TileGrid &p_grid, std::shared_ptr<const Patch> p_patch, const ClumpParams &p_clump, uint32_t p_seed,
			std::shared_ptr<const SpeciesMix> p_species, const MapLayers *p_map);

	struct Pose {
		int blade = 0; // in the patch, below the blades of the species before
		int species = 0;
		Eigen::Vector2f root = Eigen::Vector2f::Zero(); // place in the tile, 0..1; stems of a plant share it
		Clump clump = NO_CLUMP;
		float ground = 0.0f; // metres above the field
		float density = 1.0f;
	};
	// Place of blade p_blade (0..63) in its tile, 0..1, by which its species is chosen.
	Eigen::Vector2f get_root(int p_tile_x, int p_tile_z, int p_blade) const {
		return get_texel(first_of(p_tile_x, p_tile_z) + p_blade, 0).head<2>();
	}
	// Species of such a blade.
	int get_species(int p_tile_x, int p_tile_z, int p_blade) const;
	// Of such a blade.
	Pose get_pose(int p_tile_x, int p_tile_z, int p_blade) const;
	// Whether such a blade exists: the map may thin the grass out there, and a species may have none.
	bool stands(int p_tile_x, int p_tile_z, int p_blade) const;
	// Knot p_knot of such a blade at rest, blade space, metres.
	Eigen::Vector3f get_rest_knot(const Pose &p_pose, int p_knot) const;
	// Adds the blades of a tile that are of one of p_species (bits).
	void find_plants(int p_tile_x, int p_tile_z, uint32_t p_species, std::vector<StandingPlant> &r_plants) const;
	// All blades of an awake tile, as the simulation reads them.
	SlotGrowth grow(const GrassSlot &p_slot) const;
	// Whether the simulation needs grow(); otherwise it works the blades out by itself.
	bool needs_growth() const { return _species || _map || _clump.is_elsewhere(); }

private:
	int first_of(int p_tile_x, int p_tile_z) const; // blade of a tile, in the patch
	Eigen::Vector3f get_texel(int p_blade, int p_knot) const;

	TileGrid _grid;
	std::shared_ptr<const Patch> _patch;
	ClumpParams _clump;
	uint32_t _seed = 0;
	std::shared_ptr<const SpeciesMix> _species;
	const MapLayers *_map = nullptr;
};

} // namespace grass
