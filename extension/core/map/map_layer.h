// SPDX-License-Identifier: MIT
// The texels that determine what grows in one chunk, combined from all of its channels.
#pragma once

#include "core/map/map_region.h"

#include <cstdint>
#include <vector>

namespace grass {

struct MapLayer {
	static constexpr int FINE = GRASS_FINE_TEXELS + 2, COARSE = GRASS_COARSE_TEXELS + 2; // texels along a side
	std::vector<uint8_t> growth; // FINE^2 x (density, height, cut, wear)
	std::vector<uint8_t> form; // COARSE^2 x (lean x, z, normal x, z), codes of their channels
	std::vector<float> ground; // COARSE^2, metres
	std::vector<uint8_t> tint; // COARSE^2 x (red, green, blue: each times strength; strength)
	std::vector<uint8_t> species; // COARSE^2: 0: mixed species, n: species n - 1 only
	std::vector<uint8_t> ledge; // GRASS_LEDGE_TEXELS^2 codes of their channel, without a border; empty: no ledge nearby
};

// Updates a chunk's layer in p_region. Returns whether anything changed. p_uncut: code of cuts that cut nothing.
bool compose_layer(const PaintMap &p_map, const MapKey &p_key, int32_t p_uncut, const MapRegion &p_region, MapLayer &r_layer);

} // namespace grass
