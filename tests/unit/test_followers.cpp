// SPDX-License-Identifier: MIT
// Drawn blades that are not simulated: they follow those that are.
#include "core/lod/tile_detail.h"
#include "core/tiles/tiles.h"

#include "pool_scene.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace grass;
using namespace grass::test;

namespace {

constexpr int ALL = GRASS_BLADES_PER_TILE, TIP = GRASS_KNOTS - 1;

// Returns a record for the scene's first tile: of its blades, the first p_simulated are simulated, and those up to p_drawn follow.
GrassSlot follower(const PoolScene &p_scene, int p_simulated, int p_drawn, float p_share = 1.0f) {
	GrassSlot record = p_scene.slots[0];
	record.blend = { p_share, float(ALL - p_drawn), float(ALL - p_simulated), float(ALL - p_simulated) };
	return record;
}

// Steps of which the first 16 blades are simulated, and 32 follow them.
void follow(PoolScene &r_scene, int p_steps) {
	for (int i = 0; i < p_steps; i++) {
		r_scene.slots[0].blend.y = float(ALL - 16);
		r_scene.followers = { follower(r_scene, 16, 48) };
		r_scene.step();
	}
}

Eigen::Vector3f tip_of(const PoolScene &p_scene, int p_blade) {
	return p_scene.pool.get_knots(0, p_blade)[TIP];
}

} // namespace

TEST_CASE("followers: the simulated blades move as in a whole tile, bit for bit; the drawn ones have their poses after each step") {
	PoolScene whole(1), thinned(1);
	whole.step();
	thinned.step();
	int bent = 0;
	for (int i = 0; i < 25; i++) {
		whole.step();
		follow(thinned, 1);
		for (int blade = 0; blade < 16; blade++) {
			CHECK(thinned.pool.get_knots(0, blade) == whole.pool.get_knots(0, blade));
		}
		PoolScene joined(1); // the same, with a join after the step
		joined.step();
		for (int k = 0; k <= i; k++) {
			joined.slots[0].blend.y = float(ALL - 16);
			joined.step();
		}
		joined.pool.join(follower(joined, 16, 48));
		for (int blade = 16; blade < ALL; blade++) {
			CHECK((blade >= 48 || thinned.pool.get_knots(0, blade) == joined.pool.get_knots(0, blade)));
			bent += blade < 48 && (tip_of(thinned, blade) - thinned.rest(0, blade, TIP)).norm() > 0.05f;
		}
	}
	CHECK(bent > 50);
}

TEST_CASE("[Eq 50] followers: a blade that was simulated until now gets to its neighbour's pose in small steps, and arrives") {
	const int steps = 16;
	PoolScene gentle(1), sudden(1);
	for (int i = 0; i < 16; i++) { // the ball is among them
		gentle.step();
		sudden.step();
	}
	double most_gentle = 0.0, most_sudden = 0.0, most_whole = 0.0;
	PoolScene whole(1);
	for (int i = 0; i < 16; i++) {
		whole.step();
	}
	for (int i = 0; i < steps; i++) {
		std::vector<Eigen::Vector3f> before;
		for (PoolScene *scene : { &gentle, &sudden, &whole }) {
			for (int blade = 16; blade < 48; blade++) {
				before.push_back(tip_of(*scene, blade));
			}
		}
		gentle.slots[0].blend.y = sudden.slots[0].blend.y = float(ALL - 16);
		gentle.followers = { follower(gentle, 16, 48, 1.0f / float(steps - i)) };
		sudden.followers = { follower(sudden, 16, 48) };
		gentle.step();
		sudden.step();
		whole.step();
		for (int blade = 0; blade < 32; blade++) {
			const auto moved = [&](const PoolScene &p_scene, int p_index) {
				return double((tip_of(p_scene, 16 + blade) - before[size_t(32 * p_index + blade)]).norm());
			};
			most_gentle = std::max(most_gentle, moved(gentle, 0));
			most_sudden = std::max(most_sudden, i == 0 ? moved(sudden, 1) : 0.0);
			most_whole = std::max(most_whole, moved(whole, 2));
		}
	}
	CHECK(most_sudden > 2.0 * most_gentle); // else the test shows nothing
	CHECK(most_gentle < 2.0 * most_whole);
	for (int blade = 16; blade < 48; blade++) {
		CHECK(gentle.pool.get_knots(0, blade) == sudden.pool.get_knots(0, blade));
	}
}

