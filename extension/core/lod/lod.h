// SPDX-License-Identifier: MIT
// Level of detail and visibility of a tile (Fan et al. 2015, sections 3.1 and 5.1): shaders/lod/lod.inc and levels.inc
// as C++, and what a tile needs by them.
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
		glsl::grass_lod_level, glsl::grass_lod_morph, glsl::grass_lod_needed, glsl::grass_lod_rank, glsl::grass_lod_plant,
		glsl::grass_lod_plants, glsl::grass_lod_segments, glsl::grass_lod_shown;

// From here on one eighth of the blades is drawn at most. The view's far end, or where the field ends for the eye.
inline constexpr Tunable LOD_FAR{ "lod_far", "m", 1.0, 10000.0, 1.0, 100.0 };
// How far a blade may be drawn from its curve, in pixels: decides its segments. 0: always 15; above 2 curves look cut.
inline constexpr Tunable LOD_ERROR{ "lod_error", "px", 0.0, 8.0, 0.05, 1.0 };
// No blade is drawn narrower at its root than this: where they would be, fewer blades cover as much. 0: all blades keep
// their own width, hidden ones too are drawn, and far grass flickers; above 2 it looks coarse.
inline constexpr Tunable PIXELS_MIN{ "pixels_min", "px", 0.0, 4.0, 0.1, 1.2 };
// How many times coarser blades are in shadows than in the picture. 1: as fine; above 6 single blades near the camera
// cast no shadow.
inline constexpr Tunable SHADOW_COARSENESS{ "shadow_coarseness", "", 1.0, 16.0, 0.1, 3.0 };

// Tiles that a field draws in a frame, at most; a quarter as many cast shadows. 100 bytes each. Where more are seen, far ones are left
// out, evenly: below 10000 the grass ends before one's eyes.
inline constexpr Tunable DRAWN_TILES_MAX{ "drawn_tiles_max", "tiles", 256.0, 4194304.0, 1.0, 262144.0, true };

struct LodParams {
	float far = float(LOD_FAR.initial); // metres
	float error = float(LOD_ERROR.initial); // pixels
	float pixels_min = float(PIXELS_MIN.initial); // pixels
	float shadow_coarseness = float(SHADOW_COARSENESS.initial);
	bool is_carried = false; // the ground has the grass's colour: blades end where they are too low to be seen as such

	// The same with NaN and values out of range mended: 0.001 <= far, 0 <= error, 0 <= pixels_min, 1 <= shadow_coarseness.
	LodParams sanitised() const;
	bool operator==(const LodParams &) const = default;
};

// The mean blade of a field, metres.
struct BladeSize {
	float width = 0.0f, length = 0.0f;
};

// How much wider a blade would be, metres, if it covered what its leaf does. p_area: of the leaf, m^2; p_length: of the blade, metres.
inline float width_of_leaf(float p_area, float p_length) {
	return p_area / (float(GRASS_LOD_FULLNESS) * std::max(p_length, 1e-3f));
}

// What a tile needs: blades, segments of each, and the blades that would cover as much as all. The most that any camera needs counts.
struct LodNeed {
	float blades = 0.0f, segments = 0.0f, covering = 0.0f;

	// Adds what a camera at p_distance (metres) needs. p_near: distance of its near plane, metres; p_pixel: metres of the tile
	// in one of its pixels; p_in_sight: grass_lod_in_sight().
	void add(const LodParams &p_params, const BladeSize &p_size, float p_distance, float p_near, float p_pixel, float p_in_sight = 1.0f);
};

struct LodLevel {
	int blades; // That its mesh holds.
	int segments; // A blade.
};

// Level i of GRASS_ALL_LEVELS.
LodLevel get_lod_level(int p_level);

// Returns how many ranks, from the first on, have room for all of their tiles, as fit() in room.inc counts them. p_tiles: of each rank.
uint32_t grass_lod_ranks(const std::array<uint32_t, GRASS_RANKS> &p_tiles, uint32_t p_room);

// Six planes: normal.xyz, d; inside: normal . x <= d. The normals look out of the view, as Godot's do.
using Frustum = std::array<Eigen::Vector4f, 6>;

bool grass_tile_visible(const Frustum &p_planes, const Eigen::Vector3f &p_centre, const Eigen::Vector3f &p_half_extents, float p_margin,
		const Eigen::Vector3f &p_fall);

} // namespace grass
