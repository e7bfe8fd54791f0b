// SPDX-License-Identifier: MIT
// Which tiles a body gets that covers more of them than can be awake.
#include "tile_scene.h"

#include <Eigen/Geometry>
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace grass;
using namespace grass::test;

namespace {

constexpr double HALF_LENGTH = 100.0, HALF_WIDTH = 20.0; // metres, of a ship
constexpr double STEP = 0.2; // metres that it sails in a step

// Returns tiles of half a metre, with blades that lean out of them.
TileManager make_sea(int p_pool_size) {
	TileManager manager = make_manager(p_pool_size, TileGrid::make(300.0, 300.0, 256.0));
	TileParams params = manager.get_params();
	params.overhang = 0.3;
	manager.set_params(params);
	return manager;
}

// Its keel lies below the ground, its deck above all grass.
ColliderShape make_ship(double p_angle, double p_way = 0.0) {
	ColliderShape ship;
	ship.type = GRASS_BOX;
	ship.size = { HALF_LENGTH, 3.0, HALF_WIDTH };
	ship.now.rotation = ship.before.rotation = Quaternion(Eigen::AngleAxisd(p_angle, Eigen::Vector3d::UnitY()));
	ship.now.position = ship.now.rotation * Eigen::Vector3d(p_way, 0.0, 0.0) + Eigen::Vector3d(0.0, 2.0, 0.0);
	ship.before.position = ship.now.position - ship.now.rotation * Eigen::Vector3d(p_way > 0.0 ? STEP : 0.0, 0.0, 0.0);
	return ship;
}

// Returns the same with a bow, from a third of its length on.
ColliderShape make_pointed_ship(double p_angle) {
	ColliderShape ship = make_ship(p_angle);
	ship.type = GRASS_HULL;
	const float length = HALF_LENGTH, width = HALF_WIDTH;
	const Eigen::Vector3f bow = Eigen::Vector3f(width, 0.0f, length).normalized(); // from (0, width) to (length, 0)
	for (const float side : { 1.0f, -1.0f }) {
		ship.planes.emplace_back(bow.x(), 0.0f, side * bow.z(), bow.x() * length);
		ship.planes.emplace_back(0.0f, 0.0f, side, width);
		ship.planes.emplace_back(0.0f, side, 0.0f, 3.0f);
	}
	ship.planes.emplace_back(-1.0f, 0.0f, 0.0f, length);
	return ship;
}

bool is_awake_at(const TileManager &p_manager, const Eigen::Vector3d &p_place) {
	const TilePlace tile = p_manager.get_grid().get_place(p_place);
	return p_manager.is_awake(p_manager.get_grid().get_index(tile.x, tile.z));
}

// Places a little inside of straight lines between corners, in the ship, of which no tile is awake. p_from: only those beyond it, along x.
int count_asleep(
		const TileManager &p_manager, const ColliderShape &p_ship, const std::vector<Eigen::Vector2d> &p_corners, double p_from = -1e9) {
	constexpr int PLACES = 1000; // along each line
	constexpr double INSIDE = 1.0 - 1e-4; // of the way from its middle
	int asleep = 0;
	for (size_t i = 0; i < p_corners.size(); i++) {
		const Eigen::Vector2d from = p_corners[i], to = p_corners[(i + 1) % p_corners.size()];
		for (int k = 0; k < PLACES; k++) {
			const Eigen::Vector2d at = INSIDE * (from + (to - from) * (double(k) / PLACES));
			const Eigen::Vector3d place = p_ship.now.rotation * Eigen::Vector3d(at.x(), 0.0, at.y()) + p_ship.now.position;
			asleep += place.x() > p_from && !is_awake_at(p_manager, place);
		}
	}
	return asleep;
}

const std::vector<Eigen::Vector2d> HULL = { { HALF_LENGTH, HALF_WIDTH }, { HALF_LENGTH, -HALF_WIDTH }, { -HALF_LENGTH, -HALF_WIDTH },
	{ -HALF_LENGTH, HALF_WIDTH } };

} // namespace