TEST_CASE("followers: beside blades at rest they are at rest, bit for bit") {
	PoolScene scene(1);
	scene.list.clear();
	scene.slots[0].list.z = 0;
	scene.step();
	follow(scene, 5);
	for (int blade = 0; blade < ALL; blade++) {
		CHECK(tip_of(scene, blade) == scene.rest(0, blade, TIP));
	}
}

TEST_CASE("pool row: the first texel says how many blades are simulated") {
	PoolScene scene(1);
	std::vector<uint16_t> row(size_t(GRASS_POOL_BLADES_PER_ROW * GRASS_KNOTS * 4));
	scene.step();
	scene.pool.pack_row(0, row);
	CHECK(half_to_float(row[3]) == 64.0f);
	follow(scene, 1);
	scene.pool.pack_row(0, row);
	CHECK(half_to_float(row[3]) == 16.0f);
	for (int c = 0; c < 3; c++) {
		CHECK(row[size_t(c)] == 0);
	}
}

TEST_CASE("tile detail: the coarser, the fewer blades are simulated; near an eye all that are drawn are") {
	ViewCamera camera;
	camera.planes.fill(Eigen::Vector4f(1.0f, 0.0f, 0.0f, 1000.0f));
	camera.eye = { 0.0f, 1.7f, 0.0f };
	camera.pixel_slope = 0.0014f;
	FieldView view;
	view.cameras = { camera };
	view.is_watched = true;
	for (const float pixels_min : { float(PIXELS_MIN.initial), 0.0f }) {
		view.lod.pixels_min = pixels_min;
		const CullField field{ TileGrid::make(60.0, 60.0, 256.0), 0.25f, 0.5f, { 0.015f, 0.5f }, 7, { 65536, 65536 } };
		TileDetail detail;
		CHECK_FALSE(detail.set_coarseness(2.0f)); // everything is whole
		CHECK(detail.simulated_of(60, 40, 0, ALL) == ALL);
		CHECK(detail.set_coarseness(NAN) == false);
		detail.see(field, view, nullptr);
		std::vector<int> before;
		for (const float coarseness : { 1.0f, 2.0f, 4.0f, 8.0f }) {
			CHECK(detail.set_coarseness(coarseness) == (coarseness > 1.0f));
			CHECK_FALSE(detail.set_coarseness(coarseness * 1.01f));
			int fewer = 0;
			for (int z = 0; z < 60; z++) {
				const int drawn = detail.blades_of(60, z, 0), simulated = detail.simulated_of(60, z, 0, drawn);
				CHECK(simulated <= drawn);
				CHECK(simulated % GRASS_DETAIL_BLADES == 0);
				CHECK(simulated >= GRASS_DETAIL_BLADES);
				CHECK((simulated == drawn || (coarseness > 1.0f && !detail.is_within(60, z, TileDetail::FINE_DISTANCE))));
				if (before.size() < 60) {
					before.push_back(simulated);
				}
				CHECK(simulated <= before[size_t(z)]);
				fewer += simulated < before[size_t(z)];
				before[size_t(z)] = simulated;
			}
			CHECK((fewer > 0 || coarseness != 4.0f));
		}
		const int tile = field.grid.get_index(60, 40);
		CHECK(detail.ask(tile));
		CHECK(detail.simulated_of(60, 40, 8, detail.blades_of(60, 40, 8)) == ALL);
		CHECK(detail.set_coarseness(1.0f));
	}
}
