// SPDX-License-Identifier: MIT
// The step of a blade without contact: rest, lengths, time, return.
#include <doctest/doctest.h>

#include "blade_scene.h"

using namespace grass;
using namespace grass::test;

// Where a sphere of 15 cm touches no blade of 50 cm, yet is so near that none may be skipped as idle.
static const Eigen::Vector3f NEARBY(0.68f, 0.2f, 0.0f);

TEST_CASE("A blade at rest keeps every bit for 10,000 steps (1,000 in the plain versions)") {
	for (const Step step : ALL_STEPS) {
		BladeScene scene;
		scene.step_function = step;
		scene.add(GRASS_SPHERE, NEARBY, { 0.15f, 0, 0 });
		for (int i = step == step_lanes ? 10000 : 1000; i > 0; i--) {
			scene.step();
		}
		CHECK(scene.is_exactly_at_rest());
		CHECK(scene.energy == 0.0f);
	}
}

TEST_CASE("A blade at rest keeps every bit whatever the parameters and the time step") {
	std::mt19937 random(1);
	const auto draw = [&](const Tunable &p_tunable) {
		return std::uniform_real_distribution<double>(p_tunable.minimum, p_tunable.maximum)(random);
	};
	for (int i = 0; i < 50; i++) {
		BladeScene scene;
		scene.params.natural_frequency = draw(NATURAL_FREQUENCY);
		scene.params.root_stiffness = draw(ROOT_STIFFNESS);
		scene.params.damping_ratio = draw(DAMPING_RATIO);
		scene.params.bend_stiffness = draw(BEND_STIFFNESS);
		scene.params.iterations = int(draw(ITERATIONS));
		scene.add(GRASS_SPHERE, NEARBY, { 0.15f, 0, 0 });
		for (int j = 0; j < 20; j++) {
			scene.step(std::uniform_real_distribution<double>(0.0, 0.2)(random));
		}
		CHECK(scene.is_exactly_at_rest());
	}
}

TEST_CASE("The two-step coefficients follow a damped oscillator exactly, also where the time step changes") {
	for (const double damping : { 0.0, 2.0, 5.0, 12.0 }) {
		for (const bool is_steady : { true, false }) {
			SolverParams params;
			params.damping_ratio = damping / (2.0 * 3.14159265358979 * params.natural_frequency);
			StepClock clock;
			std::mt19937 random(7);
			const double w = 2.0 * 3.14159265358979 * params.natural_frequency;
			const double q = w * w - damping * damping;
			const auto exact = [&](double p_t) { // starts at 1 with a speed of 3
				const double root = std::sqrt(std::abs(q));
				const double c = q > 0.0 ? std::cos(root * p_t) : std::cosh(root * p_t);
				const double s = (q > 0.0 ? std::sin(root * p_t) : std::sinh(root * p_t)) / root;
				return std::exp(-damping * p_t) * (c + (3.0 + damping) * s);
			};
			double time = 0.0, before = 0.0, now = exact(0.0);
			double error = 0.0;
			for (int i = 0; i < 60; i++) {
				const double delta = is_steady ? 1.0 / 60.0 : std::uniform_real_distribution<double>(1.0 / 144.0, 1.0 / 30.0)(random);
				const GrassStep step = clock.advance(params, delta);
				if (i > 0) {
					const double next = now + double(step.motion.x) * (now - before) - double(step.motion.y) * now;
					before = now;
					now = next;
				} else {
					before = now;
					now = exact(delta);
				}
				time += delta;
				error = std::max(error, std::abs(now - exact(time)));
			}
			CHECK(error < 2e-5); // the coefficients are floats
		}
	}
}

TEST_CASE("A bent blade is back at rest within 1 % of its length in 0.5 to 1.5 s, at any frame rate and number of iterations") {
	const auto return_time = [](double p_rate, int p_iterations) {
		BladeScene scene;
		scene.params.iterations = p_iterations;
		scene.bend(1.5f);
		double last = 0.0;
		for (int i = 1; i <= int(3.0 * p_rate); i++) {
			scene.step(1.0 / p_rate);
			if (scene.distance_from_rest() > 0.01f) {
				last = double(i) / p_rate;
			}
		}
		return last;
	};
	const double reference = return_time(480.0, 3);
	CHECK(reference > 0.5);
	CHECK(reference < 1.5);
	for (const double rate : { 30.0, 60.0, 144.0 }) {
		for (const int iterations : { 2, 3, 10 }) {
			CAPTURE(rate);
			CAPTURE(iterations);
			CHECK(return_time(rate, iterations) == doctest::Approx(reference).epsilon(0.05));
		}
	}
}

