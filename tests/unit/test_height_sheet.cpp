// SPDX-License-Identifier: MIT
#include "core/map/height_sheet.h"
#include "core/paint/lay_ground.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace grass;

namespace {

const double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

// Two triangles over a square of p_side metres from p_corner, on the plane y = 0.5 x - 0.25 z + p_height.
void add_slope(HeightSheet &r_sheet, const Eigen::Vector2d &p_corner, double p_side, double p_height) {
	const auto at = [&](double p_x, double p_z) {
		const double x = p_corner.x() + p_x * p_side, z = p_corner.y() + p_z * p_side;
		return Eigen::Vector3d(x, 0.5 * x - 0.25 * z + p_height, z);
	};
	r_sheet.add(at(0, 0), at(1, 0), at(1, 1));
	r_sheet.add(at(0, 0), at(1, 1), at(0, 1)); // the other way round
}

} // namespace

TEST_CASE("height sheet: a slope of triangles, whichever way round, without gaps between them") {
	HeightSheet sheet({ { -6, -6 }, { 6, 6 } });
	for (int x = -8; x < 8; x += 2) {
		for (int z = -8; z < 8; z += 2) {
			add_slope(sheet, { x + 0.5, z + 0.5 }, 2.0, 1.0); // corners and edges at centres of texels
		}
	}
	PaintMap map;
	const LaidGround laid = lay_ground(map, { { -6, -6 }, { 6, 6 } }, [&](const Eigen::Vector2d &p_place) { return sheet.at(p_place); });
	CHECK(laid.missing == 0);
	for (double x = -5.3; x < 5.5; x += 0.9) {
		for (double z = -5.3; z < 5.5; z += 0.9) {
			CHECK(map.sample(MAP_GROUND, 0, { x, z }) == doctest::Approx(0.5 * x - 0.25 * z + 1.0).epsilon(1e-3).scale(1.0));
		}
	}
	CHECK(std::abs(map.sample(MAP_NORMAL, 0, { 5.5, -5.5 }) + 0.5 / std::sqrt(1.0 + 0.25 + 0.0625)) < 0.01); // at the region's edge, too
}

TEST_CASE("height sheet: the highest counts; nothing where nothing lies") {
	HeightSheet sheet({ { 0, 0 }, { 8, 8 } });
	add_slope(sheet, { 0, 0 }, 4.0, 3.0);
	add_slope(sheet, { 0, 0 }, 4.0, 1.0);
	CHECK(sheet.at({ 1.5, 1.5 }) == doctest::Approx(0.25 * 1.5 + 3.0));
	CHECK(std::isnan(sheet.at({ 6.5, 1.5 })));
	CHECK(std::isnan(sheet.at({ 100.5, 1.5 })));
	CHECK(std::isnan(sheet.at({ NOT_A_NUMBER, 1.5 })));
}

TEST_CASE("height sheet: triangles that are none, far away or broken, and regions that are none") {
	HeightSheet sheet({ { 0, 0 }, { 8, 8 } });
	sheet.add({ 0, 0, 0 }, { 0, 9, 0 }, { 0, 9, 9 }); // upright
	sheet.add({ 1, 2, 1 }, { 1, 2, 1 }, { 1, 2, 1 });
	sheet.add({ 1e9, 1, 1e9 }, { 2e9, 1, 1e9 }, { 2e9, 1, 2e9 });
	sheet.add({ 0, NOT_A_NUMBER, 0 }, { 8, 1, 0 }, { 8, 1, 8 });
	sheet.add({ NOT_A_NUMBER, 1, 0 }, { 8, 1, 0 }, { 8, 1, 8 });
	for (double x = 0.5; x < 8.0; x++) {
		CHECK(std::isnan(sheet.at({ x, 4.5 })));
	}
	sheet.add({ -1e6, 1, -1e6 }, { 1e6, 1, -1e6 }, { 0, 1, 1e6 }); // over all of it
	CHECK(sheet.at({ 4.5, 4.5 }) == doctest::Approx(1.0));
	for (const MapRegion &region : { MapRegion{ { 1, 1 }, { -9, -9 } }, MapRegion{ { NOT_A_NUMBER, 0 }, { 1, 1 } } }) {
		HeightSheet none(region);
		none.add({ -9, 1, -9 }, { 9, 1, -9 }, { 0, 1, 9 });
		CHECK(std::isnan(none.at({ 0.5, 0.5 })));
	}
}
