// SPDX-License-Identifier: MIT
// Where the roots of a patch's blades stand in their tile. May include Eigen, never Godot.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace grass {

// Returns the places of p_count roots in the unit square. Any run of up to GRASS_BLADES_PER_TILE of them is an even sample of it, and its
// opposite sides border on each other: tiles lie beside tiles. No direction has rows.
std::vector<Eigen::Vector2d> scatter_roots(uint32_t p_seed, int p_count);

} // namespace grass
