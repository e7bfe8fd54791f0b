// SPDX-License-Identifier: MIT
// METHOD_DIRECT: a blade that tapers and is wider than thick, held against a rod without a chain.
#include <doctest/doctest.h>

#include "elastic_blade.h"
#include "kirchhoff_rod.h"

#include "core/solver/section.h"

#include <numbers>

using namespace grass;
using namespace grass::test;

namespace {

constexpr int TIP = GRASS_KNOTS - 1;
constexpr double FIRST_MODE = 3.5160152685; // of an even cantilever: radians per second over the root of EI / (density area length^4)
constexpr double PI = std::numbers::pi;

// An arc towards x that turns by p_turn from root to tip.
Eigen::Vector3d direction_at(double p_turn, double p_share) {
	return { std::sin(p_turn * p_share), std::cos(p_turn * p_share), 0.0 };
}
ElasticBlade arc(double p_turn) {
	return ElasticBlade([&](double p_share) {
		Eigen::Vector3d place = Eigen::Vector3d::Zero();
		for (int s = 0; s < GRASS_SEGMENTS && knot_share(s) < p_share; s++) {
			place += direction_at(p_turn, knot_share(s) + 0.5 * segment_share(s)) * (0.5 * segment_share(s));
		}
		return place;
	});
}
// EI / (density area length^4) at the root, 1/s^2.
double bending_of(const SolverParams &p_params) {
	const double share = 2.0 * PI * p_params.natural_frequency / FIRST_MODE;
	return share * share * make_section(p_params.taper).stiffness;
}
// Where the tip comes to rest, shares of the length. p_load: density area g length^3 / EI at the root.
Eigen::Vector3d standing(double p_turn, double p_taper, double p_wide, const Eigen::Vector3d &p_load) {
	ElasticBlade blade = arc(p_turn);
	blade.params.taper = p_taper;
	blade.params.width_to_thickness = p_wide;
	blade.params.damping_ratio = 1.0;
	const Eigen::Vector3d load = p_load * (bending_of(blade.params) * blade.length());
	for (int i = 0; i < 1200; i++) {
		for (int c = 0; c < 3; c++) {
			blade.params.load[c] = load[c];
		}
		blade.step_aloft(1.0 / 60.0);
	}
	return blade.place(TIP) / blade.length();
}

} // namespace

TEST_CASE("the rod that blades are held against hangs as the elastica: under 2, 5 and 10") {
	for (const auto &[gamma, drop] : { std::pair(2.0, 0.238507), std::pair(5.0, 0.495905), std::pair(10.0, 0.700200) }) {
		CHECK(leaf(0.0, 0.0, 1.0, { gamma, 0.0, 0.0 }).tip().x() == doctest::Approx(drop).epsilon(1e-5));
	}
}

TEST_CASE(
		"METHOD_DIRECT: a blade that tapers and is wider than thick bends as such a rod within 2 % of how far its tip goes: in its plane, "
		"aslant and across") {
	for (const double turn : { 0.0, 0.5 * PI }) {
		for (const auto &[taper, wide] : { std::pair(0.0, 1.0), std::pair(0.5, 1.0), std::pair(0.9, 1.0), std::pair(0.0, 2.0),
					 std::pair(0.0, 5.0), std::pair(0.5, 5.0), std::pair(0.3, 20.0) }) {
			for (const double gamma : { 0.3, 2.0, 8.0 }) {
				for (const double heading : { 0.0, 0.25 * PI, 0.5 * PI }) {
					const Eigen::Vector3d load = Eigen::Vector3d(std::cos(heading), 0.0, std::sin(heading)) * gamma;
					const Eigen::Vector3d rest = leaf(turn, taper, wide, Eigen::Vector3d::Zero()).shoot(Eigen::Vector3d::Zero()).place;
					const Eigen::Vector3d wanted = leaf(turn, taper, wide, load).tip() - rest;
					const Eigen::Vector3d found = standing(turn, taper, wide, load) - arc(turn).place(TIP) / arc(turn).length();
					const double error = (found - wanted).norm() / wanted.norm();
					INFO(turn, ", taper ", taper, ", ", wide, " x, ", gamma, ", ", heading, ": ", error);
					CHECK(error < 0.02);
				}
			}
		}
	}
}

