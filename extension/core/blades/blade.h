// SPDX-License-Identifier: MIT
// A blade's root, and its shape at rest (shaders/blades/blade.inc).
#pragma once

#include "core/blades/clump.h"

namespace grass {

// Returns a root's place in field space, x and z in metres: see grass_root_place().
inline Eigen::Vector2f root_place(
		const Eigen::Vector2f &p_tile, const Eigen::Vector2f &p_root, const Eigen::Vector2f &p_tiles, float p_tile_size) {
	return from_glsl(glsl::grass_root_place(to_glsl(p_tile), to_glsl(p_root), to_glsl(p_tiles), p_tile_size));
}

// [Eq B4] Returns knot p_k of the rest pose in blade space, from the patch's texel.
inline Eigen::Vector3f rest_knot(const Eigen::Vector3f &p_texel, int p_k, const Clump &p_clump) {
	return from_glsl(glsl::grass_rest_knot(to_glsl(p_texel), p_k, p_clump));
}

// Returns the length of a blade, metres, from its knot 1.
inline float blade_length(const Eigen::Vector3f &p_knot) {
	return glsl::grass_blade_length(to_glsl(p_knot));
}

} // namespace grass
