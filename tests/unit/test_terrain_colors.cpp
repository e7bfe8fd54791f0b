// SPDX-License-Identifier: MIT
#include "core/fill/terrain_picture.h"
#include "core/fill/terrain_piece.h"

#include <doctest/doctest.h>

#include <limits>

using namespace grass;

namespace {

constexpr TerrainColor RED{ 200, 20, 10, 255 };

MapRegion area(double p_half) {
	return { Eigen::Vector2d::Constant(-p_half), Eigen::Vector2d::Constant(p_half) };
}

const TerrainColor &texel(const TerrainColors &p_colors, int p_i, int p_j) {
	return p_colors.get_texels()[size_t(p_j) * size_t(p_colors.get_width()) + size_t(p_i)];
}

} // namespace

TEST_CASE("terrain colors: a texel for each square metre of the field, and what is told lies where it was asked") {
	TerrainColors colors;
	colors.set_area(area(8.0));
	CHECK(colors.get_width() == 16);
	CHECK(colors.take_changed());
	CHECK_FALSE(colors.take_changed());
	CHECK(texel(colors, 3, 3) == TerrainColor()); // nothing told
	TerrainPiece piece({ { 0.0, -2.0 }, { 4.0, 2.0 } });
	while (!piece.is_complete()) {
		std::vector<TerrainSample> row(piece.get_next().size());
		for (size_t i = 0; i < row.size(); i++) {
			row[i].color = RED;
		}
		piece.put_next(row);
	}
	piece.put_colors(colors);
	CHECK(colors.take_changed());
	int red = 0;
	for (int j = 0; j < 16; j++) {
		for (int i = 0; i < 16; i++) {
			const bool is_inside = i >= 8 && i < 12 && j >= 6 && j < 10;
			red += texel(colors, i, j) == RED ? 1 : 0;
			CHECK((texel(colors, i, j) == RED) == is_inside);
		}
	}
	CHECK(red == 16);
	const std::vector<TerrainColor> picture = picture_of(colors);
	CHECK(picture[8 * 16 + 9] == RED);
	CHECK(picture[5 * 16 + 7] == TerrainColor{ RED.red, RED.green, RED.blue, 0 }); // beside a corner: filtered, red stays red
	CHECK(picture[4 * 16 + 7] == TerrainColor());
	piece.put_colors(colors);
	CHECK_FALSE(colors.take_changed()); // the same again
	colors.clear();
	CHECK(colors.take_changed());
	CHECK(texel(colors, 9, 8) == TerrainColor());
}

TEST_CASE("terrain colors: large fields have larger texels, small ones at least one, and places beyond them are left out") {
	TerrainColors colors;
	colors.set_area(area(8192.0));
	CHECK(colors.get_width() == TerrainColors::LARGEST);
	colors.set({ 8191.5, -8191.5 }, RED);
	CHECK(texel(colors, TerrainColors::LARGEST - 1, 0) == RED);
	colors.set_area(area(0.3));
	CHECK(colors.get_width() == 1);
	(void)colors.take_changed();
	for (const double place : { 0.31, -0.31, std::numeric_limits<double>::quiet_NaN(), 1e300 }) {
		colors.set({ place, 0.0 }, RED);
		CHECK_FALSE(colors.take_changed());
	}
}

TEST_CASE("terrain colors: what is no colour tells nothing") {
	const double nan = std::numeric_limits<double>::quiet_NaN();
	CHECK(TerrainColor::of(nan, 0.0, 0.0, 1.0) == TerrainColor());
	CHECK(TerrainColor::of(0.0, 0.0, 0.0, nan) == TerrainColor());
	CHECK(TerrainColor::of(2.0, -1.0, 0.5, 1.0) == TerrainColor{ 255, 0, 128, 255 });
}
