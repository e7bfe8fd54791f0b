// SPDX-License-Identifier: MIT
// A mesh as a few convex pieces: the solver's form of Godot's ConcavePolygonShape3D on a body that moves.
#pragma once

#include "core/bodies/hull.h"

#include <Eigen/Core>

#include <future>
#include <span>
#include <vector>

namespace grass {

struct MeshPieces {
	static constexpr int MAX_PIECES = 8; // Each is a collider of its own.
	static constexpr size_t MAX_FACES = 20000; // A larger mesh is not split, since that would take as long as several ticks.

	// Splits a mesh. p_corners: three for each face, metres. The hulls contain every face, and whatever a closed mesh encloses except for
	// hollows of some hundredths of its size. Empty if there are too many faces or no value is finite.
	static std::vector<Hull> make(std::span<const Eigen::Vector3d> p_corners);

	using Future = std::shared_future<std::vector<Hull>>;
	// Does the same on a thread of its own. The results of the last meshes are kept, so that bodies with the same mesh share their pieces.
	// Main thread only.
	static Future begin(std::vector<Eigen::Vector3d> p_corners);
};

} // namespace grass
