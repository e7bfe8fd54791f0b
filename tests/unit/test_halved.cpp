// SPDX-License-Identifier: MIT
// [Eq 51] Halved chains: every second joint of a blade that is drawn with few segments.
#include "core/lod/tile_detail.h"

#include "halved_scenes.h"
#include "pool_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace grass;
using namespace grass::test;

namespace {

constexpr int TIP = GRASS_KNOTS - 1, TILES = 4;
constexpr size_t BLADES = size_t(TILES * GRASS_BLADES_PER_TILE);

// Halves the chains of all tiles from now on, or makes them whole again.
void halve(PoolScene &r_scene, bool p_is_halved) {
	for (GrassSlot &slot : r_scene.slots) {
		slot.list.w = (slot.list.w & ~uint32_t(GRASS_SLOT_HALVED)) | (p_is_halved ? GRASS_SLOT_HALVED : 0);
	}
}

// The ball rolls over the tiles and is gone; then blades swing freely for p_calm steps.
void roll_over(PoolScene &r_scene, int p_calm) {
	for (int i = 0; i < 60 + p_calm; i++) {
		for (GrassSlot &slot : r_scene.slots) {
			slot.list.z = i < 60 ? 1 : 0;
		}
		r_scene.step();
	}
}

template <class Value> std::vector<float> of_blades(const Value &p_value) {
	std::vector<float> values;
	for (size_t i = 0; i < BLADES; i++) {
		values.push_back(p_value(int(i) / GRASS_BLADES_PER_TILE, int(i) % GRASS_BLADES_PER_TILE));
	}
	std::ranges::sort(values);
	return values;
}

Eigen::Vector3f offset_of(const PoolScene &p_scene, int p_tile, int p_blade, int p_knot = TIP) {
	return p_scene.pool.get_knots(p_tile, p_blade)[size_t(p_knot)] - p_scene.rest(p_tile, p_blade, p_knot);
}

// How far each blade's tip is from where it is in the other scene, metres, in ascending order.
std::vector<float> tips_apart(const PoolScene &p_a, const PoolScene &p_b) {
	return of_blades([&](int p_tile, int p_blade) { return (offset_of(p_a, p_tile, p_blade) - offset_of(p_b, p_tile, p_blade)).norm(); });
}

// Returns the largest error of a segment's length, as a share of it.
float most_stretch(const PoolScene &p_scene) {
	return of_blades([&](int p_tile, int p_blade) {
		const std::vector<Eigen::Vector3f> knots = p_scene.pool.get_knots(p_tile, p_blade);
		float most = 0.0f;
		for (int k = 1; k < GRASS_KNOTS; k++) {
			const float rest = (p_scene.rest(p_tile, p_blade, k) - p_scene.rest(p_tile, p_blade, k - 1)).norm();
			most = std::max(most, std::abs((knots[size_t(k)] - knots[size_t(k - 1)]).norm() / rest - 1.0f));
		}
		return most;
	}).back();
}

bool are_same(const PoolScene &p_a, const PoolScene &p_b) {
	return of_blades([&](int p_tile, int p_blade) {
		return p_a.pool.get_knots(p_tile, p_blade) == p_b.pool.get_knots(p_tile, p_blade) ? 0.0f : 1.0f;
	}).back() == 0.0f;
}

} // namespace

TEST_CASE("[Eq 51] halved chains: blades swing as whole chains do, with half the knots, and every knot is in its place") {
	PoolScene whole(TILES), halved(TILES);
	roll_over(whole, 2);
	roll_over(halved, 2);
	const int64_t before = halved.pool.get_simulated_knots();
	halve(halved, true);
	float swing = 0.0f;
	for (int i = 0; i < 90; i++) {
		whole.step();
		halved.step();
		swing = std::max(swing, of_blades([&](int p_tile, int p_blade) { return offset_of(whole, p_tile, p_blade).norm(); }).back());
		const std::vector<float> apart = tips_apart(whole, halved);
		CHECK(apart[BLADES * 99 / 100] < 0.004f); // half a pixel is 5 mm where blades begin to have three segments, and more beyond
		CHECK(apart.back() < 0.02f);
		CHECK(most_stretch(halved) < 1e-3f);
	}
	CHECK(swing > 0.15f);
	CHECK(halved.pool.get_simulated_knots() - before == 90 * int64_t(BLADES) * (GRASS_HALVED_KNOTS - GRASS_CLAMPED_KNOTS));
}