TEST_CASE("The way back differs by less than 2 % of the length (RMS) between 30, 60, 144 and 720 steps a second, 2, 3 and 10 iterations") {
	constexpr int GRID = 30; // the places in time that all rates share, 1/s
	const auto path = [](int p_rate, int p_iterations) {
		BladeScene scene;
		scene.params.iterations = p_iterations;
		scene.bend(1.5f);
		std::vector<Eigen::Vector3f> places;
		for (int i = 1; i <= 2 * p_rate; i++) {
			scene.step(1.0 / p_rate);
			if (i % (p_rate / (p_rate % GRID == 0 ? GRID : 6)) == 0) {
				places.push_back(scene.knot(40, GRASS_KNOTS - 1));
			}
		}
		return places;
	};
	const auto difference = [](const std::vector<Eigen::Vector3f> &p_a, const std::vector<Eigen::Vector3f> &p_b) {
		float sum = 0.0f;
		const size_t count = std::min(p_a.size(), p_b.size());
		for (size_t i = 1; i <= count; i++) { // by shared times: the shorter list is the coarser one
			sum += (p_a[i * p_a.size() / count - 1] - p_b[i * p_b.size() / count - 1]).squaredNorm();
		}
		return std::sqrt(sum / float(count)) / 0.5f;
	};
	const std::vector<Eigen::Vector3f> reference = path(720, 3);
	for (const int rate : { 30, 60, 144 }) {
		for (const int iterations : { 2, 3, 10 }) {
			CAPTURE(rate);
			CAPTURE(iterations);
			CHECK(difference(path(rate, iterations), reference) < 0.02f);
		}
	}
}

TEST_CASE("A load bends a blade by the same amount within 1 % at 30, 60, 144 Hz and 2, 3, 10 iterations") {
	const auto sag = [](double p_rate, int p_iterations) {
		BladeScene scene;
		scene.params.iterations = p_iterations;
		scene.params.load[0] = 4.0;
		scene.step_for(6.0, p_rate);
		return scene.knot(0, GRASS_KNOTS - 1).x();
	};
	const float reference = sag(480.0, 3);
	CHECK(reference > 0.02f);
	for (const double rate : { 30.0, 60.0, 144.0 }) {
		for (const int iterations : { 2, 3, 10 }) {
			CAPTURE(rate);
			CAPTURE(iterations);
			CHECK(sag(rate, iterations) == doctest::Approx(reference).epsilon(0.01));
		}
	}
}

TEST_CASE("Without contact the energy of a released blade never exceeds what it had") {
	BladeScene scene;
	scene.bend(2.0f);
	scene.step();
	float most = scene.energy * 1.02f;
	for (int i = 0; i < 300; i++) {
		scene.step();
		REQUIRE(scene.energy <= most);
	}
	CHECK(scene.energy < 1e-6f);
}

TEST_CASE("Steps of 0, of no number and of half a second leave blades finite and as long as they were") {
	for (const double delta : { 0.0, -1.0, double(NOT_A_NUMBER), double(INFINITY), 0.5, 1e9, 1e-9 }) {
		for (const Step step : ALL_STEPS) {
			BladeScene scene;
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

TEST_CASE("A half-second frame in the middle of a swing does not make it wilder") {
	BladeScene scene, steady;
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

TEST_CASE("A blade with a number that is not finite goes back to rest, its neighbours do not notice") {
	for (const Step step : ALL_STEPS) {
		BladeScene scene, whole;
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

TEST_CASE("Knots in one place, folded segments and segments without length come apart without a division by zero") {
	for (const Step step : ALL_STEPS) {
		BladeScene scene;
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

TEST_CASE("Settling arrives exactly at rest, step by step nearer") {
	for (const Step step : ALL_STEPS) {
		BladeScene scene;
		scene.step_function = step;
		scene.bend(0.5f);
		float distance = scene.distance_from_rest();
		for (int left = 10; left >= 1; left--) {
			scene.blend = 1.0f / float(left);
			scene.step();
			CHECK(scene.stretch() < 1e-3f);
			CHECK(scene.distance_from_rest() < distance);
			distance = scene.distance_from_rest();
		}
		CHECK(scene.is_exactly_at_rest());
		scene.blend = 0.0f;
		scene.step();
		CHECK(scene.is_exactly_at_rest());
	}
}

TEST_CASE("Eight lanes compute what one float does, bit for bit") {
	BladeScene lanes, scalar;
	scalar.step_function = step_scalar_float;
	for (BladeScene *scene : { &lanes, &scalar }) {
		scene->bend(1.2f);
		scene->add(GRASS_SPHERE, { -0.5f, 0.15f, 0.03f }, { 0.15f, 0, 0 });
		scene->add(GRASS_BOX, { 0.3f, 0.2f, -0.02f }, { 0.1f, 0.1f, 0.1f });
	}
	for (int i = 0; i < 120; i++) {
		for (BladeScene *scene : { &lanes, &scalar }) {
			const float x = -0.5f + 0.02f * float(i);
			BladeScene::place(scene->colliders[0], { x - 0.02f, 0.15f, 0.03f }, { x, 0.15f, 0.03f });
			scene->step();
		}
		REQUIRE(std::memcmp(lanes.tile.get(), scalar.tile.get(), sizeof(TileState)) == 0);
		REQUIRE(lanes.energy == scalar.energy);
	}
}

TEST_CASE("One step in float is within 1e-5 of the length of one in double, 600 without contact within 1e-3") {
	BladeScene single, twice;
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

TEST_CASE("A world scaled by 1/1000 or 1000 moves as the world itself") {
	for (const float scale : { 1e-3f, 1e3f }) {
		BladeScene scene, scaled(0.5f * scale);
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
		CHECK(scene.largest([&](int b, int k) { return (scaled.knot(b, k) / scale - scene.knot(b, k)).norm() / scene.length; }) < 1e-3f);
	}
}
