// SPDX-License-Identifier: MIT
// METHOD_DIRECT under what bends a rod at its end, and in space: an end moment, a tip load, a load in any direction.
#include <doctest/doctest.h>

#include "elastic_blade.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

using namespace grass;
using namespace grass::test;

namespace {

constexpr int TIP = GRASS_KNOTS - 1;
constexpr int ROUNDS = 1000; // of the solve, until nothing moves any more

using Forces = std::array<Eigen::Vector3d, GRASS_KNOTS>; // of knots, per mass of a segment: m/s^2

// EI / (density area length^4) of a blade at its default frequency, 1/s^2.
double bending_of(const SolverParams &p_params) {
	constexpr double FIRST_MODE = 3.5160152685;
	const double share = 2.0 * std::numbers::pi * p_params.natural_frequency / FIRST_MODE;
	return share * share;
}
// EI over the mass of a segment, m^3/s^2.
double stiffness_of(const ElasticBlade &p_blade) {
	return bending_of(p_blade.params) * std::pow(p_blade.length(), 4.0) * (GRASS_SEGMENTS / p_blade.length());
}

// Where the blade stands still under forces that may follow it.
void stand(ElasticBlade &r_blade, const std::function<Forces(const ElasticBlade &)> &p_forces) {
	Blade<double> &blade = r_blade.blade;
	measure_lengths(blade);
	const StepTerms<double> terms = make_terms<double>(r_blade.clock.advance(r_blade.params, 1.0 / 60.0), 0.0f, {});
	const ChainTerms<double> chain = make_chain_terms(blade, terms);
	Stage<double> stage{};
	stage.span = 0.1; // seconds
	stage.weight = 1.0;
	for (int i = 0; i < ROUNDS; i++) {
		const Forces forces = p_forces(r_blade);
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			const Eigen::Vector3d load = forces[size_t(k)] / knot_mass(blade, k, chain);
			set_target(stage, k, blade.knots[k], Vec3<double>{ load.x(), load.y(), load.z() } * (stage.span * stage.span));
		}
		solve_chain(blade, terms, chain, stage, true);
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) { // a solve keeps lengths to the second order
			const Vec3<double> e = segment(blade, k - 1);
			blade.knots[k] = blade.knots[k - 1] + e * (blade.lengths[k - 1] / length(e));
		}
	}
}

// Returns how far aside a cantilever under a tip load ends, shares of its length: theta'' = -p_load cos theta, level at the tip of no
// moment.
double tip_load_drop(double p_load) {
	constexpr int STEPS = 2000;
	constexpr double H = 1.0 / STEPS;
	const auto shoot = [&](double p_curvature) {
		using State = Eigen::Vector3d; // theta, curvature, drop
		const auto slope = [&](const State &p_y) { return State(p_y[1], -p_load * std::cos(p_y[0]), std::sin(p_y[0])); };
		State y(0.0, p_curvature, 0.0);
		for (int i = 0; i < STEPS; i++) { // Runge-Kutta, fourth order
			const State a = slope(y), b = slope(y + a * (H / 2)), c = slope(y + b * (H / 2)), d = slope(y + c * H);
			y += (a + b * 2.0 + c * 2.0 + d) * (H / 6.0);
		}
		return y;
	};
	double low = 0.0, high = p_load;
	for (int i = 0; i < 60; i++) {
		const double middle = (low + high) / 2.0;
		(shoot(middle)[1] < 0.0 ? low : high) = middle;
	}
	return shoot(low)[2];
}

} // namespace

TEST_CASE("METHOD_DIRECT: a tip load bends a blade as the elastica within 2 %, from a slight bend to one along the load") {
	CHECK(tip_load_drop(0.01) == doctest::Approx(0.01 / 3.0).epsilon(1e-3)); // P L^3 / 3 EI
	for (const double load : { 0.1, 0.5, 1.0, 2.0, 5.0, 10.0 }) { // P L^2 / EI
		CAPTURE(load);
		ElasticBlade blade = ElasticBlade::straight();
		const double force = load * stiffness_of(blade) / (blade.length() * blade.length());
		stand(blade, [&](const ElasticBlade &) {
			Forces forces;
			forces.fill(Eigen::Vector3d::Zero());
			forces[TIP].x() = force;
			return forces;
		});
		CHECK(blade.place(TIP).x() / blade.length() == doctest::Approx(tip_load_drop(load)).epsilon(0.02));
	}
}

TEST_CASE("METHOD_DIRECT: an end moment bends a blade to an arc, nearly to half a circle (beyond, it would meet the ground), within 1.5 % "
		  "of its length") {
	for (const double angle : { 0.1, 0.5, 1.0, 2.0, 2.9 }) { // M L / EI, radians from root to tip
		CAPTURE(angle);
		ElasticBlade blade = ElasticBlade::straight();
		const double length = blade.length(), moment = angle * stiffness_of(blade) / length;
		stand(blade, [&](const ElasticBlade &p_blade) { // a couple at the last segment's ends
			const Eigen::Vector3d e = p_blade.place(TIP) - p_blade.place(TIP - 1);
			const Eigen::Vector3d force = Eigen::Vector3d(e.y(), -e.x(), 0.0) * (moment / e.squaredNorm());
			Forces forces;
			forces.fill(Eigen::Vector3d::Zero());
			forces[TIP] = force;
			forces[TIP - 1] = -force;
			return forces;
		});
		const Eigen::Vector3d wanted(length / angle * (1.0 - std::cos(angle)), length / angle * std::sin(angle), 0.0);
		CHECK((blade.place(TIP) - wanted).norm() < 0.015 * length);
		double most = 0.0, least = 10.0; // of the turns of the joints that stand for one segment each
		for (int s = 2; s < GRASS_SEGMENTS; s++) {
			const Eigen::Vector3d before = blade.place(s) - blade.place(s - 1), here = blade.place(s + 1) - blade.place(s);
			const double turn = std::atan2(before.cross(here).norm(), before.dot(here));
			most = std::max(most, turn);
			least = std::min(least, turn);
		}
		CHECK(most < 1.001 * least);
	}
}

TEST_CASE("METHOD_DIRECT: a load in any direction across the blade bends it alike, in a plane, however it got there") {
	const auto bend = [](double p_heading, bool p_is_led) {
		ElasticBlade blade = ElasticBlade::straight();
		blade.params.damping_ratio = 1.0;
		const double load = 5.0 * bending_of(blade.params) * blade.length();
		const double start = p_is_led ? p_heading + 2.0 : p_heading;
		for (int i = 0; i < 1200; i++) {
			const double heading = start + (p_heading - start) * std::min(i / 300.0, 1.0);
			blade.params.load[0] = load * std::cos(heading);
			blade.params.load[2] = load * std::sin(heading);
			blade.step(1.0 / 60.0);
		}
		return blade;
	};
	const ElasticBlade planar = bend(0.0, false);
	for (const double heading : { 0.7, 2.9 }) {
		for (const bool is_led : { false, true }) {
			CAPTURE(heading);
			CAPTURE(is_led);
			const ElasticBlade blade = bend(heading, is_led);
			for (int k = 0; k < GRASS_KNOTS; k++) {
				const double out = planar.place(k).x();
				const Eigen::Vector3d wanted(out * std::cos(heading), planar.place(k).y(), out * std::sin(heading));
				CHECK((blade.place(k) - wanted).norm() < 1e-3 * planar.length());
			}
		}
	}
}
