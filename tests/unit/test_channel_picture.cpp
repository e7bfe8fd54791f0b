// SPDX-License-Identifier: MIT
#include "map_scene.h"

#include "core/paint/channel_picture.h"
#include "core/paint/picture_header.h"

#include <doctest/doctest.h>

#include <limits>
#include <random>

using namespace grass;
using namespace grass::test;

namespace {

bool are_same(const PaintMap &p_a, const PaintMap &p_b) {
	return write_map(p_a, RUNS) == write_map(p_b, RUNS);
}

LaidPicture lay_floats(PaintMap &r_map, MapChannel p_channel, const TexelRect &p_rect, const std::vector<float> &p_values) {
	Pixels pixels(p_values.size() * 4);
	std::memcpy(pixels.data(), p_values.data(), pixels.size());
	return lay_picture(r_map, p_channel, p_rect, pixels, picture_format(p_channel, true));
}

void check_refused(
		MapChannel p_channel, const TexelRect &p_rect, const Pixels &p_pixels, const PixelFormat &p_format, const char *p_reason) {
	PaintMap map = make_map(5);
	const PaintMap before = map;
	const LaidPicture laid = lay_picture(map, p_channel, p_rect, p_pixels, p_format);
	CHECK(laid.reason.find(p_reason) != std::string::npos);
	CHECK(laid.changed.empty());
	CHECK(map.compare(before).empty());
}

} // namespace

TEST_CASE("channel_picture: out and in again nothing has changed") {
	std::mt19937 random(9);
	for (int n = 0; n < MAP_CHANNELS; n++) {
		const MapChannel channel = MapChannel(n);
		for (const bool is_float : { false, true }) {
			const PaintMap map = make_map(uint32_t(n) + 1);
			PaintMap same = map;
			const int side = info_of(channel).side;
			const TexelRect rect{ int(random() % 300) - 3 * side, int(random() % 300) - 3 * side, 5 * side + 7, 4 * side + 3 };
			const Pixels pixels = read_pixels(map, channel, rect, is_float);
			const PixelFormat format = picture_format(channel, is_float);
			CHECK(pixels.size() == rect.count() * format.bytes());
			const LaidPicture laid = lay_picture(same, channel, rect, pixels, format);
			CHECK(laid.reason == "");
			CHECK(laid.clamped == 0);
			CHECK(laid.changed.empty());
			CHECK(same.get_keys() == map.get_keys());
			CHECK(are_same(same, map));
		}
	}
}

TEST_CASE("channel_picture: into an empty map it brings just its texels, and chunks only where they differ") {
	for (int n = 0; n < MAP_CHANNELS; n++) {
		const MapChannel channel = MapChannel(n);
		const PaintMap map = make_map(uint32_t(n) + 30);
		PaintMap other;
		other.set_base_density(map.get_base_density());
		const int side = info_of(channel).side;
		const TexelRect rect{ -side + 3, -2 * side, 2 * side, 3 * side - 5 };
		const LaidPicture laid = lay_picture(other, channel, rect, read_pixels(map, channel, rect, true), picture_format(channel, true));
		CHECK(laid.reason == "");
		size_t wrong = 0;
		for (int j = -3 * side; j < 2 * side; j++) {
			for (int i = -3 * side; i < 2 * side; i++) {
				const bool is_inside = i >= rect.i && j >= rect.j && i < rect.i + rect.width && j < rect.j + rect.depth;
				for (int component = 0; component < info_of(channel).components; component++) {
					wrong += other.get_code(channel, component, i, j) !=
									(is_inside ? map.get_code(channel, component, i, j) : other.initial_code(channel, component))
							? 1
							: 0;
				}
			}
		}
		CHECK(wrong == 0);
		for (const MapKey &key : laid.changed) {
			CHECK(other.find(key) != nullptr);
		}
		CHECK(other.get_chunks().size() <= laid.changed.size());
	}
}

