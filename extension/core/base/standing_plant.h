// SPDX-License-Identifier: MIT
// A blade of a tile that its species draws as a mesh. The pass that chooses species hands it on to culling.
#pragma once

#include <Eigen/Core>

#include <cstdint>

namespace grass {

// A plant in a tile.
struct StandingPlant {
	uint8_t blade, species;
	Eigen::Vector2f root; // place in the tile, 0..1
};

} // namespace grass
