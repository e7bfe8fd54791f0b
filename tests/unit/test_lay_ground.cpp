// SPDX-License-Identifier: MIT
#include "core/paint/lay_ground.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace grass;

TEST_CASE("lay_ground: heights and normals of a smooth hill, over chunk borders") {
	PaintMap map;
	const auto hill = [](const Eigen::Vector2d &p_place) { return 2.0 * std::sin(0.1 * p_place.x()) + 0.3 * p_place.y(); };
	const LaidGround laid = lay_ground(map, { { -20, -10 }, { 20, 10 } }, hill);
	CHECK(laid.changed.size() == 4);
	CHECK(laid.missing == 0);
	CHECK(laid.sampled == 42 * 22);
	CHECK_FALSE(laid.out_of_room);
	for (double x = -19.0; x < 19.0; x += 1.7) {
		for (double z = -9.0; z < 9.0; z += 1.3) {
			CHECK(map.sample(MAP_GROUND, 0, { x, z }) == doctest::Approx(hill({ x, z })).epsilon(0.01).scale(1.0));
			const Eigen::Vector3d normal = Eigen::Vector3d(-0.2 * std::cos(0.1 * x), 1.0, -0.3).normalized();
			CHECK(std::abs(map.sample(MAP_NORMAL, 0, { x, z }) - normal.x()) < 0.01);
			CHECK(std::abs(map.sample(MAP_NORMAL, 1, { x, z }) - normal.z()) < 0.01);
		}
	}
	CHECK(map.sample(MAP_GROUND, 0, { 25.0, 0.0 }) == 0.0);
	CHECK(lay_ground(map, { { -20, -10 }, { 20, 10 } }, hill).changed.empty());
}

TEST_CASE("lay_ground: where there is no ground the map stays as it was, and slopes come from what there is") {
	PaintMap map;
	const auto shelf = [](const Eigen::Vector2d &p_place) {
		return p_place.x() < 0.0 ? 0.5 * p_place.x() : std::numeric_limits<double>::quiet_NaN();
	};
	const LaidGround laid = lay_ground(map, { { -4, -4 }, { 4, 4 } }, shelf);
	CHECK(laid.missing == 32);
	CHECK(map.get_code(MAP_GROUND, 0, 0, 0) == 0);
	CHECK(map.get_code(MAP_GROUND, 0, -1, 0) == info_of(MAP_GROUND).code(-0.25));
	CHECK(map.get_code(MAP_NORMAL, 0, -1, 0) == info_of(MAP_NORMAL).code(-0.5 / std::sqrt(1.25)));
	CHECK(laid.max.x() == 0.0);
}

TEST_CASE("lay_ground: regions that are no regions, and those out of reach") {
	PaintMap map;
	const auto flat = [](const Eigen::Vector2d &) { return 1.0; };
	const double nan = std::numeric_limits<double>::quiet_NaN(), reach = PaintMap::REACH * MAP_CHUNK_SIZE;
	CHECK(lay_ground(map, { { nan, 0 }, { 1, 1 } }, flat).sampled == 0);
	CHECK(lay_ground(map, { { 1, 1 }, { 0, 0 } }, flat).sampled == 0);
	CHECK(lay_ground(map, { { 0.6, 0.6 }, { 0.9, 0.9 } }, flat).sampled == 0); // no centre of a texel
	const LaidGround laid = lay_ground(map, { { reach - 2.0, 0 }, { reach + 3.0, 2 } }, flat);
	CHECK(laid.out_of_room);
	CHECK(laid.changed.size() == 1);
	CHECK(lay_ground(map, { { reach + 10.0, 0 }, { reach + 20.0, 9 } }, flat).sampled == 0);
}