TEST_CASE("[Eq 51] halved chains: nothing jumps when the whole chain goes on, or when it is halved") {
	PoolScene whole(TILES), halved(TILES);
	roll_over(whole, 6);
	roll_over(halved, 6);
	int changes = 0;
	for (int i = 0; i < 60; i++) {
		if (i % 5 == 0) {
			halve(halved, i % 10 == 0);
			changes++;
		}
		whole.step();
		halved.step();
		CHECK(tips_apart(whole, halved)[BLADES * 99 / 100] < 0.005f);
		CHECK(tips_apart(whole, halved).back() < 0.02f);
	}
	CHECK(changes == 12);
}

TEST_CASE("[Eq 51] halved chains: a blade at rest stays there bit for bit, and others come to rest") {
	PoolScene scene(TILES), untouched(TILES);
	untouched.colliders[0].size.x = 1e-3f;
	untouched.colliders[0].position.y = 50.0f;
	untouched.step();
	for (GrassSlot &slot : untouched.slots) {
		slot.list.z = 0;
	}
	halve(untouched, true);
	for (int i = 0; i < 10; i++) {
		untouched.step();
	}
	CHECK(of_blades([&](int p_tile, int p_blade) {
		float most = 0.0f;
		for (int k = 0; k < GRASS_KNOTS; k++) {
			most = std::max(most, offset_of(untouched, p_tile, p_blade, k).norm());
		}
		return most;
	}).back() == 0.0f);
	roll_over(scene, 0);
	halve(scene, true);
	for (int i = 0; i < 400; i++) {
		scene.step();
	}
	CHECK(*std::ranges::max_element(scene.pool.get_energy()) < scene.params.energy_within(0.001));
	for (GrassSlot &slot : scene.slots) { // settled in one step
		slot.list.w |= GRASS_SLOT_SETTLING;
		slot.blend.x = 1.0f;
	}
	scene.step();
	CHECK(of_blades([&](int p_tile, int p_blade) { return offset_of(scene, p_tile, p_blade, 8).norm(); }).back() == 0.0f);
}

TEST_CASE("[Eq 51] halved chains: beside a body, in a fresh tile and by METHOD_PBD the chain is whole, bit for bit") {
	for (const Method method : { Method::DIRECT, Method::PBD }) {
		PoolScene whole(TILES, method), marked(TILES, method);
		halve(marked, true);
		for (int i = 0; i < 20; i++) {
			whole.step();
			marked.step();
		}
		CHECK(are_same(whole, marked));
		for (PoolScene *scene : { &whole, &marked }) {
			for (GrassSlot &slot : scene->slots) {
				slot.list.z = 0;
			}
			scene->step();
		}
		CHECK(are_same(whole, marked) == (method == Method::PBD));
	}
}

TEST_CASE("[Eq 51] halved chains: the energy by which a tile sleeps is about the same") {
	PoolScene whole(TILES), halved(TILES);
	roll_over(whole, 6);
	roll_over(halved, 6);
	halve(halved, true);
	for (int i = 0; i < 60; i++) {
		whole.step();
		halved.step();
		for (size_t tile = 0; tile < TILES; tile++) {
			CHECK(halved.pool.get_energy()[tile] == doctest::Approx(whole.pool.get_energy()[tile]).epsilon(0.35));
		}
	}
}

TEST_CASE("tile detail: chains are halved where at most three segments are drawn, later than they are made whole") {
	CullField field{ TileGrid::make(60.0, 60.0, 256.0), 0.25f, 0.5f, { 0.015f, 0.5f }, 7, { 65536, 65536 } };
	FieldView view = player_view({ 0.0f, 1.7f, 0.0f });
	TileDetail detail;
	CHECK_FALSE(detail.is_halved(60, 0, false)); // nobody has looked yet
	detail.see(field, view, nullptr);
	int halved = 0, kept = 0;
	for (int z = 60; z < 120; z++) {
		const Eigen::Vector3f middle = field.grid.get_centre(60, z).cast<float>() + Eigen::Vector3f(0.0f, 0.25f, 0.0f);
		const float distance = (middle - view.cameras[0].eye).norm();
		const float needed = grass_lod_needed(field.size.length, view.lod.error * view.cameras[0].pixel_at(distance));
		CHECK((grass_lod_segments(needed) <= 3 || !detail.is_halved(60, z, true)));
		CHECK((detail.is_halved(60, z, true) || !detail.is_halved(60, z, false)));
		halved += detail.is_halved(60, z, false);
		kept += detail.is_halved(60, z, true) && !detail.is_halved(60, z, false);
	}
	CHECK(halved > 30);
	CHECK(kept > 1);
	CHECK_FALSE(detail.is_halved(60, 62, true));
	detail.ask(field.grid.get_index(60, 110));
	CHECK_FALSE(detail.is_halved(60, 110, true));
	view.lod.error = 0.0f; // always 15 segments
	detail.see(field, view, nullptr);
	CHECK_FALSE(detail.is_halved(60, 119, true));
}