TEST_CASE("METHOD_DIRECT: a load aside moves a blade 5 times wider than thick a 25th as far, straight, and a third as far, curved") {
	const Eigen::Vector3d aside(0.0, 0.0, 0.3);
	CHECK(standing(0.0, 0.0, 1.0, aside).z() / standing(0.0, 0.0, 5.0, aside).z() == doctest::Approx(25.0).epsilon(0.01));
	CHECK(standing(0.5 * PI, 0.0, 1.0, aside).z() / standing(0.5 * PI, 0.0, 5.0, aside).z() > 3.0);
}

TEST_CASE("an even blade's section changes nothing, to the bit, and one that loses half of its width swings 1.227 times as often") {
	const Section even = make_section(0.0);
	CHECK(even.thins == 0.0);
	CHECK(even.stiffness == 1.0);
	CHECK(even.first_joint == 1.0);
	CHECK(FIRST_MODE / std::sqrt(make_section(0.5).stiffness) ==
			doctest::Approx(4.315).epsilon(1e-3)); // of a plate that narrows, by tables
}

TEST_CASE("METHOD_DIRECT: a blade swings as often as it is told whatever its taper, within 1 %") {
	for (const double taper : { 0.0, 0.5, 0.9 }) {
		ElasticBlade blade = ElasticBlade::straight();
		blade.params.taper = taper;
		blade.params.damping_ratio = 0.7;
		blade.params.load[0] = 0.05 * bending_of(blade.params) * blade.length();
		blade.step_for(10.0, 60.0);
		blade.params.load[0] = blade.params.damping_ratio = 0.0;
		constexpr double RATE = 240.0;
		double before = blade.place(TIP).x(), start = 0.0, end = 0.0;
		int crossings = 0;
		for (int i = 1; crossings <= 10; i++) {
			blade.step(1.0 / RATE);
			const double now = blade.place(TIP).x();
			if (now * before < 0.0) { // through rest, half a swing after the last time
				end = (i - now / (now - before)) / RATE;
				start = crossings == 0 ? end : start;
				crossings++;
			}
			before = now;
		}
		INFO("taper ", taper, ": ", 5.0 / (end - start), " Hz");
		CHECK(5.0 / (end - start) == doctest::Approx(blade.params.natural_frequency).epsilon(0.01));
	}
}

TEST_CASE("METHOD_DIRECT: the energy of a blade that tapers, and is wider than thick, is never above its start, from violent poses, and it "
		  "comes home") {
	for (const auto &[taper, wide] : { std::pair(0.3, 1.0), std::pair(0.9, 1.0), std::pair(0.3, 5.0), std::pair(0.3, 20.0) }) {
		for (const double turn : { 0.0, 0.5 * PI }) {
			for (const double angle : { 2.0, 3.0, 5.0 }) { // from rest
				for (const double rate : { 30.0, 60.0, 144.0 }) {
					for (const double damping : { 0.0, 0.5 }) {
						ElasticBlade after = arc(turn);
						after.params.taper = taper;
						after.params.width_to_thickness = wide;
						after.params.damping_ratio = damping;
						after.bend(turn + angle);
						const double first = after.energy(1.0 / rate);
						ElasticBlade here = after, before = after;
						double most = 0.0;
						for (int i = 0; i < int(8.0 * rate); i++) {
							before = here;
							here = after;
							after.step_aloft(1.0 / rate);
							// As it is let go its speed has a jump, which no mean of both sides tells.
							most = i == 0 ? most : std::max(most, energy_between(before, here, after, 1.0 / rate));
						}
						INFO("taper ", taper, ", ", wide, " x, ", turn, " from ", angle, ", ", rate, " steps a second, damping ", damping,
								": ", most / first);
						CHECK(most > 0.0);
						CHECK(most <= first);
						CHECK((damping == 0.0 || (after.place(TIP) - arc(turn).place(TIP)).norm() < 1e-3));
					}
				}
			}
		}
	}
}
