// SPDX-License-Identifier: MIT
// The parts that a field is made of, for the code that simulates and draws it.
#pragma once

#include "core/base/tile_grid.h"
#include "core/blades/clump.h"
#include "core/blades/patch.h"
#include "core/lod/cull.h"
#include "core/map/map_layers.h"
#include "core/solver/solver_params.h"
#include "core/species/species.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>

namespace grass {

struct FieldSetup {
	TileGrid grid;
	std::shared_ptr<const Patch> patch;
	ClumpParams clump;
	int pool_size = 0; // tiles that may be awake at once
	int drawn_tiles_max = int(DRAWN_TILES_MAX.initial);
	uint32_t seed = 0;
	bool is_mapped = false; // a map determines what grows where
	float follow_slope = 0.0f; // FOLLOW_SLOPE
	float sparse_height = float(SPARSE_HEIGHT.initial);
	std::shared_ptr<const SpeciesMix> species; // null: one species, at no extra cost

	Method method = Method::DIRECT; // of solving its blades

	bool has_terrain = false; // a texture of the terrain colours it
	float card_size = 0.0f; // how far a card or a leaf extends from its tip at most, metres; 0: no species has one
	float leaf_area = 0.0f; // area that the mean blade's leaf covers, m^2
	bool has_plants = false; // a species has a mesh, or several stems for each root
	float plant_size = 0.0f; // how far a mesh extends from its blade at most, metres; 0: no species has one

	// Returns true if the meshes of one field fit the other, provided that the MultiMeshes are large enough.
	bool has_meshes_of(const FieldSetup &p_other) const {
		return drawn_tiles_max == p_other.drawn_tiles_max && (card_size > 0.0f) == (p_other.card_size > 0.0f);
	}
	// Return the capacities of the MultiMeshes of picture and shadows, tiles: powers of two, so that a growing field usually fits.
	int instance_capacity() const { return capacity(uint64_t(drawn_tiles_max)); }
	int shadow_capacity() const { return capacity(uint64_t(drawn_tiles_max) / 4); }
	// Return, of the longest blade at rest, enlarged by its clump: length, height above the root, horizontal spread; the last two include
	// its card or mesh. Metres.
	float blade_length() const { return patch->max_length * CLUMP_TALLEST; }
	float blade_height() const { return std::min(patch->max_height * CLUMP_TALLEST + blade_lean(), blade_length()) + tip_size(); }
	float blade_spread() const { return std::min(patch->max_spread * CLUMP_TALLEST + blade_lean(), blade_length()) + tip_size(); }
	// Returns how far its card or mesh extends beyond a blade, metres.
	float tip_size() const { return std::max(card_size, plant_size); }
	// Returns the size of the mean blade.
	BladeSize blade_size() const { return { patch->mean_width + width_of_leaf(leaf_area, patch->mean_length), patch->mean_length }; }
	MapPlace map_place() const { return { grid, double(blade_length()), follow_slope, species != nullptr, sparse_height }; }
	CullField cull_field() const {
		return { grid, blade_spread(), blade_height(), blade_size(), seed, { uint32_t(instance_capacity()), uint32_t(shadow_capacity()) } };
	}

private:
	int capacity(uint64_t p_most) const { return int(std::min(std::bit_ceil(uint64_t(grid.get_tile_count())), p_most)); }
	// Returns how far a clump's lean and the slope move a tip at most: the chord of the angle whose half has that tangent, on both axes.
	float blade_lean() const {
		return (2.0f * 1.4143f * float(GRASS_CLUMP_LEAN) + (is_mapped ? slope_lean(follow_slope) : 0.0f)) * blade_length();
	}
};

} // namespace grass
