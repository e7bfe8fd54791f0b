// SPDX-License-Identifier: MIT
// The step of a blade where something is odd: time, numbers, shapes, size, the kind of number itself.
#include <doctest/doctest.h>

#include "blade_scene.h"

#include "core/base/lanes.h"

using namespace grass;
using namespace grass::test;

TEST_CASE_TEMPLATE("Steps of 0, of no number and of half a second leave blades finite and as long as they were", M, Direct, Pbd) {
	for (const double delta : { 0.0, -1.0, double(NOT_A_NUMBER), double(INFINITY), 0.5, 1e9, 1e-9 }) {
		for (const Step step : ALL_STEPS) {
			BladeScene scene(M::METHOD);
			scene.step_function = step;
			scene.bend(2.0f);
			const Eigen::Vector3f tip = scene.knot(3, GRASS_KNOTS - 1);
			for (int i = 0; i < 5; i++) {
				scene.step(delta);
				CHECK(scene.is_finite());
				CHECK(scene.stretch() < 1e-3f);
			}
			if (!(delta > 0.0) || std::isinf(delta)) {
				CHECK(scene.knot(3, GRASS_KNOTS - 1) == tip);
			}
			scene.step_for(3.0);
			CHECK(scene.distance_from_rest() < 1e-3f);
		}
	}
}

TEST_CASE_TEMPLATE("A half-second frame in the middle of a swing does not make it wilder", M, Direct, Pbd) {
	BladeScene scene(M::METHOD), steady(M::METHOD);
	scene.bend(1.5f);
	steady.bend(1.5f);
	for (int i = 0; i < 120; i++) {
		scene.step(i == 12 ? 0.5 : 1.0 / 60.0);
		steady.step();
		CHECK(scene.stretch() < 1e-3f);
		CHECK(scene.distance_from_rest() < 1.5f);
	}
	CHECK(scene.distance_from_rest() < 0.01f);
}

TEST_CASE_TEMPLATE("A blade with a number that is not finite goes back to rest, its neighbours do not notice", M, Direct, Pbd) {
	for (const Step step : ALL_STEPS) {
		BladeScene scene(M::METHOD), whole(M::METHOD);
		scene.step_function = whole.step_function = step;
		scene.bend(1.0f);
		whole.bend(1.0f);
		scene.tile->knots[1][3][10] = NOT_A_NUMBER;
		scene.tile->before[0][5][11] = INFINITY;
		scene.step();
		whole.step();
		CHECK(scene.is_finite());
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			const Eigen::Vector3f tip = scene.knot(b, GRASS_KNOTS - 1);
			CHECK(tip == (b == 10 || b == 11 ? scene.rest(b, GRASS_KNOTS - 1) : whole.knot(b, GRASS_KNOTS - 1)));
		}
	}
}

TEST_CASE_TEMPLATE(
		"Knots in one place, folded segments and segments without length come apart without a division by zero", M, Direct, Pbd) {
	for (const Step step : ALL_STEPS) {
		BladeScene scene(M::METHOD);
		scene.step_function = step;
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			scene.set_knot(0, k, scene.rest(0, 1)); // all knots in one place
			scene.set_knot(1, k, scene.rest(1, k % 2)); // folded back on itself
			scene.set_rest(2, k, scene.rest(2, 1)); // a blade that ends at its clamp
			scene.set_knot(3, k, -scene.rest(3, k)); // upside down
		}
		for (int i = 0; i < 240; i++) {
			scene.step();
			REQUIRE(scene.is_finite());
		}
		for (const int b : { 0, 1, 2, 3 }) {
			CHECK((scene.knot(b, GRASS_KNOTS - 1) - scene.rest(b, GRASS_KNOTS - 1)).norm() < 0.005f);
		}
	}
}

