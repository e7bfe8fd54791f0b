// SPDX-License-Identifier: MIT
// Tussocks: where the roots of a tile's blades are with them and without.
#include "species_scene.h"

#include "core/base/half.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace grass;
using namespace grass::test;

namespace {

Eigen::Vector2f texel_of(const Patch &p_patch, int p_blade, int p_knot, size_t p_second) {
	const uint16_t *halves = &p_patch.texels[Patch::texel_index(p_blade, p_knot)];
	return { half_to_float(halves[0]), half_to_float(halves[p_second]) };
}

Eigen::Vector2f root_of(const Patch &p_patch, int p_blade) {
	return texel_of(p_patch, p_blade, 0, 1);
}

Patch join_with(const Tussocks &p_tussocks, int p_stems = 1) {
	const std::shared_ptr<const Patch> patches[] = { make_patch(0.4), make_patch(0.8, 7) };
	const double shares[] = { 0.5, 0.5 };
	const int stems[] = { 1, p_stems };
	const Tussocks tussocks[] = { Tussocks(), p_tussocks };
	return join_patches(patches, shares, stems, tussocks);
}

// Mean distance from a blade of the second species to the nearest one of its tile, as a share of the tile, over some tiles.
double mean_distance(const Patch &p_patch) {
	double sum = 0.0;
	int count = 0;
	for (int first = GRASS_PATCH_BLADES; first < 2 * GRASS_PATCH_BLADES - GRASS_BLADES_PER_TILE; first += 1000) {
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			float nearest = 1.0f;
			for (int other = 0; other < GRASS_BLADES_PER_TILE; other++) {
				const float apart = (root_of(p_patch, first + b) - root_of(p_patch, first + other)).norm();
				nearest = other != b ? std::min(nearest, apart) : nearest;
			}
			sum += nearest;
			count++;
		}
	}
	return sum / count;
}

} // namespace

TEST_CASE("tussocks: blades gather, within their tile, and the others stay") {
	const Patch even = join_with({}), some = join_with({ 0.5, 16 }), all = join_with({ 1.0, 16 });
	int moved = 0;
	for (int blade = 0; blade < GRASS_PATCH_BLADES; blade++) {
		CHECK(root_of(all, blade) == root_of(even, blade)); // the first species has none
		const Eigen::Vector2f root = root_of(all, GRASS_PATCH_BLADES + blade);
		CHECK(root.minCoeff() >= 0.0f);
		CHECK(root.maxCoeff() <= 1.0f);
		moved += root_of(some, GRASS_PATCH_BLADES + blade) != root_of(even, GRASS_PATCH_BLADES + blade);
	}
	CHECK(std::abs(moved - GRASS_PATCH_BLADES / 2) < GRASS_PATCH_BLADES / 50);
	CHECK(mean_distance(all) < 0.6 * mean_distance(even));
	CHECK(mean_distance(some) < 0.9 * mean_distance(even));
}

TEST_CASE("tussocks: more blades in each make fewer of them, with more room between") {
	// The share of a tile's cells of an eighth of its side in which a root is.
	const auto share_grown = [](const Patch &p_patch) {
		int grown = 0, cells = 0;
		for (int first = GRASS_PATCH_BLADES; first < 2 * GRASS_PATCH_BLADES - GRASS_BLADES_PER_TILE; first += 512) {
			bool has_root[64]{};
			for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
				const Eigen::Vector2f root = root_of(p_patch, first + b);
				has_root[std::min(int(root.x() * 8.0f), 7) + 8 * std::min(int(root.y() * 8.0f), 7)] = true;
			}
			grown += int(std::ranges::count(has_root, true));
			cells += 64;
		}
		return double(grown) / cells;
	};
	const double even = share_grown(join_with({})), few = share_grown(join_with({ 1.0, 8 })), many = share_grown(join_with({ 1.0, 32 }));
	CHECK(few < 0.75 * even);
	CHECK(many < 0.85 * few);
}

TEST_CASE("tussocks: blades hang outwards, and stems of a plant have none") {
	const Patch all = join_with({ 1.0, 64 }); // one in a tile
	int outwards = 0, count = 0;
	for (int first = GRASS_PATCH_BLADES; first < 2 * GRASS_PATCH_BLADES; first += GRASS_BLADES_PER_TILE) {
		Eigen::Vector2f middle = Eigen::Vector2f::Zero();
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			middle += root_of(all, first + b) / float(GRASS_BLADES_PER_TILE);
		}
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			outwards += (root_of(all, first + b) - middle).dot(texel_of(all, first + b, GRASS_KNOTS - 1, 2)) > 0.0f;
			count++;
		}
	}
	CHECK(outwards > 0.7 * count);
	CHECK(join_with({ 1.0, 16 }, 4).texels == join_with({}, 4).texels);
}
