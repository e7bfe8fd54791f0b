// SPDX-License-Identifier: MIT
// The colliders of a step, in the form that the passes read.
#pragma once

#include "core/bodies/body_shape.h"

#include <span>
#include <vector>

namespace grass {

class TileColliders {
public:
	void clear();
	// Adds a collider and returns its index. p_segment: of the longest blade, metres, see is_sharp().
	uint32_t add(const ColliderShape &p_collider, const TileGrid &p_grid, double p_segment);

	std::span<const GrassCollider> get() const { return _colliders; }
	std::span<const uint8_t> get_sharp() const { return _sharp; }
	std::span<const Eigen::Vector4f> get_planes() const { return _planes; } // of all hulls, in order
	size_t get_memory_usage() const; // bytes

private:
	std::vector<GrassCollider> _colliders;
	std::vector<uint8_t> _sharp; // for each collider
	std::vector<Eigen::Vector4f> _planes;
};

} // namespace grass
