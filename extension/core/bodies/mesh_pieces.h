// SPDX-License-Identifier: MIT
// A mesh as a few convex pieces: how the solver takes Godot's ConcavePolygonShape3D where it moves.
#pragma once

#include "core/bodies/hull.h"

#include <Eigen/Core>

#include <future>
#include <span>
#include <vector>

namespace grass {

struct MeshPieces {
	static constexpr int MAX_PIECES = 8; // Each is a collider of its own.
	static constexpr size_t MAX_FACES = 20000; // Above, the mesh is not split: that would take as long as several ticks.

	// p_corners: three a face, metres. Every face lies within the hulls, and so does what a closed mesh encloses, all but hollows
	// of some hundredths of its size. Empty if there are too many faces or nothing is finite.
	static std::vector<Hull> make(std::span<const Eigen::Vector3d> p_corners);

	using Future = std::shared_future<std::vector<Hull>>;
	// On a thread of its own. The last meshes are remembered, so that bodies with the same mesh take the same pieces. Main thread only.
	static Future begin(std::vector<Eigen::Vector3d> p_corners);
};

} // namespace grass
