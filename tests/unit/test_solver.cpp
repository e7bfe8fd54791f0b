// SPDX-License-Identifier: MIT
// The step of a blade without contact: rest, lengths, time, return.
#include <doctest/doctest.h>

#include "blade_scene.h"
#include "draw_params.h"

using namespace grass;
using namespace grass::test;

// Where a sphere of 15 cm touches no blade of 50 cm, yet is so near that none may be skipped as idle.
static const Eigen::Vector3f NEARBY(0.68f, 0.2f, 0.0f);

TEST_CASE_TEMPLATE("A blade at rest keeps every bit for 10,000 steps (1,000 in the plain versions)", M, Direct, Pbd) {
	for (const Step step : ALL_STEPS) {
		BladeScene scene(M::METHOD);
		scene.step_function = step;
		scene.add(GRASS_SPHERE, NEARBY, { 0.15f, 0, 0 });
		for (int i = step == step_lanes ? 10000 : 1000; i > 0; i--) {
			scene.step();
		}
		CHECK(scene.is_exactly_at_rest());
		CHECK(scene.energy == 0.0f);
	}
}

TEST_CASE_TEMPLATE("A blade at rest keeps every bit whatever the parameters and the time step", M, Direct, Pbd) {
	std::mt19937 random(1);
	const auto draw = [&](const Tunable &p_tunable) {
		return std::uniform_real_distribution<double>(p_tunable.minimum, p_tunable.maximum)(random);
	};
	for (int i = 0; i < 50; i++) {
		BladeScene scene(M::METHOD);
		scene.params = draw_params(M::METHOD, draw);
		scene.params.iterations = int(draw(ITERATIONS));
		scene.add(GRASS_SPHERE, NEARBY, { 0.15f, 0, 0 });
		for (int j = 0; j < 20; j++) {
			scene.step(std::uniform_real_distribution<double>(0.0, 0.2)(random));
		}
		CHECK(scene.is_exactly_at_rest());
	}
}

TEST_CASE("METHOD_PBD's two-step coefficients follow a damped oscillator exactly, also where the time step changes") {
	for (const double damping : { 0.0, 2.0, 5.0, 12.0 }) {
		for (const bool is_steady : { true, false }) {
			SolverParams params;
			params.method = Method::PBD;
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
					const double next = now + double(step.pbd_motion.x) * (now - before) - double(step.pbd_motion.y) * now;
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

TEST_CASE_TEMPLATE("A bent blade is back at rest within 1 % of its length in 0.5 to 1.5 s, at any frame rate and number of iterations", M,
		Direct, Pbd) {
	const auto return_time = [](double p_rate, int p_iterations) {
		BladeScene scene(M::METHOD);
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

TEST_CASE_TEMPLATE(
		"The way back differs by less than 2 % of the length (RMS) between 30, 60, 144 and 720 steps a second, 2, 3 and 10 iterations", M,
		Direct, Pbd) {
	constexpr int GRID = 30; // the places in time that all rates share, 1/s
	const auto path = [](int p_rate, int p_iterations) {
		BladeScene scene(M::METHOD);
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

TEST_CASE_TEMPLATE("A load bends a blade by the same amount within 1 % at 30, 60, 144 Hz and 2, 3, 10 iterations", M, Direct, Pbd) {
	const auto sag = [](double p_rate, int p_iterations) {
		BladeScene scene(M::METHOD);
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

// Of METHOD_PBD: the measure that tiles sleep by. METHOD_DIRECT's true energy: test_chain.cpp.
TEST_CASE("METHOD_PBD: without contact the energy of a released blade never exceeds what it had") {
	BladeScene scene(Method::PBD);
	scene.bend(2.0f);
	scene.step();
	float most = scene.energy * 1.02f;
	for (int i = 0; i < 300; i++) {
		scene.step();
		REQUIRE(scene.energy <= most);
	}
	CHECK(scene.energy < 1e-6f);
}

TEST_CASE_TEMPLATE("Settling arrives exactly at rest, step by step nearer", M, Direct, Pbd) {
	for (const Step step : ALL_STEPS) {
		BladeScene scene(M::METHOD);
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
