// SPDX-License-Identifier: MIT
// The species of a field: the share of each, and which species a blade has. shaders/species/species.inc as C++, and the numbers that its
// functions read. docs/internals/species.md, [Eq P1] to [Eq P4].
#pragma once

#include "core/base/glsl.h"
#include "core/base/hash.h"
#include "core/base/tile_grid.h"
#include "core/base/tunable.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>

namespace grass {

using glsl::smoothstep;
using std::floor;

#define GRASS_FUNCTION inline
#include "species/species.inc"
#undef GRASS_FUNCTION

#include "species/constants.inc"

class MapLayers;

// Share of the field's blades, relative to the other species. 0: only where it is painted.
inline constexpr Tunable SPECIES_SHARE{ "share", "", 0.0, 1.0, 0.01, 0.5 };
// The width of the stands that a species grows in. Below 0.5 stands are no larger than clumps.
inline constexpr Tunable STAND_SIZE{ "stand_size", "m", 0.2, 64.0, 0.1, 4.0 };
// 0: single blades among those of other species; 1: separate stands with sharp borders.
inline constexpr Tunable STAND_STRENGTH{ "stand_strength", "", 0.0, 1.0, 0.01, 0.6 };
// How softly its stands end: their borders fray, and blades there are lower by up to this share. 0: only stand_strength decides how sharply
// they end.
inline constexpr Tunable STAND_EDGE{ "stand_edge", "", 0.0, 1.0, 0.01, 0.0 };

// Share of a species' blades that have a flower or seed head.
inline constexpr Tunable CARD_SHARE{ "card_share", "", 0.0, 1.0, 0.01, 1.0 };
// Size of a flower or seed head. Above 0.3 cards look like paper.
inline constexpr Tunable CARD_WIDTH{ "card_width", "m", 0.005, 1.0, 0.005, 0.05 };
inline constexpr Tunable CARD_HEIGHT{ "card_height", "m", 0.005, 1.0, 0.005, 0.05 };
// 0: a card is upright and faces the eye; 1: it lies across the tip of its blade, like a daisy.
inline constexpr Tunable CARD_FLATNESS{ "card_flatness", "", 0.0, 1.0, 0.01, 0.0 };
// Number of pictures side by side in a card's texture. Each blade shows one of them.
inline constexpr Tunable CARD_PICTURES{ "card_pictures", "", 1.0, 8.0, 1.0, 1.0, true };
// Side of a leaf. Above 0.15 single leaves look like paper.
inline constexpr Tunable LEAF_SIZE{ "leaf_size", "m", 0.005, 1.0, 0.005, 0.05 };

// The distance from which a plant with a mesh is drawn as a blade. Up to it each plant costs the vertices of its mesh.
inline constexpr Tunable PLANT_DISTANCE{ "plant_distance", "m", 1.0, 1000.0, 1.0, 30.0 };
// Number of blades that share a root: 1, 2, 4 or 8. The largest must divide every grass_tile_start().
inline constexpr Tunable PLANT_STEMS{ "stems", "", 1.0, 8.0, 1.0, 1.0, true };
// The distance within which a plant with a scene has a node. Beyond 64 it takes seconds to look through dense grass.
inline constexpr Tunable PLANT_SCENE_DISTANCE{ "plant_scene_distance", "m", 1.0, 64.0, 0.5, 16.0 };
static_assert(GRASS_START_STRIDE % int(PLANT_STEMS.maximum) == 0);

// Most vertices of a species' plants all around a camera: each is posed in the depth prepass, in the picture and in each cascade of a
// shadow.
inline constexpr double NEAR_PLANT_VERTICES = 2e6;

// Returns the distance up to which plants are drawn by their mesh, metres: p_distance, or less if that would be too many vertices.
// p_density: plants per square metre.
double near_plants(double p_distance, double p_density, int64_t p_vertices);

// Values outside the range of their Tunable are clamped, NaN becomes the default.
struct SpeciesParams {
	double share = SPECIES_SHARE.initial;
	double stand_size = STAND_SIZE.initial; // metres
	double stand_strength = STAND_STRENGTH.initial;
	int stems = 1; // a power of two
	double stand_edge = STAND_EDGE.initial;
	bool falls = true; // blades at the border of its stands are lower, too; not so plants with a mesh
	bool operator==(const SpeciesParams &) const = default;
};

// What grass_species_takes() reads of a species.
struct SpeciesRecord {
	int32_t cell = 1, strength = 0, limit = 0, salt = 0;
	int32_t stems = 1; // chosen together
	int32_t fray = 0; // units
	float falls = 0.0f; // how much lower blades at the border of its stands are, 0..1
	// The field's first corner in the noise: units within a cell, and which cell.
	int32_t x = 0, z = 0, column = 0, row = 0;

	bool operator==(const SpeciesRecord &) const = default;
};

class SpeciesMix {
public:
	// Species beyond GRASS_MAX_SPECIES are ignored. If all shares are 0, the first species grows. p_origin: the field's place in the noise,
	// metres. Adjacent fields of equal size continue each other if their p_origin differs by that size.
	SpeciesMix(std::span<const SpeciesParams> p_species, const TileGrid &p_grid, uint32_t p_seed,
			const Eigen::Vector2d &p_origin = Eigen::Vector2d::Zero());

	int get_count() const { return _count; }
	// Returns whether it chooses the same species everywhere, in a field with the same tiles and seed.
	bool chooses_as(const SpeciesMix &p_other) const { return std::ranges::equal(get_records(), p_other.get_records()); }
	std::span<const SpeciesRecord> get_records() const { return { _records.data(), size_t(_count) }; }
	int get_texel_units() const { return _texel_units; } // units along a texel of the map
	double get_share(int p_species) const { return _shares[size_t(p_species)]; } // of all blades without paint, 0..1

	using RootOf = std::function<Eigen::Vector2f(int p_blade)>; // returns the place in a tile, 0..1, of a blade of the patch
	// Returns the species of blade p_blade (0..63) of a tile. p_layers: of the map, or null.
	// r_height: the height of the blade there as a share of what it would be within a stand, [Eq P6].
	int choose_species(
			int p_tile_x, int p_tile_z, int p_blade, const RootOf &p_root_of, const MapLayers *p_layers, float *r_height = nullptr) const;
	int choose_species(
			int p_tile_x, int p_tile_z, int p_blade, const Eigen::Vector2f &p_root, const MapLayers *p_layers) const; // for single stems
	// [Eq P4] Returns the shares of the species among the blades around a place in the field: x, z in metres. They add up to 1.
	std::array<float, GRASS_MAX_SPECIES> get_shares_at(const Eigen::Vector2f &p_place, const MapLayers *p_layers) const;

private:
	struct Place;

	static uint32_t noise_at(const SpeciesRecord &p_record, const Place &p_place, int p_species);
	int find_painted(const Place &p_place, const MapLayers *p_layers) const;
	int find_painted(int p_texel_x, int p_texel_z, const MapLayers *p_layers) const;

	TileGrid _grid;
	uint32_t _seed;
	int _count;
	int _texel_units;
	std::array<SpeciesRecord, GRASS_MAX_SPECIES> _records;
	std::array<double, GRASS_MAX_SPECIES> _shares{};
};

} // namespace grass
