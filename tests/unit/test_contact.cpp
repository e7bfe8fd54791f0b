// SPDX-License-Identifier: MIT
// Contact: every shape, every speed, every degenerate place, by either method.
#include <doctest/doctest.h>

#include "draw_params.h"
#include "pass_through.h"
#include "sampled.h"

#include <Eigen/Geometry>

using namespace grass;
using namespace grass::test;

namespace {

const Eigen::Vector3f SIZE(0.15f, 0.12f, 0.1f); // metres
const Eigen::Vector3f FORWARD = Eigen::Vector3f::UnitX();

// Returns the lowest height at which the shape stands on the ground.
float standing_height(int p_shape) {
	return p_shape == GRASS_SPHERE ? SIZE.x() : p_shape == GRASS_CAPSULE ? SIZE.x() + SIZE.y() : SIZE.y();
}

} // namespace

TEST_CASE_TEMPLATE(
		"Whatever passes at 0.5 to 1000 m/s, lengths hold to 1e-3 and no knot is deeper than 1e-4 m after the step", M, Direct, Pbd) {
	for (const Step step : sampled<Step>({ step_lanes, step_scalar_double })) {
		for (const int shape : SHAPES) {
			for (const float speed : { 0.5f, 1.0f, 5.0f, 20.0f, 100.0f, 1000.0f }) {
				for (const float lift : sampled({ 0.0f, 0.1f, 0.25f })) {
					if (step != step_lanes && lift > 0.0f) {
						continue;
					}
					CAPTURE(shape);
					CAPTURE(speed);
					CAPTURE(lift);
					BladeScene scene(M::METHOD);
					scene.step_function = step;
					scene.add(shape, Eigen::Vector3f::Zero(), SIZE);
					float stretch = 0.0f, depth = 0.0f;
					pass_through(scene, speed, standing_height(shape) + lift, [&](float) {
						stretch = std::max(stretch, scene.stretch());
						depth = std::max(depth, scene.depth());
					});
					CHECK(stretch < 1e-3f);
					CHECK(depth < 1e-4f);
					scene.colliders.clear();
					scene.step_for(4.0);
					CHECK(scene.distance_from_rest() < 1e-3f);
				}
			}
		}
	}
}

TEST_CASE_TEMPLATE(
		"A 20 m/s and a 1000 m/s shape bends the blades along its way, though it is beyond them after the step", M, Direct, Pbd) {
	for (const int shape : SHAPES) {
		for (const float speed : { 20.0f, 1000.0f }) {
			CAPTURE(shape);
			CAPTURE(speed);
			BladeScene scene(M::METHOD);
			scene.add(shape, Eigen::Vector3f::Zero(), SIZE);
			const float half = 0.5f * speed / 60.0f, height = standing_height(shape) + 0.1f;
			BladeScene::place(scene.colliders[0], { -half - 0.1f, height, 0.02f }, { half + 0.1f, height, 0.02f });
			scene.step();
			CHECK((scene.knot(0, GRASS_KNOTS - 1) - scene.rest(0, GRASS_KNOTS - 1)).dot(FORWARD) > 0.4f * scene.length);
			CHECK(scene.stretch() < 1e-3f);
		}
	}
}

TEST_CASE_TEMPLATE("A teleported shape hits nothing on its way", M, Direct, Pbd) {
	for (const int shape : SHAPES) {
		BladeScene scene(M::METHOD);
		scene.add(shape, { -8.0f, 0.2f, 0.02f }, SIZE);
		scene.step();
		BladeScene::place(scene.colliders[0], { 8.0f, 0.2f, 0.02f }, { 8.0f, 0.2f, 0.02f });
		scene.step();
		CHECK(scene.is_exactly_at_rest());
	}
}

TEST_CASE_TEMPLATE("A shape that appears inside the blades pushes them out without flinging them", M, Direct, Pbd) {
	for (const int shape : SHAPES) {
		CAPTURE(shape);
		BladeScene scene(M::METHOD);
		scene.add(shape, { 0.05f, standing_height(shape) + 0.06f, 0.02f }, SIZE);
		scene.step();
		CHECK(scene.depth() < 1e-4f);
		CHECK(scene.is_finite());
		scene.colliders.clear();
		scene.step_for(3.0);
		CHECK(scene.distance_from_rest() < 0.01f);
	}
}