TEST_CASE("channel_picture: painted bytes become codes, from black to white") {
	PaintMap map;
	const TexelRect rect{ 10, 20, 2, 1 };
	const LaidPicture laid = lay_picture(map, MAP_HEIGHT, rect, Pixels{ 0, 128 }, { 1, false, false });
	CHECK(laid.changed == std::vector<MapKey>{ { 0, 0 } });
	CHECK(laid.min == Eigen::Vector2d(10, 20));
	CHECK(laid.max == Eigen::Vector2d(12, 21));
	CHECK(map.get_code(MAP_HEIGHT, 0, 10, 20) == 0);
	CHECK(map.get_code(MAP_HEIGHT, 0, 11, 20) == 128);
	CHECK(lay_picture(map, MAP_HOLE, rect, Pixels{ 255, 100 }, { 1, false, false }).reason == "");
	CHECK(map.get_code(MAP_HOLE, 0, 10, 20) == 1);
	CHECK(map.get_code(MAP_HOLE, 0, 11, 20) == 0);
	// A grey picture with an opaque alpha, one in colours that are grey, and a tint without alpha.
	CHECK(lay_picture(map, MAP_WEAR, rect, Pixels{ 9, 255, 8, 255 }, { 1, true, false }).reason == "");
	CHECK(map.get_code(MAP_WEAR, 0, 11, 20) == 8);
	CHECK(lay_picture(map, MAP_WEAR, rect, Pixels{ 7, 7, 7, 6, 6, 6 }, { 3, false, false }).reason == "");
	CHECK(map.get_code(MAP_WEAR, 0, 11, 20) == 6);
	CHECK(lay_picture(map, MAP_TINT, rect, Pixels{ 1, 2, 3, 4, 5, 6 }, { 3, false, false }).reason == "");
	CHECK(map.get_code(MAP_TINT, 2, 11, 20) == 6);
	CHECK(map.get_code(MAP_TINT, 3, 11, 20) == 255);
}

TEST_CASE("channel_picture: NaN leaves a texel, other values are clamped and counted") {
	PaintMap map;
	map.set_code(MAP_CUT, 0, 0, 0, 40);
	const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
	const LaidPicture laid = lay_floats(map, MAP_CUT, { 0, 0, 4, 1 }, { nan, 0.101f, -3.0f, infinity });
	CHECK(laid.reason == "");
	CHECK(laid.clamped == 2);
	CHECK(map.get_code(MAP_CUT, 0, 0, 0) == 40);
	CHECK(map.get_code(MAP_CUT, 0, 1, 0) == 10);
	CHECK(map.get_code(MAP_CUT, 0, 2, 0) == 0);
	CHECK(map.get_code(MAP_CUT, 0, 3, 0) == MAP_UNCUT_CODE);
}

TEST_CASE("channel_picture: a density that changes counts as painted by hand") {
	PaintMap map;
	map.set_base_density(1.0);
	CHECK(lay_picture(map, MAP_DENSITY, { 0, 0, 2, 1 }, Pixels{ 255, 60 }, { 1, false, false }).changed.size() == 1);
	CHECK(map.get_code(MAP_PAINT, 1, 0, 0) == 0); // unchanged
	CHECK(map.get_code(MAP_PAINT, 0, 1, 0) == 60);
	CHECK(map.get_code(MAP_PAINT, 1, 1, 0) == 255);
}

TEST_CASE("channel_picture: slopes follow where heights change, and only there") {
	PaintMap map;
	map.set_code(MAP_NORMAL, 0, 30, 30, 200);
	map.set_code(MAP_HOLE, 0, 5, 4, 1);
	std::vector<float> heights(10 * 10);
	for (size_t n = 0; n < heights.size(); n++) {
		heights[n] = 0.5f * float(n % 10); // rises along x
	}
	const LaidPicture laid = lay_floats(map, MAP_GROUND, { 0, 0, 10, 10 }, heights);
	CHECK(laid.reason == "");
	CHECK(map.sample(MAP_GROUND, 0, { 4.5, 4.5 }) == doctest::Approx(2.0));
	CHECK(map.sample(MAP_NORMAL, 0, { 2.5, 2.5 }) == doctest::Approx(-0.5 / std::sqrt(1.25)).epsilon(0.01));
	CHECK(map.get_code(MAP_NORMAL, 0, 30, 30) == 200);
	CHECK(map.get_code(MAP_HOLE, 0, 5, 4) == 1); // stays one
}

TEST_CASE("channel_picture: what does not fit is refused whole") {
	const TexelRect rect{ 0, 0, 2, 1 };
	check_refused(MAP_GROUND, rect, Pixels{ 1, 2 }, { 1, false, false }, "has 8 bits a pixel, but ground is in metres");
	check_refused(MAP_LEAN, rect, Pixels{ 1, 2 }, { 1, false, false }, "is grey, but lean has 2 numbers a texel");
	check_refused(MAP_TINT, rect, Pixels{ 1, 2, 3, 4 }, { 2, false, false }, "is grey, but tint has 4 numbers a texel");
	check_refused(
			MAP_HEIGHT, rect, Pixels{ 1, 1, 1, 1, 1, 2 }, { 3, false, false }, "is in colour at pixel (1, 0), but height is one number");
	check_refused(MAP_HEIGHT, rect, Pixels{ 1, 255, 1, 254 }, { 1, true, false }, "is transparent at pixel (1, 0)");
}

