// SPDX-License-Identifier: MIT
// The pool on the CPU: records in, knots out.
#include <doctest/doctest.h>

#include "blade_scene.h"
#include "on_threads.h"
#include "pool_scene.h"

#include <cmath>
#include <cstring>
#include <limits>

using namespace grass;
using namespace grass::test;

TEST_CASE("A tile wakes at rest, exactly where it is drawn at rest") {
	PoolScene scene(3);
	scene.colliders[0].position.y = 100.0f;
	scene.list.clear();
	for (GrassSlot &slot : scene.slots) {
		slot.list.z = 0;
	}
	for (int i = 0; i < 100; i++) {
		scene.step();
	}
	for (int slot = 0; slot < 3; slot++) {
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			const std::vector<Eigen::Vector3f> knots = scene.pool.get_knots(slot, b);
			REQUIRE(knots.size() == GRASS_KNOTS);
			for (int k = 0; k < GRASS_KNOTS; k++) {
				CHECK(knots[size_t(k)] == scene.rest(slot, b, k));
			}
		}
		CHECK(scene.pool.get_energy()[size_t(slot)] == 0.0f);
	}
}

TEST_CASE_TEMPLATE("A ball bends blades, their clamped knots keep every bit, and they rise again", M, Direct, Pbd) {
	PoolScene scene(4, M::METHOD);
	float energy = 0.0f;
	for (int i = 0; i < 40; i++) {
		scene.step();
		energy = std::max(energy, scene.pool.get_energy()[1]);
		for (int slot = 0; slot < 4; slot++) {
			for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
				const std::vector<Eigen::Vector3f> knots = scene.pool.get_knots(slot, b);
				REQUIRE(knots[0] == Eigen::Vector3f::Zero());
				REQUIRE(knots[1] == scene.rest(slot, b, 1));
				for (int k = 2; k < GRASS_KNOTS; k++) {
					const float wanted = (scene.rest(slot, b, k) - scene.rest(slot, b, k - 1)).norm();
					REQUIRE(std::abs((knots[size_t(k)] - knots[size_t(k - 1)]).norm() - wanted) < 1e-3f * wanted);
				}
			}
		}
	}
	CHECK(energy > 0.1f);
	for (int i = 0; i < 240; i++) {
		scene.step();
	}
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		CHECK((scene.pool.get_knots(1, b)[GRASS_KNOTS - 1] - scene.rest(1, b, GRASS_KNOTS - 1)).norm() < 1e-3f);
	}
}

TEST_CASE_TEMPLATE("The order of the tiles does not change a bit", M, Direct, Pbd) {
	PoolScene forwards(8, M::METHOD), backwards(8, M::METHOD);
	for (int i = 0; i < 60; i++) {
		forwards.step();
		backwards.step([](int p_count, const std::function<void(int)> &p_body) {
			for (int j = p_count; j-- > 0;) {
				p_body(j);
			}
		});
	}
	for (int slot = 0; slot < 8; slot++) {
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			CHECK(forwards.pool.get_knots(slot, b) == backwards.pool.get_knots(slot, b));
		}
	}
}

TEST_CASE_TEMPLATE("Many threads step as one does", M, Direct, Pbd) {
	PoolScene one(32, M::METHOD), many(32, M::METHOD);
	for (int i = 0; i < 30; i++) {
		one.step();
		many.step(on_threads);
	}
	CHECK(one.pool.get_simulated_blades() == many.pool.get_simulated_blades());
	for (int slot = 0; slot < 32; slot++) {
		CHECK(one.pool.get_energy()[size_t(slot)] == many.pool.get_energy()[size_t(slot)]);
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			CHECK(one.pool.get_knots(slot, b) == many.pool.get_knots(slot, b));
		}
	}
}

TEST_CASE_TEMPLATE("Settling ends at rest, bit for bit, and a tile that wakes again starts there", M, Direct, Pbd) {
	PoolScene scene(2, M::METHOD);
	for (int i = 0; i < 12; i++) {
		scene.step();
	}
	scene.list.clear();
	for (GrassSlot &slot : scene.slots) {
		slot.list.z = 0;
		slot.list.w |= GRASS_SLOT_SETTLING;
	}
	for (int left = 30; left >= 1; left--) {
		for (GrassSlot &slot : scene.slots) {
			slot.blend.x = 1.0f / float(left);
		}
		scene.step();
	}
	CHECK(scene.pool.get_knots(1, 5)[15] == scene.rest(1, 5, 15));
	scene.step(); // an energy is that of the start of a step
	CHECK(scene.pool.get_energy()[1] == 0.0f);
	scene.slots[1].tile.x = 9; // the slot goes to another tile
	scene.slots[1].list.w = GRASS_SLOT_FRESH;
	scene.step();
	CHECK(scene.pool.get_knots(1, 5)[15] == scene.rest(1, 5, 15));
}

