// SPDX-License-Identifier: MIT
#include "core/map/paint_map.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <random>

using namespace grass;

namespace {

constexpr double NAN_VALUE = std::numeric_limits<double>::quiet_NaN();
constexpr double INFINITE = std::numeric_limits<double>::infinity();

} // namespace

TEST_CASE("paint_map: every channel keeps values to half a step of its code, and clamps the rest") {
	for (int channel = 0; channel < MAP_CHANNELS; channel++) {
		const MapChannelInfo &info = info_of(MapChannel(channel));
		INFO("channel ", info.name);
		for (int32_t code = info.lowest; code <= info.highest; code += std::max(1, (info.highest - info.lowest) / 1000)) {
			CHECK(info.code(info.value(code)) == code);
		}
		const double low = info.value(info.lowest), high = info.value(info.highest), middle = 0.3 * low + 0.7 * high;
		CHECK(std::abs(info.value(info.code(middle)) - middle) <= 0.5 * info.unit * 1.0001);
		CHECK(info.code(1e30) == info.highest);
		CHECK(info.code(-INFINITE) == info.lowest);
		CHECK(info.code(NAN_VALUE) == info.zero);
		for (int c = 0; c < info.components; c++) {
			CHECK(info.initial[size_t(c)] >= info.lowest);
			CHECK(info.initial[size_t(c)] <= info.highest);
		}
		CHECK(MAP_CHUNK_SIZE / info.texel_size() == info.side);
	}
}

TEST_CASE("paint_map: what is written is read, in all four corners of the origin") {
	PaintMap map;
	for (int channel = 0; channel < MAP_CHANNELS; channel++) {
		const MapChannelInfo &info = info_of(MapChannel(channel));
		for (const int i : { -info.side - 1, -info.side, -1, 0, info.side - 1, info.side }) {
			for (const int j : { -info.side, -1, 0, info.side }) {
				for (int c = 0; c < info.components; c++) {
					const int32_t code = std::min(3 + c + (i * 7 + j * 3 + 100000) % 200, info.highest);
					CHECK(map.set_code(MapChannel(channel), c, i, j, code));
					CHECK(map.get_code(MapChannel(channel), c, i, j) == code);
				}
			}
		}
		CHECK(map.get_code(MapChannel(channel), 0, 5, 5) == info.initial[0]);
	}
	CHECK(key_of(MAP_DENSITY, -1, 128) == MapKey{ -1, 1 });
	CHECK(key_of(MAP_DENSITY, -128, -129) == MapKey{ -1, -2 });
	CHECK(key_at({ -0.01, 64.0 }) == MapKey{ -1, 1 });
}

TEST_CASE("paint_map: untouched chunks take nothing, and writing what is there touches nothing") {
	PaintMap map;
	CHECK(map.is_empty());
	for (int i = 0; i < 1000; i++) {
		CHECK(map.set_code(MAP_DENSITY, 0, i * 31, i * 17, 0));
		CHECK(map.set_code(MAP_CUT, 0, i * 31, i * 17, 1000)); // clamped to uncut, which is the initial code
	}
	CHECK(map.get_memory_usage() == 0);
	CHECK(map.set_code(MAP_WEAR, 0, 0, 0, 9));
	CHECK(map.get_chunks().size() == 1);
	CHECK(map.get_memory_usage() == info_of(MAP_WEAR).chunk_bytes() + sizeof(MapKey) + sizeof(MapChunk));
	CHECK(map.set_code(MAP_WEAR, 0, 0, 0, 0));
	map.compact();
	CHECK(map.is_empty());
}

TEST_CASE("paint_map: beyond its reach nothing is written, and everything reads as untouched") {
	PaintMap map;
	const int edge = PaintMap::REACH * info_of(MAP_DENSITY).side;
	CHECK(map.set_code(MAP_DENSITY, 0, edge - 1, -edge, 200));
	CHECK_FALSE(map.set_code(MAP_DENSITY, 0, edge, 0, 200));
	CHECK_FALSE(map.set_code(MAP_DENSITY, 0, 0, -edge - 1, 200));
	CHECK(map.get_chunks().size() == 1);
	for (const double far : { 1e5, -1e5, 1e300, INFINITE, -INFINITE, NAN_VALUE }) {
		CHECK(map.sample(MAP_DENSITY, 0, { far, 0.0 }) == 0.0);
		CHECK(map.sample(MAP_HEIGHT, 0, { 0.0, far }) == 1.0);
	}
}

