// SPDX-License-Identifier: MIT
// Where the roots of a patch's blades are in their tile. May include Eigen, never Godot.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace grass {

// Returns the places of p_count roots in the unit square. Any run of up to GRASS_BLADES_PER_TILE of them is an even sample of the square.
// Its opposite sides count as neighbours, since tiles lie beside tiles. They form no rows in any direction.
std::vector<Eigen::Vector2d> scatter_roots(uint32_t p_seed, int p_count);

} // namespace grass