TEST_CASE_TEMPLATE("Knots at a sphere's centre, on a capsule's and a cylinder's axis, at a box's centre find a way out", M, Direct, Pbd) {
	for (const Step step : ALL_STEPS) {
		for (const int shape : SHAPES) {
			CAPTURE(shape);
			BladeScene scene(M::METHOD), again(M::METHOD);
			for (BladeScene *each : { &scene, &again }) {
				each->step_function = step;
				each->add(shape, each->rest(0, 9), { 0.06f, 0.05f, 0.05f }); // blade 0 stands on the axis
				each->step();
			}
			CHECK(scene.is_finite());
			CHECK(scene.stretch() < 1e-3f);
			CHECK(scene.depth() < 1e-4f);
			CHECK(scene.distance_from(again) == 0.0f);
		}
	}
}

TEST_CASE_TEMPLATE("A pressed blade stays above the ground and below what presses it, and holds still", M, Direct, Pbd) {
	for (const int shape : { GRASS_BOX, GRASS_CYLINDER, GRASS_HULL }) {
		CAPTURE(shape);
		BladeScene scene(M::METHOD);
		if (M::METHOD == Method::PBD) { // holds still if blades are soft, damped and solved often enough only
			scene.params.natural_frequency = 0.9; // Hz
			scene.params.damping_ratio = 0.7;
			scene.params.iterations = 3;
		}
		scene.add(shape, { 0.0f, 0.7f, 0.0f }, { 0.5f, 0.1f, 0.5f });
		float height = 0.7f;
		for (int i = 0; i < 240; i++) { // comes down to 8 cm above the ground in a second and stays
			const float before = height;
			height = std::max(height - 0.01f, 0.18f);
			BladeScene::place(scene.colliders[0], { 0.0f, before, 0.0f }, { 0.0f, height, 0.0f });
			scene.step();
			CHECK(scene.depth() < 1e-4f);
			CHECK(scene.stretch() < 1e-3f);
			CHECK(scene.largest([&](int b, int k) { return -scene.knot(b, k).y(); }) <= 0.0f);
		}
		// Most blades hold still to a millionth; some creep where two surfaces meet.
		BladeScene later(M::METHOD);
		*later.tile = *scene.tile;
		scene.step();
		std::vector<float> moved;
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			moved.push_back((scene.knot(b, GRASS_KNOTS - 1) - later.knot(b, GRASS_KNOTS - 1)).norm() / scene.length);
		}
		std::sort(moved.begin(), moved.end());
		CHECK(moved[GRASS_BLADES_PER_TILE / 2] < 1e-5f);
		CHECK(moved[GRASS_BLADES_PER_TILE * 85 / 100] < 1e-4f);
		CHECK(moved.back() < 2e-2f);
	}
}

TEST_CASE_TEMPLATE("A blade is mashed between two shapes and comes back", M, Direct, Pbd) {
	for (const int shape : SHAPES) {
		for (const Step step : sampled(ALL_STEPS)) {
			CAPTURE(shape);
			BladeScene scene(M::METHOD);
			scene.step_function = step;
			scene.add(shape, { -0.6f, 0.25f, 0.0f }, SIZE);
			scene.add(shape, { 0.6f, 0.25f, 0.02f }, SIZE);
			for (int i = 0; i < 120; i++) { // they meet, overlap, and part
				const float x = 0.6f - 0.01f * float(i < 60 ? i : 120 - i), before = 0.6f - 0.01f * float(i <= 60 ? i - 1 : 121 - i);
				BladeScene::place(scene.colliders[0], { -before, 0.25f, 0.0f }, { -x, 0.25f, 0.0f });
				BladeScene::place(scene.colliders[1], { before, 0.25f, 0.02f }, { x, 0.25f, 0.02f });
				scene.step();
				REQUIRE(scene.is_finite());
				REQUIRE(scene.stretch() < 1e-3f);
			}
			scene.colliders.clear();
			scene.step_for(4.0);
			CHECK(scene.distance_from_rest() < 1e-3f);
		}
	}
}

