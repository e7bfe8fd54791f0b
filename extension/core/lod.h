// SPDX-License-Identifier: MIT
// Level of detail and visibility of a tile (Fan et al. 2015, sections 3.1 and 5.1). Twin of shaders/shared/lod.inc.
#pragma once

#include "core/layout.h"
#include "core/tunable.h"

#include <Eigen/Core>

#include <array>

namespace grass {

// From here on one eighth of the blades is drawn. The view's far end, or where the field ends for the eye.
inline constexpr Tunable LOD_FAR{ "lod_far", "m", 1.0, 10000.0, 1.0, 100.0 };
// Blades have 15 segments up to here, then 7. Usual 4 to 15; beyond twice that vertices are finer than pixels.
inline constexpr Tunable LOD_FINE{ "lod_fine", "m", 0.0, 1000.0, 0.5, 6.0 };
// Blades have 7 segments up to here, then 3. Usual two to three times fine.
inline constexpr Tunable LOD_MEDIUM{ "lod_medium", "m", 0.0, 1000.0, 0.5, 18.0 };

// Distances from the camera to a tile's centre, metres.
struct LodParams {
	float near = 0.05f; // Full count of blades up to here: the camera's near plane.
	float far = float(LOD_FAR.initial); // One eighth of the blades beyond about this: the camera's far plane, or where the field ends.
	float fine = float(LOD_FINE.initial); // 15 segments a blade up to here
	float medium = float(LOD_MEDIUM.initial); // 7 segments up to here, then 3

	// The same with NaN, negative and disordered values mended: 0 <= near, 0.001 <= far, 0 <= fine <= medium.
	LodParams sanitised() const;
};

struct LodLevel {
	int blades; // That its mesh holds.
	int segments; // A blade.
};

// Level i, nearest first; p_level within [0, GRASS_LOD_LEVELS).
LodLevel get_lod_level(int p_level);

// [Eq L1] Blades to draw in a tile: L(z) = (1 - 7 (z - z_near) / (8 z_far)) C, within [C / 8, C]. Distances in metres.
float grass_lod_blades(float p_distance, float p_near, float p_far);

// The level (of GRASS_LOD_*) whose mesh holds p_blades and has the segments due at p_distance.
int grass_lod_level(float p_blades, float p_distance, float p_fine, float p_medium);

// Six planes: normal.xyz, d; inside: normal . x <= d. The normals look out of the view, as Godot's do.
using Frustum = std::array<Eigen::Vector4f, 6>;

// Whether a box is seen: not wholly outside of one of the planes. p_margin: metres by which the view is widened, for
// what is out of it but throws its shadow in.
bool grass_tile_visible(const Frustum &p_planes, const Eigen::Vector3f &p_centre, const Eigen::Vector3f &p_half_extents, float p_margin);

} // namespace grass