TEST_CASE("channel_picture: a region covers the texels that it meets") {
	const auto check = [](const MapRegion &p_region, const TexelRect &p_rect) {
		const TexelRect rect = texels_in(MAP_DENSITY, p_region); // half a metre each
		CHECK(rect.i == p_rect.i);
		CHECK(rect.j == p_rect.j);
		CHECK(rect.width == p_rect.width);
		CHECK(rect.depth == p_rect.depth);
	};
	check({ { -1.0, 2.0 }, { 3.0, 2.5 } }, { -2, 4, 8, 1 });
	check({ { -1.1, 2.0 }, { 3.2, 2.6 } }, { -3, 4, 10, 2 });
	check({ { double(-0.1f), 0.0 }, { double(0.4f), 0.5 } }, { -1, 0, 2, 1 });
	PaintMap map;
	CHECK_FALSE(find_painted(map, MAP_DENSITY).has_value());
	map.set_code(MAP_DENSITY, 0, -1, 300, 9);
	map.set_code(MAP_DENSITY, 0, 0, 0, 9);
	map.set_code(MAP_WEAR, 0, 3000, 0, 9);
	CHECK(find_painted(map, MAP_DENSITY) == MapRegion{ { -64, 0 }, { 64, 192 } });
}

TEST_CASE("picture_header: size, depth and colour space of a file, whole or broken") {
	const auto put = [](Pixels &r_bytes, uint32_t p_value) {
		for (int shift = 24; shift >= 0; shift -= 8) {
			r_bytes.push_back(uint8_t(p_value >> shift));
		}
	};
	const auto png = [&](uint8_t p_depth, uint32_t p_gamma, bool p_is_srgb) {
		Pixels bytes{ 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 0, 0, 0, 13, 'I', 'H', 'D', 'R' };
		put(bytes, 640);
		put(bytes, 70000);
		bytes.insert(bytes.end(), { p_depth, 0, 0, 0, 0, 1, 2, 3, 4 });
		if (p_gamma > 0) {
			bytes.insert(bytes.end(), { 0, 0, 0, 4, 'g', 'A', 'M', 'A' });
			put(bytes, p_gamma);
			put(bytes, 0);
		}
		if (p_is_srgb) {
			bytes.insert(bytes.end(), { 0, 0, 0, 1, 's', 'R', 'G', 'B', 0, 0, 0, 0, 0 });
		}
		bytes.insert(bytes.end(), { 0, 0, 0, 9, 'I', 'D', 'A', 'T', 0, 0, 0, 0, 0 });
		return bytes;
	};
	const PictureHeader header = read_picture_header(png(8, 45455, false));
	CHECK(header.kind == PictureHeader::PNG);
	CHECK(header.width == 640);
	CHECK(header.height == 70000);
	CHECK(header.reason == "");
	CHECK(read_picture_header(png(8, 100000, true)).reason == "");
	CHECK(read_picture_header(png(8, 100000, false)).reason.find("colour space") != std::string::npos);
	CHECK(read_picture_header(png(16, 0, true)).reason.find("16 bits") != std::string::npos);
	Pixels exr{ 0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0 };
	for (const char letter : std::string("dataWindow\0box2i\0\x10\0\0\0", 21)) {
		exr.push_back(uint8_t(letter));
	}
	for (const uint8_t corner : { 2, 3, 201, 102 }) {
		exr.insert(exr.end(), { corner, 0, 0, 0 });
	}
	CHECK(read_picture_header(exr).kind == PictureHeader::EXR);
	CHECK(read_picture_header(exr).width == 200);
	CHECK(read_picture_header(exr).height == 100);
	for (const Pixels &whole : { exr, png(8, 45455, true) }) {
		for (size_t size = 0; size < whole.size(); size++) {
			CHECK(read_picture_header(std::span(whole).first(size)).width <= 640);
		}
	}
	CHECK(read_picture_header(Pixels{ 'G', 'I', 'F' }).kind == PictureHeader::UNKNOWN);
	std::mt19937 random(2);
	for (int n = 0; n < 2000; n++) {
		Pixels broken = png(8, 45455, n % 2 == 0);
		broken[random() % broken.size()] = uint8_t(random());
		(void)read_picture_header(broken);
	}
}
