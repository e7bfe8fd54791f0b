// SPDX-License-Identifier: MIT
// Finds how much of a field fits on a graphics device, and what else the device lacks for it
// (docs/history/0050-a-refused-pass-means-the-cpu.md).
#pragma once

#include "core/field/field_setup.h"

#include <bit>
#include <cstdint>
#include <string>

namespace grass {

// The limits of a device; the defaults are the minimum that Vulkan guarantees.
struct DeviceLimits {
	int64_t buffer_bytes = 128 << 20; // of a storage buffer
	int64_t texture_side = 4096; // texels
	int64_t buffers = 16; // that a compute pass may read or write; Vulkan guarantees 4, and graphics cards have many
	int64_t shared_bytes = 16384; // for each workgroup
	int64_t constant_bytes = 128; // pushed to a pass
	// Whether the local arrays of a thread stay in its caches, unlike what it stores in a buffer.
	bool has_quick_arrays = false;
};

struct DeviceFit {
	int pool_size = 0, drawn_tiles_max = 0; // of the setup, no larger than fits
	std::string lack; // why the device cannot run the field at all, as a sentence; empty: it can
};

// Bytes of a tile's slot in the largest buffer of the pool: its knots, now and one step earlier.
inline constexpr int64_t SLOT_BYTES = int64_t(2) * 3 * GRASS_FREE_KNOTS * GRASS_BLADES_PER_TILE * int64_t(sizeof(float));

// Bytes that simulate needs for a tile's joints during a step, if they are in a buffer (shaders/solver/work.inc).
inline constexpr int64_t WORK_BYTES = int64_t(GRASS_WORK_PARTS) * 4 * GRASS_SEGMENTS * GRASS_BLADES_PER_TILE * int64_t(sizeof(uint32_t));

// Returns the most tiles that the buffer has room for. 0: there is no buffer, since threads keep their joints in local arrays.
int64_t count_working_tiles(const DeviceLimits &p_limits);
DeviceFit fit_device(const DeviceLimits &p_limits, const FieldSetup &p_setup);
// Returns the number of tiles that buffers have room for, so that a growing field can usually keep them.
inline int64_t tile_room(int64_t p_tiles) {
	return int64_t(std::bit_ceil(uint64_t(p_tiles)));
}

} // namespace grass
