// SPDX-License-Identifier: MIT
// A painted map as bytes, and back: all or nothing. All numbers are little-endian.
//
//   0  8 bytes  "GRASSMAP"
//   8  u32      version: 2, or MAP_FILE_VERSION if the ground has a grid of its own
//  12  u32      code of the base density
//  16  u32      chunks, n
//      u32      the ground's grid, pack_ground_grid(); not in version 2
//      n times  i32 x, i32 z, u32 channels (one bit each), u32 bytes, u32 checksum of them: 20 bytes, rising by key
//      u32      checksum of all above
//      n times  the chunk's bytes: its channels one after the other, filtered, then packed together by the codec
//
// The filter stores how a texel differs from the plane through the neighbours before it (left + above - above left),
// component after component, byte after byte of the codes: painted and smooth ground becomes nearly all zeros.
#pragma once

#include "core/map/paint_map.h"
#include "core/map/read_limits.h"

#include <functional>
#include <string>

namespace grass {

// Older versions are readable. A change that an older reader cannot read needs a new version: a channel, a code that was out of range.
inline constexpr uint32_t MAP_FILE_VERSION = 3; // 1: as 2, or without MAP_PAINT
inline constexpr uint32_t MAP_FILE_UNGRIDDED = 2; // heights at the centres of texels, blended

using MapBytes = std::vector<uint8_t>;

// Compresses a chunk's bytes; the extension uses the engine's compression.
struct MapCodec {
	std::function<MapBytes(std::span<const uint8_t> p_bytes)> pack;
	// Fills r_bytes, which has the size of the unpacked bytes. Returns false if they do not fit.
	std::function<bool(std::span<const uint8_t> p_packed, std::span<uint8_t> r_bytes)> unpack;
};

// Returns the map's bytes, which are always the same for the same map.
MapBytes write_map(const PaintMap &p_map, const MapCodec &p_codec);

// Replaces r_map by the map in the bytes and returns "". If anything is wrong or exceeds p_limits, leaves r_map as it was and returns the
// reason, as the end of a sentence that begins with the file's name. The file's table shows how much memory the map would take: nothing is
// unpacked before that is checked.
std::string read_map(std::span<const uint8_t> p_bytes, const MapCodec &p_codec, PaintMap &r_map, const ReadLimits &p_limits = {});

} // namespace grass
