// SPDX-License-Identifier: MIT
// What the map's file and its changes are written with.
#pragma once

#include "core/map/map_file.h"

#include <cstring>

namespace grass {

inline void put_u32(MapBytes &r_bytes, uint32_t p_value) {
	const size_t at = r_bytes.size();
	r_bytes.resize(at + 4);
	std::memcpy(&r_bytes[at], &p_value, 4);
}

inline uint32_t get_u32(std::span<const uint8_t> p_bytes, size_t p_at) {
	uint32_t value;
	std::memcpy(&value, &p_bytes[p_at], 4);
	return value;
}

// Whether the channel may hold these.
bool are_codes(const MapTexels &p_texels, const MapChannelInfo &p_info);

} // namespace grass
