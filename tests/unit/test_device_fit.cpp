// SPDX-License-Identifier: MIT
// What of a field fits on a device: at the limits, just below and just above.
#include "core/field/device_fit.h"
#include "core/tiles/tile_params.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <utility>

using namespace grass;

namespace {

FieldSetup setup_of(double p_side, double p_density, int p_pool) {
	FieldSetup setup;
	setup.grid = TileGrid::make(p_side, p_side, p_density);
	setup.pool_size = p_pool;
	return setup;
}

// Of so many tiles a side.
FieldSetup square_of(int p_tiles) {
	const TileGrid one = TileGrid::make(1.0, 1.0, 256.0);
	return setup_of(double(p_tiles) * one.get_tile_size(), 256.0, 4096);
}

} // namespace

TEST_CASE("A pool keeps to the storage buffer that Vulkan promises") {
	const DeviceLimits promised{ .texture_side = 16384 };
	for (const auto &[asked, expected] : { std::pair{ 0, 0 }, { 1, 1 }, { 4096, 4096 }, { 6241, 6241 }, { 6242, 6241 }, { 16384, 6241 } }) {
		CHECK(fit_device(promised, setup_of(10.0, 256.0, asked)).pool_size == expected);
	}
	CHECK(6241 * SLOT_BYTES <= 134217728);
	CHECK(6242 * SLOT_BYTES > 134217728);
}

TEST_CASE("A pool keeps to the rows of a texture") {
	DeviceLimits limits;
	limits.buffer_bytes = int64_t(1) << 32;
	for (const int rows : { 2048, 4096, 8192, 16384 }) {
		limits.texture_side = rows;
		for (const int asked : { rows - 1, rows, rows + 1 }) {
			CHECK(fit_device(limits, setup_of(10.0, 256.0, asked)).pool_size == std::min(asked, rows));
		}
	}
}

TEST_CASE("A device with room for all of it takes the field as it is") {
	DeviceLimits limits;
	limits.buffer_bytes = int64_t(UINT32_MAX);
	limits.texture_side = 16384;
	FieldSetup setup = setup_of(2000.0, 256.0, TileParams::MAX_POOL_SIZE);
	setup.drawn_tiles_max = int(DRAWN_TILES_MAX.maximum);
	const DeviceFit fit = fit_device(limits, setup);
	CHECK(fit.pool_size == TileParams::MAX_POOL_SIZE);
	CHECK(fit.drawn_tiles_max == int(DRAWN_TILES_MAX.maximum));
	CHECK(fit.lack.empty());
}

TEST_CASE("Instances keep to the storage buffer") {
	FieldSetup setup = setup_of(10.0, 256.0, 64);
	DeviceLimits limits;
	limits.texture_side = 16384;
	for (const auto &[asked, expected] :
			{ std::pair{ 256, 256 }, { 1677721, 1677721 }, { 1677722, 1677721 }, { 4194304, 1677721 } }) { // 80 bytes each
		setup.drawn_tiles_max = asked;
		CHECK(fit_device(limits, setup).drawn_tiles_max == expected);
	}
}

TEST_CASE("The list of drawn tiles keeps to the rows of a texture") {
	FieldSetup setup = setup_of(10.0, 256.0, 64);
	DeviceLimits limits;
	limits.buffer_bytes = int64_t(1) << 32;
	for (const int64_t rows : { 1024, 2048, 4096 }) {
		limits.texture_side = rows;
		setup.drawn_tiles_max = int(DRAWN_TILES_MAX.maximum);
		const int64_t most = fit_device(limits, setup).drawn_tiles_max;
		CHECK(most > (rows - 2) * GRASS_PLACES_PER_ROW * 4 / 5);
		CHECK(1 + (most + most / 4 + GRASS_PLACES_PER_ROW - 1) / GRASS_PLACES_PER_ROW <= rows);
	}
}

TEST_CASE("Tiles whose tables are larger than a storage buffer are not for the device") {
	FieldSetup setup = square_of(5792); // 33,547,264 of 2^25, 4 bytes each
	CHECK(setup.grid.get_tile_count() <= 33554432);
	CHECK(fit_device({}, setup).lack.empty());
	setup = square_of(5793);
	CHECK(setup.grid.get_tile_count() > 33554432);
	CHECK(fit_device({}, setup).lack.find("256 MiB, but the graphics device guarantees only 128 MiB") != std::string::npos);
	setup = square_of(2048); // 2^22; a map takes 20 bytes each
	setup.is_mapped = true;
	CHECK(fit_device({}, setup).lack.empty());
	setup = square_of(2049);
	CHECK(fit_device({}, setup).lack.empty());
	setup.is_mapped = true;
	CHECK_FALSE(fit_device({}, setup).lack.empty());
}

TEST_CASE("A device that lacks what a pass takes is told by name") {
	const FieldSetup setup = setup_of(10.0, 256.0, 64);
	DeviceLimits limits;
	limits.buffers = 14;
	CHECK(fit_device(limits, setup).lack.empty());
	limits.buffers = 13;
	CHECK(fit_device(limits, setup).lack == "The graphics device allows a compute pass 13 storage buffers, but grass needs 14.");
	limits = {};
	limits.shared_bytes = 16383;
	CHECK(fit_device(limits, setup).lack ==
			"The graphics device allows a compute pass 16383 bytes of shared memory, but grass needs 16384.");
	limits = {};
	limits.constant_bytes = 127;
	CHECK(fit_device(limits, setup).lack == "The graphics device allows a compute pass 127 bytes of push constants, but grass needs 128.");
}

TEST_CASE("A dispatch takes as many tiles as a buffer has room for, or all where it needs none") {
	DeviceLimits limits;
	CHECK(count_working_tiles(limits) == 256);
	CHECK(256 * WORK_BYTES == 27525120);
	limits.buffer_bytes = int64_t(1) << 30;
	CHECK(count_working_tiles(limits) == 256);
	limits.buffer_bytes = 256 * WORK_BYTES - 1;
	CHECK(count_working_tiles(limits) == 128);
	limits.has_quick_arrays = true;
	CHECK(count_working_tiles(limits) == 0);
}