TEST_CASE_TEMPLATE("A step of no time leaves everything where it is, but wakes what is fresh", M, Direct, Pbd) {
	PoolScene scene(2, M::METHOD);
	scene.step(serial_for, 0.0);
	CHECK(scene.pool.get_knots(0, 3)[15] == scene.rest(0, 3, 15));
	for (int i = 0; i < 12; i++) {
		scene.step();
	}
	const std::vector<Eigen::Vector3f> knots = scene.pool.get_knots(0, 3);
	scene.step(serial_for, std::numeric_limits<double>::quiet_NaN());
	CHECK(scene.pool.get_knots(0, 3) == knots);
}

TEST_CASE("Records of slots, blades, list entries and tiles that do not exist are left out") {
	PoolScene scene(2);
	GrassSlot bad = scene.slots[0];
	bad.tile.w = 7;
	scene.slots.push_back(bad);
	bad.tile.w = -1;
	scene.slots.push_back(bad);
	bad = scene.slots[0];
	bad.list.x = GRASS_PATCH_BLADES;
	scene.slots.push_back(bad);
	bad = scene.slots[0];
	bad.list.z = 100;
	scene.slots.push_back(bad);
	bad.list.y = 0xffffffffu;
	scene.slots.push_back(bad);
	bad = scene.slots[0];
	bad.list.w = GRASS_SLOT_RETIRED;
	scene.slots.push_back(bad);
	scene.list[0] = 55; // no such collider
	scene.step();
	CHECK(scene.pool.get_simulated_blades() == 2 * GRASS_BLADES_PER_TILE);
	CHECK(scene.pool.get_knots(0, 0)[15] == scene.rest(0, 0, 15));
	CHECK(scene.pool.get_knots(7, 0).empty());
	CHECK(scene.pool.get_knots(0, 64).empty());
	CHECK(scene.pool.get_knots(-1, 0).empty());
}

TEST_CASE_TEMPLATE("A tile far from the field's middle moves as one near it", M, Direct, Pbd) {
	PoolScene near(1, M::METHOD), far(1, M::METHOD);
	constexpr int MILES = 200000; // tiles, 100 km
	far.slots[0].tile.x = MILES;
	far.colliders[0].anchor.x = MILES;
	for (int i = 0; i < 60; i++) {
		for (PoolScene *scene : { &near, &far }) {
			scene->step();
		}
	}
	// Clumps differ with the place, so compare what the ball did with each blade's own rest pose: that it was bent.
	int bent_near = 0, bent_far = 0;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		bent_near += (near.pool.get_knots(0, b)[15] - near.rest(0, b, 15)).norm() > 0.01f;
		bent_far += (far.pool.get_knots(0, b)[15] - far.rest(0, b, 15)).norm() > 0.01f;
		REQUIRE(far.pool.get_knots(0, b)[15].allFinite());
	}
	CHECK(bent_near > 10);
	CHECK(std::abs(bent_near - bent_far) < 20);
}

TEST_CASE("A stroke over all awake tiles grows each as its own record says, and each record is looked at once") {
	constexpr int SLOTS = 256;
	PoolScene scene(SLOTS);
	for (GrassSlot &slot : scene.slots) {
		slot.list.x = 0;
		slot.list.z = 0;
	}
	std::vector<SlotGrowth> growth;
	const auto grow = [&](int p_first, int p_every) {
		growth.clear();
		for (int slot = p_first; slot < SLOTS; slot += p_every) {
			SlotGrowth grown;
			grown.slot = slot;
			grown.blades.fill({ 0.5f + float(slot) / SLOTS, 0.0f, 0.0f, 0.0f });
			growth.push_back(grown);
		}
		scene.growth = growth;
		const int64_t before = scene.pool.get_growth_looks();
		scene.step();
		return scene.pool.get_growth_looks() - before;
	};
	const auto length_of = [&](int p_slot) { return scene.pool.get_knots(p_slot, 0)[1].norm(); };
	CHECK(grow(0, 1) <= 2 * SLOTS);
	const float unit = length_of(0) / 0.5f;
	for (int slot = 0; slot < SLOTS; slot++) {
		CHECK(length_of(slot) == doctest::Approx(unit * (0.5f + float(slot) / SLOTS)));
	}
	CHECK(grow(1, 2) <= 2 * SLOTS);
	CHECK(grow(SLOTS, 1) <= 2 * SLOTS); // the map did not change
	for (int slot = 0; slot < SLOTS; slot++) {
		CHECK(length_of(slot) == doctest::Approx(unit * (0.5f + float(slot) / SLOTS)));
	}
}
