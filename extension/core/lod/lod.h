// SPDX-License-Identifier: MIT
// Level of detail and visibility of a tile (Fan et al. 2015, sections 3.1 and 5.1): shaders/lod/lod.inc and levels.inc as C++, and what a
// tile needs according to them.
#pragma once

#include "core/base/glsl.h"
#include "core/base/tunable.h"

#include <algorithm>
#include <array>

namespace grass {

namespace glsl {
#define GRASS_FUNCTION inline
#define GRASS_CONSTANT inline constexpr
#include "lod/levels.inc"
#include "lod/lod.inc"
#undef GRASS_CONSTANT
#undef GRASS_FUNCTION
} // namespace glsl
using glsl::grass_far_depth, glsl::grass_far_hidden, glsl::grass_far_meets, glsl::grass_lod_blades, glsl::grass_lod_blades_of_width,
		glsl::grass_lod_coarser, glsl::grass_lod_cover, glsl::grass_lod_ends, glsl::grass_lod_in_sight, glsl::grass_lod_left_out,
		glsl::grass_lod_morph, glsl::grass_lod_needed, glsl::grass_lod_rank, glsl::grass_lod_plant, glsl::grass_lod_plants,
		glsl::grass_lod_segments, glsl::grass_lod_shadow, glsl::grass_lod_shown;

// The distance from which at most one eighth of the blades is drawn: the view's far end, or where the field ends for the eye.
inline constexpr Tunable LOD_FAR{ "lod_far", "m", 1.0, 10000.0, 1.0, 100.0 };
// How far a blade may be drawn from its curve, in pixels; this decides its number of segments. 0: always 15; above 2 curves look angular.
inline constexpr Tunable LOD_ERROR{ "lod_error", "px", 0.0, 8.0, 0.05, 1.0 };
// The least width of a blade at its root. Where blades would be narrower, fewer and wider ones cover as much. 0: all blades keep their own
// width, hidden ones are drawn too, and distant grass flickers; above 2 it looks coarse.
inline constexpr Tunable PIXELS_MIN{ "pixels_min", "px", 0.0, 4.0, 0.1, 1.2 };
// How many times coarser blades are in shadows than in the picture, the mean up to shadow_distance. 1: equally fine beside the camera;
// above 6 single blades near it cast no shadow.
inline constexpr Tunable SHADOW_COARSENESS{ "shadow_coarseness", "", 1.0, 16.0, 0.1, 3.0 };

// The most tiles that a field draws in a frame, 100 bytes each; a quarter as many cast shadows. If more are visible, an even selection of
// the distant ones is left out; below 10000 the grass visibly ends.
inline constexpr Tunable DRAWN_TILES_MAX{ "drawn_tiles_max", "", 256.0, 4194304.0, 1.0, 262144.0, true };

struct LodParams {
	float far = float(LOD_FAR.initial); // metres
	float error = float(LOD_ERROR.initial); // pixels
	float pixels_min = float(PIXELS_MIN.initial); // pixels
	float shadow_coarseness = float(SHADOW_COARSENESS.initial);
	bool is_carried = false; // the ground has the grass's colour: blades end where they are too low to be distinguished

	// Returns a copy without NaN and within the limits: 0.001 <= far, 0 <= error, 0 <= pixels_min, 1 <= shadow_coarseness.
	LodParams sanitised() const;
	// Returns what holds for shadows, at p_distance from the eye. p_reach: shadow_distance; metres.
	LodParams of_shadows(float p_distance, float p_reach) const;
	bool operator==(const LodParams &) const = default;
};

// The mean blade of a field, metres.
struct BladeSize {
	float width = 0.0f, length = 0.0f;
};

// Returns the width that a blade would need, metres, to cover as much as its leaf does. p_area: of the leaf, m^2; p_length: of the blade,
// metres.
inline float width_of_leaf(float p_area, float p_length) {
	return p_area / (float(GRASS_LOD_FULLNESS) * std::max(p_length, 1e-3f));
}

// What a tile needs: the number of blades, the segments of each, and the number of blades that would cover as much as all of them. Each is
// the maximum over the cameras.
struct LodNeed {
	float blades = 0.0f, segments = 0.0f, covering = 0.0f;

	// Adds the needs of a camera at p_distance (metres). p_near: distance of its near plane, metres; p_pixel: metres of the tile in one of
	// its pixels; p_in_sight: grass_lod_in_sight().
	void add(const LodParams &p_params, const BladeSize &p_size, float p_distance, float p_near, float p_pixel, float p_in_sight = 1.0f);
};

struct LodLevel {
	int blades; // That its mesh has.
	int segments; // Of each blade.
};

// Returns level p_level of GRASS_ALL_LEVELS.
LodLevel get_lod_level(int p_level);

// A set of levels: a bit for each of GRASS_ALL_LEVELS.
using LevelSet = uint64_t;
inline constexpr LevelSet ALL_LEVELS = (LevelSet(1) << GRASS_ALL_LEVELS) - 1, PICTURE_LEVELS = (LevelSet(1) << GRASS_LOD_LEVELS) - 1,
						  CASTING_LEVELS = ALL_LEVELS & ~PICTURE_LEVELS;

// Returns grass_lod_level() of a set.
inline int find_lod_level(float p_blades, int p_segments, int p_first, int p_end, LevelSet p_levels) {
	return glsl::grass_lod_level(p_blades, p_segments, p_first, p_end, uint32_t(p_levels), uint32_t(p_levels >> 32));
}

// Returns how many ranks, counted from the first, have room for all of their tiles, as fit() in room.inc does. p_tiles: number in each
// rank.
uint32_t grass_lod_ranks(const std::array<uint32_t, GRASS_RANKS> &p_tiles, uint32_t p_room);

// Six planes: normal.xyz, d; inside: normal . x <= d. The normals point out of the view, as Godot's do.
using Frustum = std::array<Eigen::Vector4f, 6>;

bool grass_tile_visible(const Frustum &p_planes, const Eigen::Vector3f &p_centre, const Eigen::Vector3f &p_half_extents, float p_margin,
		const Eigen::Vector3f &p_fall);

} // namespace grass
