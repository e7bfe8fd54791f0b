// SPDX-License-Identifier: MIT
// METHOD_DIRECT as a rod: what beam theory says of sag, frequency, bending and twisting, and what an integrator owes.
#include <doctest/doctest.h>

#include "elastic_blade.h"

#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

using namespace grass;
using namespace grass::test;

namespace {

constexpr int TIP = GRASS_KNOTS - 1;
constexpr double FIRST_MODE = 3.5160152685; // of a cantilever: radians per second over the root of EI / (density area length^4)

// EI / (density area length^4), 1/s^2.
double bending_of(const SolverParams &p_params) {
	const double share = 2.0 * std::numbers::pi * p_params.natural_frequency / FIRST_MODE;
	return share * share;
}

// How the elastica ends that leaves its clamp with p_curvature (radians per length): theta'' = -gamma (1 - s) cos theta.
struct ElasticaEnd {
	double curvature, drop; // radians per length, shares of the length
};
ElasticaEnd shoot(double p_gamma, double p_curvature) {
	constexpr int STEPS = 2000;
	constexpr double H = 1.0 / STEPS;
	using State = Eigen::Vector3d; // theta, curvature, drop
	const auto slope = [&](double p_s, const State &p_y) {
		return State(p_y[1], -p_gamma * (1.0 - p_s) * std::cos(p_y[0]), std::sin(p_y[0]));
	};
	State y(0.0, p_curvature, 0.0);
	for (int i = 0; i < STEPS; i++) { // Runge-Kutta, fourth order
		const double s = i * H;
		const State a = slope(s, y), b = slope(s + H / 2, y + a * (H / 2)), c = slope(s + H / 2, y + b * (H / 2)),
					d = slope(s + H, y + c * H);
		y += (a + b * 2.0 + c * 2.0 + d) * (H / 6.0);
	}
	return { y[1], y[2] };
}
// Drop of the tip of a heavy cantilever, shares of its length: the curvature at the tip is 0.
double elastica_drop(double p_gamma) {
	double low = 0.0, high = p_gamma / 2.0; // that of small sag, the most there can be
	for (int i = 0; i < 60; i++) {
		const double middle = (low + high) / 2.0;
		(shoot(p_gamma, middle).curvature < 0.0 ? low : high) = middle;
	}
	return shoot(p_gamma, low).drop;
}

// Returns a straight blade that a small load has bent, released, undamped.
ElasticBlade make_swinging(double p_frequency) {
	ElasticBlade blade = ElasticBlade::straight();
	blade.params.natural_frequency = p_frequency;
	blade.params.damping_ratio = 0.7;
	blade.params.load[0] = 0.05 * bending_of(blade.params) * blade.length();
	blade.step_for(12.0 / p_frequency, 60.0);
	blade.params.load[0] = blade.params.damping_ratio = 0.0;
	return blade;
}

// Returns the error of the tip's place, metres, after a push of 0.4 s that swells and ebbs; p_push: its mean, m/s^2. (A blade that is
// let go all at once swings in modes too fast for any of these rates.)
double error_of(double p_push, double p_rate) {
	const auto tip = [&](double p_at) {
		ElasticBlade blade = ElasticBlade::straight();
		const int count = int(std::lround(0.4 * p_at));
		for (int i = 0; i < count; i++) {
			blade.params.load[0] = p_push * (1.0 - std::cos(2.0 * std::numbers::pi * i / count)); // m/s^2, as the step begins
			blade.step(1.0 / p_at);
		}
		return blade.place(TIP);
	};
	return (tip(p_rate) - tip(15360.0)).norm();
}
// Order of convergence between 60 and 480 Hz.
double order_of(double p_push) {
	return std::log2(error_of(p_push, 60.0) / error_of(p_push, 480.0)) / 3.0;
}

// Frequencies (Hz) and steps a second.
constexpr std::pair<double, double> RATES[] = { { 0.6, 30.0 }, { 0.9, 30.0 }, { 1.2, 30.0 }, { 1.2, 60.0 }, { 1.9, 60.0 }, { 2.5, 144.0 },
	{ 4.5, 144.0 } };

// Returns how far an energy rises above its least so far in p_steps steps, shares of p_first. p_next: takes a step and tells the energy.
template <class Next> double most_growth(double p_first, int p_steps, const Next &p_next) {
	double least = p_first, most = 0.0;
	for (int i = 0; i < p_steps; i++) {
		const double energy = p_next();
		most = std::max(most, (energy - least) / p_first);
		least = std::min(least, energy);
	}
	return most;
}

} // namespace

TEST_CASE("METHOD_DIRECT: a heavy blade hangs as the elastica within 2 %, from a slight sag to a blade that hangs down") {
	for (const double gamma : { 0.1, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0 }) {
		CAPTURE(gamma);
		ElasticBlade blade = ElasticBlade::straight();
		blade.params.load[0] = gamma * bending_of(blade.params) * blade.length();
		blade.params.damping_ratio = 1.0;
		blade.step_for(15.0, 60.0);
		CHECK(blade.place(TIP).x() / blade.length() == doctest::Approx(elastica_drop(gamma)).epsilon(0.02));
	}
}

TEST_CASE("METHOD_DIRECT: the elastica that it is held against has the drop of small sag, gamma / 8") {
	CHECK(elastica_drop(0.01) == doctest::Approx(0.01 / 8.0).epsilon(1e-3));
}

