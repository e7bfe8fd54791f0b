// SPDX-License-Identifier: MIT
// The quick solve of METHOD_DIRECT: as near to the truth as the whole solve that it stands for, and home again.
#include "elastic_blade.h"

#include "core/base/half.h"
#include "core/blades/patch.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

using namespace grass;
using namespace grass::test;

namespace {

constexpr int TIP = GRASS_KNOTS - 1;

// A step by a quick solve, or by a whole one.
void step(ElasticBlade &r_blade, double p_rate, bool p_is_quick) {
	StepTerms<double> terms = make_terms<double>(r_blade.clock.advance(r_blade.params, 1.0 / p_rate), 0.0f, {});
	terms.free_quick = p_is_quick ? 1.0 : 0.0;
	step_blade(r_blade.blade, terms);
}

// Where the tip is, thirty times a second, while a gust comes and goes along p_way (x and z, m/s^2) and for 2 s after it.
std::vector<Eigen::Vector3d> gust_path(const Eigen::Vector2d &p_way, double p_rate, bool p_is_quick, int p_iterations) {
	constexpr double GUST = 0.4; // seconds
	ElasticBlade blade = ElasticBlade::quarter_circle();
	blade.params.iterations = p_iterations;
	std::vector<Eigen::Vector3d> path;
	for (int i = 0; i < int(2.4 * p_rate); i++) {
		const double time = (i + 0.5) / p_rate;
		const double strength = time < GUST ? 1.0 - std::cos(2.0 * std::numbers::pi * time / GUST) : 0.0;
		blade.params.load[0] = p_way.x() * strength;
		blade.params.load[2] = p_way.y() * strength;
		step(blade, p_rate, p_is_quick);
		if ((i + 1) % int(p_rate / 30.0) == 0) {
			path.push_back(blade.place(TIP));
		}
	}
	return path;
}

// Root of the mean square of how far apart two paths are, blade lengths.
double apart_by(const std::vector<Eigen::Vector3d> &p_a, const std::vector<Eigen::Vector3d> &p_b) {
	double sum = 0.0;
	for (size_t i = 0; i < p_a.size(); i++) {
		sum += (p_a[i] - p_b[i]).squaredNorm();
	}
	return std::sqrt(sum / double(p_a.size())) / ElasticBlade::quarter_circle().length();
}

ElasticBlade patch_blade(const Patch &p_patch, int p_blade) {
	return ElasticBlade([&](double p_share) {
		const int knot = int(std::lround(p_share * GRASS_SEGMENTS));
		const uint16_t *halves = &p_patch.texels[Patch::texel_index(p_blade, knot)];
		return knot == 0 ? Eigen::Vector3d(0.0, 0.0, 0.0)
						 : Eigen::Vector3d(half_to_float(halves[0]), half_to_float(halves[1]), half_to_float(halves[2]));
	});
}

} // namespace

TEST_CASE("METHOD_DIRECT: a quick solve is asked for where a step is from 0.04 to 0.2 radians of a swing, below 4 iterations") {
	const auto asks = [](double p_frequency, double p_rate, int p_iterations) {
		SolverParams params;
		params.natural_frequency = p_frequency;
		params.iterations = p_iterations;
		return StepClock().advance(params, 1.0 / p_rate).free_motion.w == 1.0f;
	};
	CHECK(asks(1.2, 60.0, 2));
	CHECK(asks(1.2, 144.0, 3));
	CHECK(!asks(1.2, 240.0, 2)); // so fine a step deserves a whole solve
	CHECK(!asks(1.2, 30.0, 2)); // two stages
	CHECK(!asks(1.2, 60.0, 4));
}

TEST_CASE("METHOD_DIRECT: a gust moves a curved blade by quick solves within a third more of the truth than by whole ones, whichever way "
		  "it blows") {
	for (const Eigen::Vector2d &way :
			{ Eigen::Vector2d(5.0, 0.0), Eigen::Vector2d(0.0, 5.0), Eigen::Vector2d(5.0, 5.0), Eigen::Vector2d(-4.0, 3.0) }) {
		const std::vector<Eigen::Vector3d> truth = gust_path(way, 1920.0, false, 4);
		for (const double rate : { 60.0, 120.0 }) {
			const double quick = apart_by(gust_path(way, rate, true, 2), truth), whole = apart_by(gust_path(way, rate, false, 2), truth);
			INFO("to ", way.x(), ", ", way.y(), ", ", rate, " steps a second: quick ", quick, ", whole ", whole);
			CHECK(quick > 0.0);
			CHECK(quick != whole);
			CHECK(quick < 1.35 * whole + 5e-4);
			CHECK(quick < 0.01);
		}
	}
}

TEST_CASE("METHOD_DIRECT: every kind of blade that a gust has bent comes back to rest by quick solves, and stays there to the bit") {
	const Patch patch = generate_patch(PatchParams());
	int bent = 0;
	for (int b = 0; b < GRASS_PATCH_BLADES; b += 64) {
		for (const double damping : { 0.1, 0.5 }) {
			ElasticBlade blade = patch_blade(patch, b);
			const double length = blade.length(), way = 0.1 * b;
			const ElasticBlade rest = blade;
			blade.params.damping_ratio = damping;
			for (int i = 0; i < 30; i++) {
				const double strength = i < 24 ? 16.0 * length : 0.0; // m/s^2
				blade.params.load[0] = strength * std::cos(way);
				blade.params.load[2] = strength * std::sin(way);
				blade.step(1.0 / 60.0);
			}
			blade.params.load[0] = blade.params.load[2] = 0.0;
			bent += (blade.place(TIP) - rest.place(TIP)).norm() > 0.1 * length;
			blade.step_for(damping < 0.2 ? 15.0 : 6.0, 60.0);
			REQUIRE((blade.place(TIP) - rest.place(TIP)).norm() < 2e-3 * length);
			REQUIRE(blade.stretch() < 1e-5);
		}
	}
	CHECK(bent > 400); // of 512
	ElasticBlade still = patch_blade(patch, 77);
	const Eigen::Vector3d tip = still.place(TIP);
	still.step_for(1.0, 60.0);
	CHECK(still.place(TIP) == tip);
}
