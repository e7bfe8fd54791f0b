// SPDX-License-Identifier: MIT
#include "core/tiles/tile_bounds.h"

#include "core/base/half.h"
#include "core/base/hash.h"
#include "core/blades/blade.h"
#include "core/tiles/tiles.h"

#include <doctest/doctest.h>

using namespace grass;

namespace {

struct Meadow {
	Patch patch = generate_patch(PatchParams());
	TileGrid grid = TileGrid::make(32.0, 32.0, 256.0);
	ClumpParams clump;
	TileBounds bounds{ patch, grid, clump, 5 };

	Eigen::Vector3d knot(int p_x, int p_z, int p_blade, int p_knot) const {
		const int blade = int(grass_tile_start(uint32_t(p_x), uint32_t(p_z), 5)) + p_blade;
		const auto texel = [&](int p_k) {
			const uint16_t *half = &patch.texels[Patch::texel_index(blade, p_k)];
			return Eigen::Vector3f(half_to_float(half[0]), half_to_float(half[1]), half_to_float(half[2]));
		};
		const Eigen::Vector2f tiles(float(grid.get_tiles_x()), float(grid.get_tiles_z()));
		const Eigen::Vector2f place =
				root_place(Eigen::Vector2f(float(p_x), float(p_z)), texel(0).head<2>(), tiles, float(grid.get_tile_size()));
		const Eigen::Vector3f in_blade = rest_knot(texel(p_knot), p_knot, clump_at(place, clump));
		return Eigen::Vector3d(place.x(), 0.0, place.y()) + in_blade.cast<double>();
	}
};

Bounds point(const Eigen::Vector3d &p_at) {
	return { p_at, p_at };
}

} // namespace

TEST_CASE("tile bounds: hold every knot above the root of every blade of a tile, whatever its clump") {
	const Meadow meadow;
	for (int x = 0; x < meadow.grid.get_tiles_x(); x += 7) {
		for (int z = 0; z < meadow.grid.get_tiles_z(); z += 5) {
			for (int blade = 0; blade < GRASS_BLADES_PER_TILE; blade++) {
				for (int knot = 1; knot < GRASS_KNOTS; knot++) {
					CHECK(meadow.bounds.meets(x, z, point(meadow.knot(x, z, blade, knot))));
				}
			}
		}
	}
}

TEST_CASE("tile bounds: are tighter than the widest overhang on all sides") {
	const Meadow meadow;
	const double side = 0.5 * meadow.grid.get_tile_size() + meadow.bounds.get_overhang();
	int met = 0, all = 0;
	for (int x = 0; x < meadow.grid.get_tiles_x(); x++) {
		for (const Eigen::Vector3d &corner :
				{ Eigen::Vector3d(side, 0.3, 0.0), Eigen::Vector3d(-side, 0.3, 0.0), Eigen::Vector3d(0.0, 0.3, side) }) {
			met += meadow.bounds.meets(x, 9, point(meadow.grid.get_centre(x, 9) + 0.9 * corner)) ? 1 : 0;
			all++;
		}
	}
	CHECK(met * 4 < all);
}

TEST_CASE("tile bounds: nothing is met above the tips, below the ground, or in an empty patch") {
	const Meadow meadow;
	const Eigen::Vector3d centre = meadow.grid.get_centre(3, 3);
	CHECK(meadow.bounds.meets(3, 3, point(centre + Eigen::Vector3d(0.0, 0.1, 0.0))));
	CHECK_FALSE(meadow.bounds.meets(3, 3, point(centre + Eigen::Vector3d(0.0, meadow.bounds.get_height() + 0.01, 0.0))));
	CHECK_FALSE(meadow.bounds.meets(3, 3, point(centre - Eigen::Vector3d(0.0, 0.01, 0.0))));
	for (const double top : { 0.0, 0.9 * TileBounds::LEAST_RISE }) { // a deck that carries the field
		CHECK_FALSE(meadow.bounds.meets(3, 3, { centre - Eigen::Vector3d(9.0, 1.0, 9.0), centre + Eigen::Vector3d(9.0, top, 9.0) }));
	}
	CHECK(meadow.bounds.meets(3, 3, { centre - Eigen::Vector3d(9.0, 1.0, 9.0), centre + Eigen::Vector3d(9.0, 0.002, 9.0) }));
	CHECK_FALSE(TileBounds().meets(0, 0, point(Eigen::Vector3d::Zero())));
}

TEST_CASE("tile bounds: a tile manager that has them wakes fewer tiles, and each one that a blade's box needs") {
	const Meadow meadow;
	ColliderShape ball;
	ball.size = { 0.25, 0.0, 0.0 };
	ball.now.position = ball.before.position = { 0.1, 0.25, 0.1 };
	TileParams params;
	params.overhang = meadow.bounds.get_overhang();
	params.height = meadow.bounds.get_height();
	params.seed = 5;
	int awake[2];
	for (int with = 0; with < 2; with++) {
		TileManager tiles;
		tiles.set_grid(meadow.grid);
		tiles.set_params(params);
		if (with) {
			tiles.set_bounds(std::make_shared<const TileBounds>(meadow.bounds));
		}
		tiles.update(1.0 / 60.0, std::span(&ball, 1));
		awake[with] = tiles.get_statistics().awake;
		for (int x = 0; with && x < meadow.grid.get_tiles_x(); x++) {
			for (int z = 0; z < meadow.grid.get_tiles_z(); z++) {
				CHECK(tiles.is_awake(meadow.grid.get_index(x, z)) == meadow.bounds.meets(x, z, ball.get_swept_bounds()));
			}
		}
	}
	MESSAGE("tiles awake around a ball of 0.5 m: ", awake[0], " by the overhang, ", awake[1], " by the boxes");
	CHECK(awake[1] * 5 < awake[0] * 4);
}
