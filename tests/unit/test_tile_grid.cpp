// SPDX-License-Identifier: MIT
#include "core/base/tile_grid.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace grass;

namespace {

constexpr double NAN_VALUE = std::numeric_limits<double>::quiet_NaN();
constexpr double INFINITE = std::numeric_limits<double>::infinity();

} // namespace

TEST_CASE("tile_grid: tiles hold 64 blades at the density asked for, whole tiles make up the field") {
	const TileGrid grid = TileGrid::make(32.0, 20.2, 256.0);
	CHECK(grid.get_tile_size() == 0.5);
	CHECK(grid.get_tiles_x() == 64);
	CHECK(grid.get_tiles_z() == 40);
	CHECK(grid.get_tile_count() == 2560);
	CHECK(grid.get_size_x() == 32.0);
	CHECK_FALSE(grid.was_limited());
	CHECK(TileGrid::make(10.0, 10.0, 64.0).get_tile_size() == 1.0);
	CHECK(TileGrid::make(0.01, 0.01, 256.0).get_tile_count() == 1);
	const double odd = TileGrid::make(10.0, 10.0, 100.0).get_tile_size();
	CHECK(odd == doctest::Approx(0.8));
	CHECK(odd == double(float(odd)));
}

TEST_CASE("tile_grid: bad sizes and densities give a grid within limits, and it tells") {
	const double values[] = { NAN_VALUE, -1.0, 0.0, 1e-300, 1.0, 1e6, 1e30, INFINITE, -INFINITE };
	for (const double size : values) {
		for (const double density : values) {
			const TileGrid grid = TileGrid::make(size, 3.0, density);
			CHECK(grid.get_tiles_x() >= 1);
			CHECK(grid.get_tiles_x() <= TileGrid::MAX_TILES_PER_SIDE);
			CHECK(grid.get_tile_count() > 0);
			CHECK(grid.get_tile_size() >= 0.125);
			CHECK(grid.get_tile_size() <= 16.0);
		}
		CHECK(TileGrid::make(1.0, 1.0, size).was_limited() == !(size == 1.0));
	}
	CHECK(TileGrid::make(1e9, 1e9, 4096.0).get_tile_count() == TileGrid::MAX_TILES_PER_SIDE * TileGrid::MAX_TILES_PER_SIDE);
	CHECK(TileGrid::make(NAN_VALUE, 1.0, 256.0).was_limited());
	CHECK(TileGrid::make(5000.0, 1.0, 256.0).was_limited());
}

TEST_CASE("tile_grid: tile (0, 0) is the -x, -z corner, the grid is centred") {
	const TileGrid grid = TileGrid::make(2.0, 1.5, 256.0); // 4 x 3 tiles
	CHECK(grid.get_centre(0, 0).isApprox(Eigen::Vector3d(-0.75, 0.0, -0.5)));
	CHECK(grid.get_centre(3, 2).isApprox(Eigen::Vector3d(0.75, 0.0, 0.5)));
	for (int index = 0; index < grid.get_tile_count(); index++) {
		const int x = grid.get_x(index), z = grid.get_z(index);
		CHECK(grid.has_tile(x, z));
		CHECK(grid.get_index(x, z) == index);
		const TilePlace place = grid.get_place(grid.get_centre(x, z) + Eigen::Vector3d(0.2, 0.7, -0.2));
		CHECK(place.x == x);
		CHECK(place.z == z);
		CHECK(place.offset.isApprox(Eigen::Vector3f(0.2f, 0.7f, -0.2f)));
	}
	CHECK_FALSE(grid.has_tile(4, 0));
	CHECK_FALSE(grid.has_tile(0, -1));
	CHECK(grid.get_place(Eigen::Vector3d(-1.1, 0.0, 0.0)).x == -1);
}

