// SPDX-License-Identifier: MIT
// The patch that several species share, and the boxes of its tiles.
#include "species_scene.h"

#include "core/base/half.h"
#include "core/tiles/tile_bounds.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace grass;
using namespace grass::test;

TEST_CASE("patches: joined ones stand one below the other, with the roots of the first") {
	const auto low = make_patch(0.4), high = make_patch(0.8, 7);
	const Patch &joined = *two_patches();
	CHECK(joined.species == 2);
	CHECK(joined.texels.size() == 2 * low->texels.size());
	CHECK(joined.max_length == high->max_length);
	CHECK(joined.max_height == std::max(low->max_height, high->max_height));
	CHECK(joined.mean_height == doctest::Approx(0.5 * (low->mean_height + high->mean_height)));
	int moved = 0;
	for (int b = 0; b < GRASS_PATCH_BLADES; b += 37) {
		const size_t own = Patch::texel_index(b, 0), in = Patch::texel_index(GRASS_PATCH_BLADES + b, 0);
		CHECK(joined.texels[in] == low->texels[own]);
		CHECK(joined.texels[in + 1] == low->texels[own + 1]);
		CHECK(joined.texels[in + 2] == high->texels[own + 2]);
		moved += low->texels[own] != high->texels[own];
		CHECK(joined.texels[in + 3] == high->texels[own + 3]);
		for (int k = 1; k < GRASS_KNOTS; k++) {
			for (size_t c = 0; c < 4; c++) {
				CHECK(joined.texels[Patch::texel_index(GRASS_PATCH_BLADES + b, k) + c] == high->texels[Patch::texel_index(b, k) + c]);
			}
		}
	}
	CHECK(moved > 100);
}

TEST_CASE("patches: a species without blades takes room, but has no width; without any blades there is no patch") {
	const auto bare = make_patch(0.0), grass = make_patch(0.5);
	const std::shared_ptr<const Patch> some[] = { bare, grass }, no[] = { bare, bare };
	const double shares[] = { 0.5, 0.5 };
	const Patch joined = join_patches(some, shares);
	CHECK_FALSE(joined.is_empty());
	CHECK(joined.texels[Patch::texel_index(5, 0) + 3] == 0);
	CHECK(joined.texels[Patch::texel_index(GRASS_PATCH_BLADES + 5, 0) + 3] == grass->texels[Patch::texel_index(5, 0) + 3]);
	CHECK(joined.texels[Patch::texel_index(5, 0)] == grass->texels[Patch::texel_index(5, 0)]);
	CHECK(join_patches(no, shares).is_empty());
	CHECK(join_patches({}, {}).is_empty());
}

TEST_CASE("tile_bounds: a tile's box holds the blades of whichever species they are") {
	const std::shared_ptr<const Patch> patches[] = { make_patch(0.3), make_patch(1.2) };
	const double shares[] = { 0.9, 0.1 };
	const TileBounds small(*patches[0], SPECIES_GRID, ClumpParams(), 0), tall(*patches[1], SPECIES_GRID, ClumpParams(), 0),
			both(join_patches(patches, shares), SPECIES_GRID, ClumpParams(), 0);
	CHECK(both.get_height() == tall.get_height());
	CHECK(both.get_overhang() >= small.get_overhang());
	CHECK(both.get_overhang() == doctest::Approx(tall.get_overhang()).epsilon(0.02));
}

TEST_CASE("patches: the stems of a plant share a root, keep their shape, and point to all sides") {
	const std::shared_ptr<const Patch> patches[] = { make_patch(0.4), make_patch(0.8, 7) };
	const double shares[] = { 0.5, 0.5 };
	const int stems[] = { 1, 4 };
	const Patch joined = join_patches(patches, shares, stems);
	const auto texel_of = [](const Patch &p_patch, int p_blade, int p_knot) {
		const uint16_t *halves = &p_patch.texels[Patch::texel_index(p_blade, p_knot)];
		return Eigen::Vector3f(half_to_float(halves[0]), half_to_float(halves[1]), half_to_float(halves[2]));
	};
	for (int first = 0; first < GRASS_PATCH_BLADES; first += 404) {
		const Eigen::Vector3f root = texel_of(joined, GRASS_PATCH_BLADES + first, 0);
		CHECK(root.head<2>() == texel_of(*patches[0], first / 4, 0).head<2>());
		for (int stem = 0; stem < 4; stem++) {
			const int blade = GRASS_PATCH_BLADES + first + stem;
			const Eigen::Vector3f own = texel_of(joined, blade, 0);
			CHECK(own.head<2>() == root.head<2>());
			const double turned = std::remainder(double(own.z() - root.z()) - stem * EIGEN_PI / 2.0, 2.0 * EIGEN_PI);
			CHECK(std::abs(turned) < 4e-3); // 16-bit floats
			for (int k = 1; k < GRASS_KNOTS; k++) {
				const Eigen::Vector3f now = texel_of(joined, blade, k), before = texel_of(*patches[1], first + stem, k);
				CHECK(now.y() == before.y());
				CHECK(now.norm() == doctest::Approx(before.norm()).epsilon(1e-3));
			}
			CHECK(texel_of(joined, first + stem, 5) == texel_of(*patches[0], first + stem, 5)); // of the other species
		}
	}
}