TEST_CASE("tiles: a ship over four times the pool bends the grass around all of its hull, and none in its middle") {
	for (const double angle : { 0.0, 0.5, 0.25 * std::numbers::pi }) {
		TileManager manager = make_sea(4096);
		for (int i = 0; i < 40; i++) {
			const ColliderShape ship = make_ship(angle, i * STEP);
			const TileStatistics before = manager.get_statistics();
			step(manager, { ship });
			check_consistent(manager);
			const TileStatistics &now = manager.get_statistics();
			CHECK(count_asleep(manager, ship, HULL) == 0);
			CHECK(now.looked_at - before.looked_at < 4 * 4096);
			CHECK(now.list_entries < 4096);
			CHECK(now.refused == 0);
			CHECK(manager.has_met_grass(0));
		}
		CHECK_FALSE(is_awake_at(manager, Eigen::Vector3d::Zero()));
		CHECK(manager.get_statistics().capped > 0);
	}
}

TEST_CASE("tiles: a ship with a bow bends grass along it") {
	TileManager manager = make_sea(4096);
	const ColliderShape ship = make_pointed_ship(0.4);
	step(manager, { ship });
	check_consistent(manager);
	CHECK(count_asleep(manager, ship,
				  { { HALF_LENGTH, 0.0 }, { 0.0, -HALF_WIDTH }, { -HALF_LENGTH, -HALF_WIDTH }, { -HALF_LENGTH, HALF_WIDTH },
						  { 0.0, HALF_WIDTH } }) == 0);
	CHECK_FALSE(is_awake_at(manager, Eigen::Vector3d::Zero()));
}

TEST_CASE("tiles: where the pool is too small for its outline, what is in view goes first") {
	TileManager manager = make_sea(512);
	Frustum frustum;
	frustum.fill(Eigen::Vector4f(-1.0f, 0.0f, 0.0f, -80.0f)); // x > 80
	manager.get_view().see(std::vector<Frustum>{ frustum }, 0.0f);
	const ColliderShape ship = make_ship(0.0);
	step(manager, { ship });
	check_consistent(manager);
	CHECK(count_asleep(manager, ship, HULL, 80.5) == 0);
	CHECK(count_asleep(manager, ship, HULL) > 1000);
	CHECK(manager.get_statistics().awake == 512);
}

TEST_CASE("tiles: hulls that are more than the pool together leave the middle out, too, and what is small beside them gets its tile") {
	TileManager manager = make_sea(4096);
	std::vector<ColliderShape> fleet(6, make_ship(0.0));
	for (int i = 0; i < 6; i++) {
		ColliderShape &ship = fleet[size_t(i)];
		ship.size = { 20.0, 3.0, 10.0 }; // 3,200 tiles each
		ship.now.position = ship.before.position = { 45.0 * (i % 3) - 45.0, 2.0, 30.0 * (i / 3) - 15.0 };
	}
	fleet.push_back(make_ball(manager, 10, 10));
	step(manager, fleet);
	check_consistent(manager);
	for (size_t i = 0; i < 6; i++) {
		CHECK(count_asleep(manager, fleet[i], { { 20, 10 }, { 20, -10 }, { -20, -10 }, { -20, 10 } }) == 0);
		CHECK_FALSE(is_awake_at(manager, fleet[i].now.position));
	}
	CHECK(manager.is_awake(manager.get_grid().get_index(10, 10)));
	CHECK(manager.get_statistics().refused == 0);
}

TEST_CASE("tiles: a ship alone that the pool has room for wakes all that it meets") {
	TileManager manager = make_sea(4096);
	ColliderShape ship = make_ship(0.0);
	ship.size = { 20.0, 3.0, 10.0 };
	step(manager, { ship });
	CHECK(is_awake_at(manager, Eigen::Vector3d::Zero()));
	CHECK(manager.get_statistics().capped == 0);
}

TEST_CASE("tiles: under a body larger than the field one tile tells that it is in grass") {
	TileManager manager = make_manager(16);
	ColliderShape ship = make_ship(0.0);
	ship.size = { 1000.0, 3.0, 1000.0 };
	step(manager, { ship });
	check_consistent(manager);
	CHECK(manager.get_statistics().awake == 1);
	CHECK(manager.has_met_grass(0));
}