TEST_CASE("tile_grid: a tenth of a micrometre shows in an offset anywhere on the largest field") {
	const TileGrid grid = TileGrid::make(4096.0, 4096.0, 256.0);
	std::mt19937 random(1);
	std::uniform_real_distribution<double> anywhere(-2048.0, 2048.0);
	double worst = 0.0;
	bool all_in_tile = true;
	for (int i = 0; i < 10000; i++) {
		const Eigen::Vector3d point(anywhere(random), 0.3, anywhere(random));
		const TilePlace place = grid.get_place(point);
		worst = std::max(worst, (grid.get_centre(place.x, place.z) + place.offset.cast<double>() - point).norm());
		all_in_tile = all_in_tile && std::abs(place.offset.x()) <= 0.25f && std::abs(place.offset.z()) <= 0.25f;
	}
	CHECK(worst < 1e-7);
	CHECK(all_in_tile);
}

TEST_CASE("tile_grid: a far point has a tile and an offset that lead back to it") {
	const TileGrid grid = TileGrid::make(32.0, 32.0, 256.0);
	for (const double far : { 1e5, -1e7, 1e9 }) {
		const TilePlace place = grid.get_place(Eigen::Vector3d(far, 1.0, -far));
		const Eigen::Vector3d back = grid.get_centre(place.x, place.z) + place.offset.cast<double>();
		CHECK(back.x() == doctest::Approx(far));
		CHECK(back.z() == doctest::Approx(-far));
	}
}

TEST_CASE("tile_grid: the range over a rectangle is every tile whose grown square meets it, and no other") {
	const TileGrid grid = TileGrid::make(8.0, 5.0, 200.0);
	std::mt19937 random(2);
	std::uniform_real_distribution<double> place(-6.0, 6.0), extent(0.0, 3.0), margin_of(0.0, 0.6);
	int differing = 0;
	for (int i = 0; i < 2000; i++) {
		const double x = place(random), z = place(random), width = extent(random), depth = extent(random), margin = margin_of(random);
		const TileRange range = grid.get_range(x, x + width, z, z + depth, margin);
		for (int tile = 0; tile < grid.get_tile_count(); tile++) {
			const int tile_x = grid.get_x(tile), tile_z = grid.get_z(tile);
			const Eigen::Vector3d centre = grid.get_centre(tile_x, tile_z);
			const double half = 0.5 * grid.get_tile_size() + margin;
			const bool meets_x = std::abs(centre.x() - x - 0.5 * width) <= half + 0.5 * width;
			const bool meets_z = std::abs(centre.z() - z - 0.5 * depth) <= half + 0.5 * depth;
			const bool listed = tile_x >= range.x_begin && tile_x < range.x_end && tile_z >= range.z_begin && tile_z < range.z_end;
			differing += (meets_x && meets_z) == listed ? 0 : 1;
		}
	}
	CHECK(differing == 0);
}

TEST_CASE("tile_grid: ranges of nothing, of everything and of nonsense") {
	const TileGrid grid = TileGrid::make(8.0, 8.0, 256.0);
	CHECK(grid.get_range(-INFINITE, INFINITE, -1e300, 1e300, 0.3).count() == grid.get_tile_count());
	CHECK(grid.get_range(5.0, 6.0, 0.0, 1.0, 0.1) == TileRange{});
	CHECK(grid.get_range(1.0, 0.0, 0.0, 1.0, 0.1) == TileRange{});
	CHECK(grid.get_range(NAN_VALUE, 1.0, 0.0, 1.0, 0.1) == TileRange{});
	CHECK(grid.get_range(0.0, 1.0, 0.0, NAN_VALUE, 0.1) == TileRange{});
	CHECK(grid.get_range(0.0, 1.0, 0.0, 1.0, NAN_VALUE) == TileRange{});
	CHECK(grid.get_range(0.1, 0.1, 0.1, 0.1, 0.0).count() == 1);
	CHECK(grid.get_range(0.0, 0.0, 0.1, 0.1, 0.0).count() == 2); // on the border of two
}
