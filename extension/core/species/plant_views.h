// SPDX-License-Identifier: MIT
// Pictures of a plant's mesh from all sides and from above, for the impostor that is drawn in its place at some distance.
#pragma once

#include "core/species/plant_picture.h"

#include <atomic>

namespace grass {

// A picture of the plant. From the side, and a little above, it is as wide as the plant's reach to both sides, and shows the plant from
// root to tip. From above it is as wide and as deep as that, and shows the upper parts. The mipmaps follow each other, the largest first.
// In each, alpha is the share of a texel that is covered, and transparent texels have the mean of those around them.
struct PlantView {
	std::vector<uint8_t> colors; // RGBA8, sRGB
	std::vector<uint8_t> normals; // RGBA8: x, y, z in the plant's axes, -1..1; alpha unused
	float depth = 0.0f; // towards the eye, where most of the nearer parts are: units of the mesh
};

struct PlantViews {
	std::vector<PlantView> views; // from the sides, the last one from above
	// The share of the picture from above that must be drawn beside those from the side, so that an eye 30 degrees above the horizon sees
	// as much light as of the plant.
	float aslant = 0.0f;
};

// Draws the pictures. The eye of view k of p_sides is beside the plant, at the angle k / p_sides of a turn from x to z; the last view is
// from above, with x to the right and z down. p_surfaces: one unit high, their normals set; p_reach: farthest from the axis; p_texels: a
// power of two. p_is_stopped: once it is true, the result does not matter; null: never.
PlantViews draw_views(std::span<const PictureSurface> p_surfaces, float p_reach, int p_sides, int p_texels,
		const std::atomic<bool> *p_is_stopped = nullptr);

} // namespace grass
