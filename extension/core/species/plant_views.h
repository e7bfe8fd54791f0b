// SPDX-License-Identifier: MIT
// Pictures of a plant's mesh from all sides and from above, for the impostor that is drawn in its place at some distance.
#pragma once

#include "core/species/plant_picture.h"

#include <atomic>

namespace grass {

// From the side, seen from a little above, the picture is as wide as the plant's reach to both sides, and reaches from its root to its tip.
// From above it is as wide and as deep as that, and shows the upper parts. All mipmaps follow each other, the largest first; in each the
// alpha is the share of a texel that is covered, and transparent texels have the mean of those around them.
struct PlantView {
	std::vector<uint8_t> colors; // RGBA8, sRGB
	std::vector<uint8_t> normals; // RGBA8: x, y, z in the plant's axes, -1..1; alpha unused
	float depth = 0.0f; // towards the eye, where most of the nearer parts are: units of the mesh
};

struct PlantViews {
	std::vector<PlantView> views; // from the sides, the last one from above
	// The share of the picture from above that must be drawn beside those from the side, for an eye 30 degrees above the horizon to see as
	// much light as from the plant.
	float aslant = 0.0f;
};

// The eye of view k of p_sides is beside the plant, at the angle k / p_sides of a turn from x to z; the last view is from above, with x to
// the right and z down. p_surfaces: one unit high, their normals set; p_reach: farthest from the axis; p_texels: a power of two.
// p_is_stopped: once it is true, the result does not matter; null: never.
PlantViews draw_views(std::span<const PictureSurface> p_surfaces, float p_reach, int p_sides, int p_texels,
		const std::atomic<bool> *p_is_stopped = nullptr);

} // namespace grass
