// SPDX-License-Identifier: MIT
// The changes between two states of a map, as bytes: for a server that sends them to its clients, in order. All numbers are little-endian.
//
//   0  8 bytes  "GRASSDIF"
//   8  u32      version, MAP_CHANGES_VERSION
//  12  u32      code of the base density before
//  16  u32      after
//  20  u32      changes, n
//  24  u32      the ground's grid before, as in a map's file
//  28  u32      after
//  32  n times  i32 x, i32 z, u32 channel, u32 checksum of its texels before, u32 after, u32 bytes: 24 bytes, rising by chunk and channel
//      n times  the bytes: texels before ^ after, packed by the codec
//      u32      checksum of all above
//
// A change fits a map whose texels there have the checksum before. So changes of different places may come in any order, changes of the
// same place must keep their order, and a change that comes again has no effect.
#pragma once

#include "core/map/map_file.h"

#include <string>

namespace grass {

inline constexpr uint32_t MAP_CHANGES_VERSION = 2;

// Returns the changes; no bytes if the maps are the same.
MapBytes write_changes(const PaintMap &p_before, const PaintMap &p_after, const MapCodec &p_codec);

struct AppliedChanges {
	std::string reason; // why they were rejected, as the end of a sentence; "": all of them are in the map
	std::vector<MapKey> changed; // chunks
	bool has_base_changed = false;
};

// Applies all changes to r_map, or leaves it as it was. A chunk that r_map has may change wherever it is; new chunks must be within the
// limits.
AppliedChanges apply_changes(std::span<const uint8_t> p_bytes, const MapCodec &p_codec, PaintMap &r_map, const ReadLimits &p_limits = {});

} // namespace grass