TEST_CASE("METHOD_DIRECT: a blade swings at its natural frequency within 3 % at 60 Hz, and undamped keeps 95 % of a swing") {
	for (const double frequency : { 1.2, 1.5, 2.5 }) {
		CAPTURE(frequency);
		ElasticBlade blade = make_swinging(frequency);
		constexpr int SWINGS = 10;
		double first = blade.place(TIP).x(), last = 0.0, before = first, most = 0.0, start = 0.0, end = 0.0;
		int crossings = 0;
		for (int i = 1; crossings <= 2 * SWINGS && i < 6000; i++) {
			blade.step(1.0 / 60.0);
			const double now = blade.place(TIP).x();
			most = std::max(most, std::abs(now));
			if (now * before < 0.0) { // through rest, half a swing after the last time
				end = (i - now / (now - before)) / 60.0;
				start = crossings == 0 ? end : start;
				last = most;
				most = 0.0;
				crossings++;
			}
			before = now;
		}
		REQUIRE(crossings == 2 * SWINGS + 1);
		CHECK(SWINGS / (end - start) == doctest::Approx(frequency).epsilon(0.03));
		CHECK(std::pow(last / first, 1.0 / SWINGS) >= 0.95);
	}
}

TEST_CASE(
		"METHOD_DIRECT: the error falls with the step by the second order, as long as it is bent slightly, and is small where it is not") {
	constexpr double SLIGHT = 0.05, STRONG = 5.0; // m/s^2: to 2 mm and to 18 cm
	CHECK(order_of(SLIGHT) >= 1.7);
	CHECK(order_of(STRONG) >= 1.7);
	CHECK(error_of(STRONG, 60.0) < 2e-3 * 0.5);
}

TEST_CASE("METHOD_DIRECT: the energy of a released blade never grows, undamped as damped") {
	for (const double damping : { 0.0, 0.5 }) {
		for (const auto &[frequency, rate] : RATES) {
			CAPTURE(damping);
			CAPTURE(frequency);
			CAPTURE(rate);
			ElasticBlade after = ElasticBlade::straight();
			after.params.damping_ratio = damping;
			after.params.natural_frequency = frequency;
			after.bend(2.0);
			ElasticBlade here = after, before = after;
			const double delta = 1.0 / rate;
			const auto next = [&] {
				before = here;
				here = after;
				after.step(delta);
				return energy_between(before, here, after, delta);
			};
			const double first = next(); // as it is let go its speed has a jump, which no mean of both sides tells
			const double growth = most_growth(first, int(20.0 * rate), next);
			// Of a swing by w the speed between steps falls short of its own by the share (w h)^2 / 6.
			const double turn = 2.0 * std::numbers::pi * frequency / rate;
			CHECK(growth <= 2e-3 + turn * turn / 3.0);
		}
	}
}

TEST_CASE("METHOD_DIRECT: lengths hold to 1e-5 and the clamp keeps every bit while a blade is shaken") {
	ElasticBlade blade = ElasticBlade::straight();
	const Eigen::Vector3d clamp[] = { blade.place(0), blade.place(1) };
	for (int i = 0; i < 600; i++) {
		blade.params.load[0] = 60.0 * std::sin(0.13 * i);
		blade.params.load[2] = 60.0 * std::cos(0.31 * i);
		blade.step(1.0 / 60.0);
		REQUIRE(blade.stretch() < 1e-5);
		REQUIRE(blade.place(0) == clamp[0]);
		REQUIRE(blade.place(1) == clamp[1]);
	}
}

TEST_CASE("METHOD_DIRECT: an even load across the plane of a quarter circle bends and twists it as Castigliano says, within 3 %") {
	ElasticBlade blade = ElasticBlade::quarter_circle();
	const double radius = blade.place(TIP).y(), length = 0.5 * std::numbers::pi * radius;
	const double stiffness = bending_of(blade.params) * std::pow(blade.length(), 4.0); // EI / (density area), m^4/s^2
	// At the angle a from the tip: moment w R^2 (1 - cos a), torque w R^2 (a - sin a); of a unit force at the tip R sin a and
	// R (1 - cos a). With GJ = EI the integrals of the products are 1/2 and pi^2/8 - pi/2 + 1/2.
	constexpr double PI = std::numbers::pi;
	const double wanted = 0.001 * length;
	const double load = wanted * stiffness / (std::pow(radius, 4.0) * (0.5 + PI * PI / 8.0 - PI / 2.0 + 0.5));
	blade.params.load[2] = load;
	blade.params.damping_ratio = 1.0;
	blade.step_for(12.0, 60.0);
	CHECK(blade.place(TIP).z() == doctest::Approx(wanted).epsilon(0.03));
}

TEST_CASE("METHOD_DIRECT: a slight undamped swing does not grow, of a straight blade or a curved one, in any direction") {
	for (const auto &[frequency, rate] : RATES) {
		for (const bool is_curved : { false, true }) {
			for (const int axis : { 0, 2 }) {
				CAPTURE(frequency);
				CAPTURE(rate);
				CAPTURE(is_curved);
				CAPTURE(axis);
				ElasticBlade blade = is_curved ? ElasticBlade::quarter_circle() : ElasticBlade::straight();
				const Eigen::Vector3d rest = blade.place(TIP);
				blade.params.natural_frequency = frequency;
				blade.params.damping_ratio = 0.7;
				blade.params.load[axis] = 0.05 * bending_of(blade.params) * blade.length();
				blade.step_for(12.0 / frequency, 60.0);
				blade.params.load[axis] = blade.params.damping_ratio = 0.0;
				double early = 0.0, late = 0.0; // how far the tip swings after 8 periods, when only the slowest swing is left, and after 38
				for (int i = 0; i < int(40.0 / frequency * rate); i++) {
					blade.step(1.0 / rate);
					const double periods = frequency * i / rate, away = (blade.place(TIP) - rest).norm();
					early = periods > 8.0 && periods < 10.0 ? std::max(early, away) : early;
					late = periods > 38.0 ? std::max(late, away) : late;
				}
				CHECK(early > 0.0);
				CHECK(late <= 1.001 * early);
			}
		}
	}
}
