// SPDX-License-Identifier: MIT
// The pool's memory and its texture.
#include "pool_scene.h"

#include <doctest/doctest.h>

using namespace grass;
using namespace grass::test;

TEST_CASE("A row of the pool texture holds how far the knots are from rest, as halves") {
	PoolScene scene(2);
	for (int i = 0; i < 12; i++) {
		scene.step();
	}
	std::vector<uint16_t> row(GRASS_POOL_BLADES_PER_ROW * GRASS_KNOTS * 4, 7);
	scene.pool.pack_row(1, row);
	PoolScene untouched(2);
	untouched.colliders.clear();
	for (GrassSlot &slot : untouched.slots) {
		slot.list.z = 0;
	}
	untouched.step();
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const std::vector<Eigen::Vector3f> knots = scene.pool.get_knots(1, b);
		for (int k = 1; k < GRASS_KNOTS; k++) {
			const uint16_t *texel = &row[size_t((GRASS_POOL_BLADES_PER_ROW * k + b) * 4)];
			for (int c = 0; c < 3; c++) {
				CHECK(texel[c] == float_to_half(knots[size_t(k)][c] - untouched.pool.get_knots(1, b)[size_t(k)][c]));
			}
		}
	}
	scene.pool.pack_row(5, row);
	CHECK(row[100] == 0);
}

TEST_CASE("Memory comes with the slots that are used") {
	PoolScene scene(64);
	const int64_t empty = scene.pool.get_memory_usage();
	CHECK(empty < 4096);
	scene.slots.resize(2);
	scene.step();
	const int64_t two = scene.pool.get_memory_usage();
	scene.step();
	CHECK(scene.pool.get_memory_usage() == two);
	CHECK((two - empty) / 2 > 3 * (GRASS_KNOTS + 2 * GRASS_FREE_KNOTS) * GRASS_BLADES_PER_TILE * 4 - 1);
	CHECK((two - empty) / 2 < 44000);
}

TEST_CASE("Memory of slots that are given back comes again, fresh, and the others keep their blades") {
	PoolScene scene(64), other(64);
	scene.slots.resize(2);
	scene.step();
	const int64_t one_and_two = scene.pool.get_memory_usage();
	const std::vector<Eigen::Vector3f> first = scene.pool.get_knots(scene.slots[0].tile.w, 5);
	scene.pool.resize(scene.slots[1].tile.w, {});
	CHECK(scene.pool.get_memory_usage() < one_and_two);
	CHECK(scene.pool.get_knots(scene.slots[1].tile.w, 5).empty());
	CHECK(scene.pool.get_knots(scene.slots[0].tile.w, 5) == first);
	scene.pool.resize(64, {});
	CHECK(scene.pool.get_energy()[size_t(scene.slots[1].tile.w)] == 0.0f);
	CHECK(scene.pool.get_knots(scene.slots[0].tile.w, 5) == first);
	scene.slots[1].list.w |= GRASS_SLOT_FRESH;
	scene.time = 0; // under the same ball
	scene.step();
	other.slots.resize(2);
	other.step();
	CHECK(scene.pool.get_memory_usage() == one_and_two);
	CHECK(scene.pool.get_knots(scene.slots[1].tile.w, 5) == other.pool.get_knots(other.slots[1].tile.w, 5));
	scene.pool.resize(0, {});
	CHECK(scene.pool.get_memory_usage() == 0);
}