TEST_CASE_TEMPLATE("Four, eight and sixteen lanes compute what one float does, bit for bit", M, Direct, Pbd) {
#if defined(__x86_64__) && defined(GRASS_IS_ONE_FUNCTION)
	CHECK(STEP_LANES_16 != nullptr); // whether or not this machine can run it
#endif
	BladeScene scalar(M::METHOD);
	scalar.step_function = step_scalar_float;
	std::vector<std::unique_ptr<BladeScene>> scenes;
	for (const Step step : get_lane_steps()) {
		scenes.push_back(std::make_unique<BladeScene>(M::METHOD));
		scenes.back()->step_function = step;
	}
	std::vector<BladeScene *> all{ &scalar };
	for (const auto &scene : scenes) {
		all.push_back(scene.get());
	}
	for (BladeScene *scene : all) {
		scene->bend(1.2f);
		scene->add(GRASS_SPHERE, { -0.5f, 0.15f, 0.03f }, { 0.15f, 0, 0 });
		scene->add(GRASS_BOX, { 0.3f, 0.2f, -0.02f }, { 0.1f, 0.1f, 0.1f });
	}
	for (int i = 0; i < 120; i++) {
		for (BladeScene *scene : all) {
			const float x = -0.5f + 0.02f * float(i);
			BladeScene::place(scene->colliders[0], { x - 0.02f, 0.15f, 0.03f }, { x, 0.15f, 0.03f });
			scene->step();
		}
		for (const auto &lanes : scenes) {
			REQUIRE(std::memcmp(lanes->tile.get(), scalar.tile.get(), sizeof(TileState)) == 0);
			REQUIRE(lanes->energy == scalar.energy);
		}
	}
}

TEST_CASE_TEMPLATE("One step in float is within 1e-5 of the length of one in double, 600 without contact within 1e-3", M, Direct, Pbd) {
	BladeScene single(M::METHOD), twice(M::METHOD);
	single.step_function = step_scalar_float;
	twice.step_function = step_scalar_double;
	single.bend(1.5f);
	twice.bend(1.5f);
	single.step();
	twice.step();
	CHECK(single.distance_from(twice) < 1e-5f);
	for (int i = 1; i < 600; i++) {
		single.step();
		twice.step();
		REQUIRE(single.distance_from(twice) < 1e-3f);
	}
}

TEST_CASE_TEMPLATE("A straight blade whose last segments are folded back exactly on it unfolds", M, Direct, Pbd) {
	for (const int folded : { 1, 2, 3, 7 }) {
		BladeScene scene(M::METHOD);
		const int fold = GRASS_KNOTS - 1 - folded; // the knot at which it turns round
		for (int k = 0; k < GRASS_KNOTS; k++) {
			scene.set_rest(0, k, Eigen::Vector3f(0.0f, scene.length * float(knot_share(k)), 0.0f));
		}
		for (int k = fold + 1; k < GRASS_KNOTS; k++) {
			scene.set_knot(0, k, scene.rest(0, 2 * fold - k));
		}
		scene.step_for(4.0);
		CAPTURE(folded);
		CHECK((scene.knot(0, GRASS_KNOTS - 1) - scene.rest(0, GRASS_KNOTS - 1)).norm() < 0.01f * scene.length);
	}
}

TEST_CASE_TEMPLATE("A world scaled by 1/1000 or 1000 moves as the world itself", M, Direct, Pbd) {
	for (const float scale : { 1e-3f, 1e3f }) {
		BladeScene scene(M::METHOD), scaled(0.5f * scale, M::METHOD);
		scene.bend(1.0f);
		scaled.bend(1.0f);
		scene.add(GRASS_SPHERE, Eigen::Vector3f::Zero(), { 0.1f, 0, 0 });
		scaled.add(GRASS_SPHERE, Eigen::Vector3f::Zero(), { 0.1f * scale, 0, 0 });
		for (int i = 0; i < 40; i++) {
			const Eigen::Vector3f before(-0.6f + 0.02f * float(i), 0.4f, 0.03f), now = before + Eigen::Vector3f(0.02f, 0.0f, 0.0f);
			BladeScene::place(scene.colliders[0], before, now);
			BladeScene::place(scaled.colliders[0], before * scale, now * scale);
			scene.step();
			scaled.step();
		}
		CHECK(scene.largest([&](int b, int k) { return (scaled.knot(b, k) / scale - scene.knot(b, k)).norm() / scene.length; }) < 1e-2f);
	}
}

TEST_CASE_TEMPLATE("Knots absurdly far away and absurd loads leave lengths right", M, Direct, Pbd) {
	for (const float far : { 1e4f, 1e15f, 1e29f }) {
		CAPTURE(far);
		BladeScene scene(M::METHOD);
		scene.tile->knots[0][4][7] = far;
		scene.tile->before[1][9][8] = -far;
		scene.step();
		CHECK(scene.is_finite());
		CHECK(scene.stretch() < 1e-3f);
		scene.params.load[0] = double(far) * double(far);
		for (int i = 0; i < 60; i++) {
			scene.step();
			REQUIRE(scene.is_finite());
			REQUIRE(scene.stretch() < 1e-3f);
		}
	}
}
