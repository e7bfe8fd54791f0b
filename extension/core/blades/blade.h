// SPDX-License-Identifier: MIT
// Where a blade stands and what shape it has at rest. Twin of shaders/blades/blade.inc: same names, same
// order of operations.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/blades/clump.h"

namespace grass {

// Field-space x, z (metres) of a root.
// p_tile: tile coordinate; p_root: place in the tile, 0..1; p_tiles: tiles along x, z; p_tile_size: metres.
inline Eigen::Vector2f root_place(
		const Eigen::Vector2f &p_tile, const Eigen::Vector2f &p_root, const Eigen::Vector2f &p_tiles, float p_tile_size) {
	return (p_tile + p_root - 0.5f * p_tiles) * p_tile_size;
}

// [Eq B3] What the rotation that tilts the vertical towards p_lean (x, z; length = tangent of half the angle)
// adds to p_v.
inline Eigen::Vector3f tilt_change(const Eigen::Vector3f &p_v, const Eigen::Vector2f &p_lean) {
	const Eigen::Vector3f axis(p_lean.y(), 0.0f, -p_lean.x());
	const Eigen::Vector3f turned = axis.cross(p_v);
	return (2.0f / (1.0f + p_lean.squaredNorm())) * (turned + axis.cross(turned));
}

// [Eq B4] Knot p_k of the rest pose, in blade space, from the patch's texel.
inline Eigen::Vector3f rest_knot(const Eigen::Vector3f &p_texel, int p_k, const Clump &p_clump) {
	const Eigen::Vector3f knot = p_texel * p_clump.height;
	return p_k == 0 ? Eigen::Vector3f(Eigen::Vector3f::Zero()) : Eigen::Vector3f(knot + tilt_change(knot, p_clump.lean));
}

} // namespace grass
