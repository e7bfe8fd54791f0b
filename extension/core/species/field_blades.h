// SPDX-License-Identifier: MIT Each blade of a field at rest: its species, its clump, and how a map changes both. It is for the CPU what
// begin_point() in shaders/draw/pose.gdshaderinc is for the picture. Lives as long as the field is built.
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
	// p_species: null: one species. p_map: null: grass everywhere; otherwise it must outlive this object.
	FieldBlades(const TileGrid &p_grid, std::shared_ptr<const Patch> p_patch, const ClumpParams &p_clump, uint32_t p_seed,
			std::shared_ptr<const SpeciesMix> p_species, const MapLayers *p_map);

	struct Pose {
		int blade = 0; // in the patch, after the blades of earlier species
		int species = 0;
		Eigen::Vector2f root = Eigen::Vector2f::Zero(); // place in the tile, 0..1; stems of a plant share it
		Clump clump = NO_CLUMP;
		float ground = 0.0f; // metres above the field
		float density = 1.0f;
	};
	// Returns the place in its tile, 0..1, of blade p_blade (0..63). It decides the blade's species.
	Eigen::Vector2f get_root(int p_tile_x, int p_tile_z, int p_blade) const {
		return get_texel(first_of(p_tile_x, p_tile_z) + p_blade, 0).head<2>();
	}
	// Returns the blade's species. r_height: as SpeciesMix::choose() sets it.
	int get_species(int p_tile_x, int p_tile_z, int p_blade, float *r_height = nullptr) const;
	// Returns the blade's pose.
	Pose get_pose(int p_tile_x, int p_tile_z, int p_blade) const;
	// Returns whether the blade exists: the map may thin out the grass there, and a species may have no blades.
	bool stands(int p_tile_x, int p_tile_z, int p_blade) const;
	// Returns knot p_knot of a blade at rest in blade space, metres.
	Eigen::Vector3f get_rest_knot(const Pose &p_pose, int p_knot) const;
	// The pose of a blade's mesh at rest: as shaders/draw/plant.gdshader draws it near the eye.
	struct Standing {
		float angle = 0.0f; // radians from +x towards +z, of the mesh's x axis at the root
		float length = 0.0f; // metres, as far as it has grown out of the ground, and before it is mown
		float left = 0.0f; // share of the whole blade that has grown and was not mown, 0..1
	};
	// How the field ends: see grass_border().
	struct Border {
		float fade = 0.0f; // metres
		float waver = 0.0f;
		bool operator==(const Border &) const = default;
	};
	// Returns the pose of a blade's mesh. p_pose: of that blade.
	Standing get_standing(const Pose &p_pose, int p_tile_x, int p_tile_z, int p_blade, const Border &p_border) const;
	// Appends the blades of a tile whose species is in the bit mask p_species.
	void find_plants(int p_tile_x, int p_tile_z, uint32_t p_species, std::vector<StandingPlant> &r_plants) const;
	// Returns all blades of an awake tile, as the simulation reads them.
	SlotGrowth grow(const GrassSlot &p_slot) const;
	// Returns whether the simulation needs grow(); otherwise it computes the blades itself.
	bool needs_growth() const { return _species || _map || _clump.is_elsewhere(); }

private:
	int first_of(int p_tile_x, int p_tile_z) const; // index in the patch of a tile's first blade
	Eigen::Vector3f get_texel(int p_blade, int p_knot) const;

	TileGrid _grid;
	std::shared_ptr<const Patch> _patch;
	ClumpParams _clump;
	uint32_t _seed = 0;
	std::shared_ptr<const SpeciesMix> _species;
	const MapLayers *_map = nullptr;
};

} // namespace grass
