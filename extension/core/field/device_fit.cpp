// SPDX-License-Identifier: MIT
#include "core/field/device_fit.h"

#include "core/map/tile_cover.h"

#include <algorithm>

namespace grass {

namespace {

// Needs of the most demanding pass: simulate, with species and edges. All of its bindings except the patch and the pool's texture are
// buffers.
constexpr int64_t NEEDED_BUFFERS = GRASS_BINDING_WORK + 1 - 2;
constexpr int64_t NEEDED_SHARED_BYTES = 16384;
constexpr int64_t NEEDED_CONSTANT_BYTES = sizeof(GrassStep);
constexpr int64_t INSTANCE_BYTES = GRASS_INSTANCE_FLOATS * int64_t(sizeof(float));

std::string lack_of(const char *p_what, int64_t p_has, int64_t p_needed) {
	return std::string("The graphics device allows a compute pass ") + std::to_string(p_has) + " " + p_what + ", but grass needs " +
			std::to_string(p_needed) + ".";
}

std::string find_lack(const DeviceLimits &p_limits, const FieldSetup &p_setup) {
	if (p_limits.buffers < NEEDED_BUFFERS) {
		return lack_of("storage buffers", p_limits.buffers, NEEDED_BUFFERS);
	}
	if (p_limits.shared_bytes < NEEDED_SHARED_BYTES) {
		return lack_of("bytes of shared memory", p_limits.shared_bytes, NEEDED_SHARED_BYTES);
	}
	if (p_limits.constant_bytes < NEEDED_CONSTANT_BYTES) {
		return lack_of("bytes of push constants", p_limits.constant_bytes, NEEDED_CONSTANT_BYTES);
	}
	const int64_t tile_bytes = p_setup.is_mapped ? int64_t(sizeof(TileCover::Tile)) : int64_t(sizeof(uint32_t));
	const int64_t bytes = tile_room(int64_t(p_setup.grid.get_tile_count())) * tile_bytes;
	if (bytes > p_limits.buffer_bytes) {
		return "The field's tiles need a buffer of " + std::to_string(bytes >> 20) + " MiB, but the graphics device guarantees only " +
				std::to_string(p_limits.buffer_bytes >> 20) + " MiB. Lower `size` or `density`, or use several fields.";
	}
	return {};
}

} // namespace

int64_t count_working_tiles(const DeviceLimits &p_limits) {
	if (p_limits.has_quick_arrays) {
		return 0;
	}
	const int64_t tiles = std::clamp<int64_t>(p_limits.buffer_bytes / WORK_BYTES, 1, GRASS_WORKING_TILES);
	return int64_t(std::bit_floor(uint64_t(tiles)));
}

DeviceFit fit_device(const DeviceLimits &p_limits, const FieldSetup &p_setup) {
	DeviceFit fit;
	fit.lack = find_lack(p_limits, p_setup);
	const int64_t slots = std::min(p_limits.buffer_bytes / SLOT_BYTES, p_limits.texture_side); // the pool's texture has a row a slot
	fit.pool_size = int(std::min<int64_t>(p_setup.pool_size, slots));
	const int64_t listed = (p_limits.texture_side - 1) * GRASS_PLACES_PER_ROW * 4 / 5; // a fifth of the list is for shadows
	fit.drawn_tiles_max = int(std::min({ int64_t(p_setup.drawn_tiles_max), p_limits.buffer_bytes / INSTANCE_BYTES, listed }));
	return fit;
}

} // namespace grass