TEST_CASE_TEMPLATE("Friction drags blades along with a shape that slides over them, and what sticks goes as fast as the shape, not faster",
		M, Direct, Pbd) {
	constexpr float STRIDE = 0.005f; // of the shape in a step, metres
	struct Drag {
		float tips = 0.0f; // mean way of all tips, metres
		float touching = 0.0f; // mean way of the knots at the shape in a step, shares of the shape's
	};
	const auto slide = [&](double p_friction) {
		BladeScene scene(M::METHOD);
		scene.params.friction = p_friction;
		scene.add(GRASS_BOX, { 0.0f, 0.8f, 0.0f }, { 1.0f, 0.1f, 1.0f });
		Eigen::Vector3f before(0.0f, 0.8f, 0.0f), way(0.0f, -0.01f, 0.0f);
		Drag drag;
		int count = 0;
		for (int i = 0; i < 80; i++) { // presses down to 30 cm, then slides along z
			way = i < 40 ? way : Eigen::Vector3f(0.0f, 0.0f, STRIDE);
			BladeScene::place(scene.colliders[0], before, before + way);
			before += way;
			BladeScene earlier;
			*earlier.tile = *scene.tile;
			scene.step();
			for (int b = 0; b < GRASS_BLADES_PER_TILE && i >= 40; b++) {
				drag.tips += (scene.knot(b, GRASS_KNOTS - 1) - earlier.knot(b, GRASS_KNOTS - 1)).z() / GRASS_BLADES_PER_TILE;
				for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
					if (std::min(scene.knot(b, k).y(), earlier.knot(b, k).y()) > 0.2955f) { // in the skin, 4 mm
						drag.touching += (scene.knot(b, k) - earlier.knot(b, k)).z() / STRIDE;
						count++;
					}
				}
			}
		}
		REQUIRE(count > 1000);
		drag.touching /= float(count);
		return drag;
	};
	const Drag free = slide(0.0), held = slide(2.0);
	CHECK(held.tips > free.tips + 0.02f);
	// The knots at the shape, those that spring back ahead of it included; not the tips: a blade pivots about the knot that sticks, and its
	// tip, on the longer lever, goes farther than the shape.
	CHECK(held.touching > free.touching + 0.1f);
	CHECK(held.touching < 1.05f);
}

TEST_CASE_TEMPLATE("A thousand overlapping shapes leave blades finite, in bounded time, and they come back", M, Direct, Pbd) {
	BladeScene scene(M::METHOD);
	std::mt19937 random(11);
	std::uniform_real_distribution<float> place(-0.5f, 0.5f);
	for (int i = 0; i < 1000; i++) {
		scene.add(SHAPES[i % 4], { place(random), 0.3f + place(random), place(random) }, SIZE);
	}
	scene.step();
	CHECK(scene.is_finite());
	CHECK(scene.stretch() < 1e-3f);
	scene.colliders.clear();
	scene.step_for(4.0);
	CHECK(scene.distance_from_rest() < 1e-3f);
}

TEST_CASE_TEMPLATE(
		"Random shapes, speeds, parameters and time steps: finite and as long as ever, and back at rest afterwards", M, Direct, Pbd) {
	std::mt19937 random(2026);
	const auto uniform = [&](double p_low, double p_high) { return std::uniform_real_distribution<double>(p_low, p_high)(random); };
	const auto draw = [&](const Tunable &p_tunable) { return uniform(p_tunable.minimum, p_tunable.maximum); };
	const auto direction = [&] {
		return Eigen::Vector3f(float(uniform(-1.0, 1.0)), float(uniform(-1.0, 1.0)), float(uniform(-1.0, 1.0))).normalized();
	};
	for (int round = 0; round < sampled(9); round++) { // the layer `stress` draws some hundreds
		CAPTURE(round);
		BladeScene scene(M::METHOD);
		scene.step_function = ALL_STEPS[round % 3];
		scene.params = draw_params(M::METHOD, draw);
		scene.params.iterations = 1 + int(uniform(0.0, 9.99));
		for (int i = 0; i < 60; i++) {
			if (i % 7 == 0) {
				scene.colliders.clear();
				for (int j = int(uniform(0.0, 5.0)); j > 0; j--) {
					const Eigen::Vector3f place(float(uniform(-0.5, 0.5)), float(uniform(-0.2, 0.6)), float(uniform(-0.5, 0.5)));
					GrassCollider &collider = scene.add(
							SHAPES[int(uniform(0.0, 4.99))], place, Eigen::Vector3f::Constant(float(std::pow(10.0, uniform(-3.0, 0.3)))));
					const Eigen::Vector3f way = direction() * float(std::pow(10.0, uniform(-3.0, 1.5)));
					BladeScene::place(collider, place - way, place);
					const Eigen::Quaternionf turn(Eigen::AngleAxisf(float(uniform(0.0, 3.0)), direction()));
					const Eigen::Quaternionf turn_before(Eigen::AngleAxisf(float(uniform(0.0, 3.0)), direction()));
					collider.rotation = { turn.x(), turn.y(), turn.z(), turn.w() };
					collider.rotation_before = { turn_before.x(), turn_before.y(), turn_before.z(), turn_before.w() };
				}
			}
			scene.step(uniform(0.0, 1.0) < 0.1 ? uniform(0.0, 1.0) : 1.0 / 60.0);
			REQUIRE(scene.is_finite());
			REQUIRE(scene.stretch() < 1e-3f);
		}
		scene.colliders.clear();
		scene.params = SolverParams();
		scene.params.method = M::METHOD;
		scene.step_for(4.0);
		CHECK(scene.distance_from_rest() < 2e-3f);
	}
}
