// SPDX-License-Identifier: MIT
// Tiles that nothing is near: their blades move by their strains, and as chains again.
#include "moving_scenes.h"
#include "pool_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace grass;
using namespace grass::test;

namespace {

constexpr int TIP = GRASS_KNOTS - 1, TILES = 4;
constexpr size_t BLADES = size_t(TILES * GRASS_BLADES_PER_TILE);

// Moves the blades of all tiles by their strains from now on, or as chains.
void leave_alone(PoolScene &r_scene, bool p_is_alone) {
	for (GrassSlot &slot : r_scene.slots) {
		slot.list.w = (slot.list.w & ~uint32_t(GRASS_SLOT_ALONE)) | (p_is_alone ? GRASS_SLOT_ALONE : 0);
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

// Returns how far each blade's tip is from where it is in the other scene, metres, in ascending order.
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

// Steps after which TileManager leaves the default species' tiles alone.
constexpr int WAIT = 37;

TEST_CASE("[Eq Q11] alone: blades swing on as chains do, and every knot is in its place") {
	PoolScene chains(TILES), alone(TILES);
	roll_over(chains, WAIT);
	roll_over(alone, WAIT);
	const int64_t before = alone.pool.get_strain_blades();
	leave_alone(alone, true);
	float swing = 0.0f;
	for (int i = 0; i < 90; i++) {
		chains.step();
		alone.step();
		swing = std::max(swing, of_blades([&](int p_tile, int p_blade) { return offset_of(chains, p_tile, p_blade).norm(); }).back());
		const std::vector<float> apart = tips_apart(chains, alone);
		INFO("step ", i, ": ", apart[BLADES * 99 / 100], ", ", apart.back(), " of ", swing);
		CHECK(apart[BLADES * 99 / 100] < 0.004f);
		CHECK(apart.back() < 0.01f);
		CHECK(most_stretch(alone) < 1e-3f);
	}
	CHECK(swing > 0.015f);
	CHECK(alone.pool.get_strain_blades() - before == 90 * int64_t(BLADES));
}

TEST_CASE("[Eq Q11] alone: nothing moves by more than a millimetre as the description changes, there and back") {
	PoolScene chains(TILES), alone(TILES);
	roll_over(chains, WAIT);
	roll_over(alone, WAIT);
	int changes = 0;
	float most = 0.0f;
	for (int i = 0; i < 60; i++) {
		if (i % 5 == 0) {
			leave_alone(alone, i % 10 == 0);
			changes++;
		}
		chains.step();
		alone.step();
		most = std::max(most, i == 0 ? tips_apart(chains, alone).back() : 0.0f);
		CHECK(tips_apart(chains, alone)[BLADES * 99 / 100] < 0.004f);
		CHECK(tips_apart(chains, alone).back() < 0.01f);
	}
	INFO("as the first change was made ", most);
	CHECK(most < 0.001f);
	CHECK(most > 0.0f);
	CHECK(changes == 12);
}

TEST_CASE("[Eq Q11] alone: a blade at rest stays there bit for bit, and others come to rest") {
	PoolScene scene(TILES), untouched(TILES);
	untouched.colliders[0].size.x = 1e-3f;
	untouched.colliders[0].position.y = 50.0f;
	untouched.step();
	for (GrassSlot &slot : untouched.slots) {
		slot.list.z = 0;
	}
	leave_alone(untouched, true);
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
	leave_alone(scene, true);
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

TEST_CASE("alone: beside a body, in a fresh tile and by METHOD_PBD blades are chains, bit for bit") {
	for (const Method method : { Method::DIRECT, Method::PBD }) {
		PoolScene plain(TILES, method), marked(TILES, method);
		leave_alone(marked, true);
		for (int i = 0; i < 20; i++) {
			plain.step();
			marked.step();
		}
		CHECK(are_same(plain, marked));
		for (PoolScene *scene : { &plain, &marked }) {
			for (GrassSlot &slot : scene->slots) {
				slot.list.z = 0;
			}
			scene->step();
		}
		CHECK(are_same(plain, marked) == (method == Method::PBD));
	}
}

TEST_CASE("[Eq Q10] alone: the energy by which a tile sleeps is about that of chains") {
	PoolScene chains(TILES), alone(TILES);
	roll_over(chains, WAIT);
	roll_over(alone, WAIT);
	leave_alone(alone, true);
	alone.step();
	chains.step();
	for (int i = 0; i < 60; i++) {
		chains.step();
		alone.step();
		for (size_t tile = 0; tile < TILES; tile++) {
			INFO("step ", i, ", tile ", tile);
			CHECK(alone.pool.get_energy()[tile] == doctest::Approx(chains.pool.get_energy()[tile]).epsilon(0.5));
		}
	}
}

TEST_CASE("[Eq 17] alone: no knot sinks into the ground, and blades that were pressed on it rise again") {
	PoolScene scene(TILES);
	roll_over(scene, WAIT);
	leave_alone(scene, true);
	float lowest = 1.0f;
	for (int i = 0; i < 400; i++) {
		scene.params.load[1] = i < 60 ? -60.0 : 0.0; // m/s^2
		scene.params.load[0] = i < 60 ? 30.0 : 0.0;
		scene.step();
		lowest = std::min(lowest, of_blades([&](int p_tile, int p_blade) {
			float low = 1.0f;
			for (const Eigen::Vector3f &knot : scene.pool.get_knots(p_tile, p_blade)) {
				low = std::min(low, knot.y());
			}
			return low;
		}).front());
	}
	CHECK(lowest > -1e-5f);
	CHECK(most_stretch(scene) < 1e-3f);
	CHECK(of_blades([&](int p_tile, int p_blade) { return offset_of(scene, p_tile, p_blade).norm(); }).back() < 0.005f);
}

TEST_CASE("[Eq 49] alone: blades that join a tile of blades by their strains have their pose, and go on with them") {
	PoolScene scene(TILES);
	roll_over(scene, WAIT);
	leave_alone(scene, true);
	scene.step();
	for (GrassSlot &slot : scene.slots) {
		slot.blend.y = 32.0f; // the last 32 are not simulated
	}
	for (int i = 0; i < 10; i++) {
		scene.step();
	}
	for (GrassSlot &slot : scene.slots) {
		GrassSlot joining = slot;
		joining.blend = { 1.0f, 0.0f, 32.0f, 32.0f };
		scene.pool.join(joining);
		slot.blend.y = 0.0f;
	}
	const std::vector<float> joined = of_blades([&](int p_tile, int p_blade) { return offset_of(scene, p_tile, p_blade).norm(); });
	std::vector<Eigen::Vector3f> before;
	for (int b = 32; b < 64; b++) {
		before.push_back(offset_of(scene, 0, b));
	}
	scene.step();
	for (int b = 32; b < 64; b++) {
		CHECK((offset_of(scene, 0, b) - before[size_t(b - 32)]).norm() < 0.02f);
	}
	CHECK(joined.back() > 0.01f);
}

TEST_CASE("[Eq Q11] alone: in five scenes no blade jumps as its tile changes to strains") {
	for (int scene = 0; scene < int(SCENE_NAMES.size()); scene++) {
		check_scene(scene, 1, 200);
	}
}

TEST_CASE("[Eq Q11] alone: a breeze moves blades by their strains from the second step on, a storm moves chains") {
	for (const double speed : { 10.0, 60.0 }) {
		PooledField field(scene_setup(false));
		Force wind;
		wind.kind = ForceKind::WIND;
		wind.place = { 0.0, 0.3, 0.0 };
		wind.speed = speed;
		wind.radius = 3.0;
		wind.duration = 0.0;
		int woken = 0, alone = 0, chains = 0;
		for (int tick = 0; tick < 40; tick++) {
			wind.age = 1.0 + tick * SCENE_TICK; // it blows with all of its strength
			field.tick(player_view({ 0.0f, 1.7f, 14.0f }), { wind.make_shape(0) }, { { wind } });
			for (const GrassSlot &slot : field.records) {
				const bool is_fresh = slot.list.w & GRASS_SLOT_FRESH, is_alone = slot.list.w & GRASS_SLOT_ALONE;
				woken += is_fresh ? 1 : 0;
				alone += !is_fresh && is_alone ? 1 : 0;
				chains += !is_fresh && !is_alone ? 1 : 0;
			}
		}
		CAPTURE(speed);
		CHECK(woken > 20);
		CHECK((alone > 0) == (speed < 20.0));
		CHECK((chains > 0) == (speed > 20.0));
	}
}
