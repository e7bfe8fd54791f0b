// SPDX-License-Identifier: MIT
#include "core/tiles/tiles.h"

#include <doctest/doctest.h>

using namespace grass;

namespace {

ColliderShape ball_at(double p_x, double p_y) {
	ColliderShape ball;
	ball.size.x() = 0.1;
	ball.now.position = ball.before.position = { p_x, p_y, 0.2 };
	return ball;
}

} // namespace

TEST_CASE("tiles: a tile's bend is the one that was reported since it woke [Eq M5]") {
	TileManager tiles;
	tiles.set_grid(TileGrid::make(8.0, 8.0, 256.0));
	TileParams params;
	params.pool_size = 1;
	tiles.set_params(params);
	const auto step = [&](double p_x) {
		ColliderShape ball = ball_at(p_x, 0.2);
		tiles.update(1.0 / 60.0, { &ball, 1 });
	};
	const float energy = 1.0f;
	Eigen::Vector3f bend(0.5f, -0.25f, 0.0f);
	step(0.25);
	const int first = tiles.get_tile_of(0);
	CHECK(tiles.get_bend(first).isZero());
	tiles.report_energy({ 1, { &energy, 1 }, { &bend, 1 } });
	CHECK(tiles.get_bend(first) == bend);
	for (int n = 0; n < 3; n++) {
		step(3.0); // the only slot goes to another tile once the first is not touched
	}
	const int second = tiles.get_tile_of(0);
	CHECK(second != first);
	CHECK(tiles.get_bend(first).isZero());
	tiles.report_energy({ 1, { &energy, 1 }, { &bend, 1 } });
	CHECK(tiles.get_bend(second).isZero()); // measured when the slot was the first tile's
	bend.x() = std::nanf("");
	tiles.report_energy({ tiles.get_step_number(), { &energy, 1 }, { &bend, 1 } });
	CHECK(tiles.get_bend(second).isZero());
	CHECK(tiles.get_bend(-1).isZero());
}

TEST_CASE("tiles: which colliders met grass, also where the pool is full") {
	TileManager tiles;
	tiles.set_grid(TileGrid::make(8.0, 8.0, 256.0));
	TileParams params;
	params.pool_size = 1;
	tiles.set_params(params);
	ColliderShape balls[] = { ball_at(0.25, 0.2), ball_at(2.25, 0.2), ball_at(0.25, 5.0), ball_at(9.0, 0.2), ball_at(std::nan(""), 0.2) };
	tiles.update(1.0 / 60.0, balls);
	CHECK(tiles.has_met_grass(0));
	CHECK(tiles.has_met_grass(1));
	CHECK_FALSE(tiles.has_met_grass(2));
	CHECK_FALSE(tiles.has_met_grass(3));
	CHECK_FALSE(tiles.has_met_grass(4));
	CHECK_FALSE(tiles.has_met_grass(5));
	tiles.update(1.0 / 60.0, {});
	CHECK_FALSE(tiles.has_met_grass(0));
}