TEST_CASE("paint_map: sampling a plane gives the plane, across chunk borders, too") {
	PaintMap map;
	const double texel = info_of(MAP_GROUND).texel_size();
	for (int j = -70; j < 70; j++) {
		for (int i = -70; i < 70; i++) {
			const double height = 0.25 * (i + 0.5) * texel - 0.5 * (j + 0.5) * texel;
			REQUIRE(map.set_code(MAP_GROUND, 0, i, j, info_of(MAP_GROUND).code(height)));
		}
	}
	std::mt19937 random(3);
	std::uniform_real_distribution<double> place(-69.0, 69.0);
	for (int n = 0; n < 2000; n++) {
		const Eigen::Vector2d at(place(random), place(random));
		CHECK(map.sample(MAP_GROUND, 0, at) == doctest::Approx(0.25 * at.x() - 0.5 * at.y()).epsilon(1e-9));
	}
}

TEST_CASE("paint_map: species are not blended, the nearest texel counts") {
	PaintMap map;
	map.set_code(MAP_SPECIES, 0, -1, 0, 7);
	CHECK(map.sample(MAP_SPECIES, 0, { -0.001, 0.5 }) == 7.0);
	CHECK(map.sample(MAP_SPECIES, 0, { 0.001, 0.5 }) == 0.0);
	CHECK(map.sample(MAP_SPECIES, 0, { -0.999, 0.001 }) == 7.0);
}

TEST_CASE("paint_map: a base density stands where nobody painted") {
	PaintMap map;
	map.set_base_density(1.0);
	CHECK(map.get_base_density() == 1.0);
	CHECK(map.sample(MAP_DENSITY, 0, { 3.0, 4.0 }) == 1.0);
	map.set_code(MAP_DENSITY, 0, 0, 0, 0);
	CHECK(map.get_code(MAP_DENSITY, 0, 0, 0) == 0);
	CHECK(map.get_code(MAP_DENSITY, 0, 1, 0) == 255); // of the same chunk
	map.set_base_density(NAN_VALUE);
	CHECK(map.get_base_density() == 0.0);
}

TEST_CASE("paint_map: a copy keeps every code, and shares texels until they change") {
	PaintMap map;
	std::mt19937 random(5);
	for (int n = 0; n < 5000; n++) {
		const MapChannel channel = MapChannel(random() % MAP_CHANNELS);
		map.set_code(channel, 0, int(random() % 300) - 150, int(random() % 300) - 150, int(random() % 256));
	}
	const PaintMap before = map;
	CHECK(map.compare(before).empty());
	const MapKey key = map.get_keys()[0];
	CHECK(before.find(key)->channels == map.find(key)->channels); // the same texels, not equal ones
	map.set_code(MAP_WEAR, 0, 9 * 128, 9 * 128, 77);
	map.set_code(MAP_DENSITY, 0, -1, -1, map.get_code(MAP_DENSITY, 0, -1, -1) ^ 255);
	CHECK(map.compare(before) == std::vector<MapKey>{ { -1, -1 }, { 9, 9 } });
	CHECK(before.get_code(MAP_WEAR, 0, 9 * 128, 9 * 128) == 0);
	map = before;
	CHECK(map.compare(before).empty());
	CHECK(map.get_chunks().size() == before.get_chunks().size());
}

TEST_CASE("paint_map: texels of a wrong size, out of reach or beyond the map's room are refused") {
	PaintMap map;
	const auto texels = std::make_shared<const MapTexels>(info_of(MAP_HEIGHT).chunk_bytes(), uint8_t(9));
	CHECK_FALSE(map.set_texels({ 0, 0 }, MAP_DENSITY, texels));
	CHECK_FALSE(map.set_texels({ PaintMap::REACH, 0 }, MAP_HEIGHT, texels));
	CHECK(map.is_empty());
	for (size_t n = 0; n < PaintMap::MAX_CHUNKS; n++) { // all share one array of texels
		REQUIRE(map.set_texels({ int(n % 512) - 256, int(n / 512) - 256 }, MAP_HEIGHT, texels));
	}
	CHECK_FALSE(map.set_texels({ 200, 200 }, MAP_HEIGHT, texels));
	CHECK_FALSE(map.set_code(MAP_HEIGHT, 0, 200 * 64, 200 * 64, 1));
	CHECK(map.set_code(MAP_HEIGHT, 0, -256 * 64, -256 * 64, 1)); // chunks that are there may change
}
