// SPDX-License-Identifier: MIT
// METHOD_DIRECT where nothing is near: near to the truth in space, stable whatever a blade is like, and home again.
#include "elastic_blade.h"

#include "core/base/functions.h"
#include "core/base/half.h"
#include "core/blades/patch.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

using namespace grass;
using namespace grass::test;

namespace {

constexpr int TIP = GRASS_KNOTS - 1;

// Returns a direction that leans by p_lean towards p_bearing, radians: 0 is along x.
Eigen::Vector3d leaning(double p_lean, double p_bearing) {
	return { std::sin(p_lean) * std::cos(p_bearing), std::cos(p_lean), std::sin(p_lean) * std::sin(p_bearing) };
}
using Way = std::function<Eigen::Vector3d(double)>; // a direction, by the share of the way from root to tip
// Half a metre long.
ElasticBlade along(const Way &p_way) {
	Eigen::Vector3d place = Eigen::Vector3d::Zero();
	int segment = 0;
	return ElasticBlade([&](double p_share) -> Eigen::Vector3d { // from knot to knot
		for (; knot_share(segment) < p_share; segment++) {
			place += p_way(knot_share(segment) + 0.5 * segment_share(segment)) * (0.5 * segment_share(segment));
		}
		return place;
	});
}
// To another shape, standing still.
void pose(ElasticBlade &r_blade, const Way &p_way) {
	Blade<double> &blade = r_blade.blade;
	for (int s = 1; s < GRASS_SEGMENTS; s++) {
		const Eigen::Vector3d way = p_way(knot_share(s) + 0.5 * segment_share(s)) * r_blade.rest_length(s);
		blade.knots[s + 1] = blade.before[s + 1] = blade.knots[s] + Vec3<double>{ way.x(), way.y(), way.z() };
	}
}
struct Shape {
	std::string name;
	Way way;
};
const Shape STRAIGHT{ "straight", [](double) { return Eigen::Vector3d(0.0, 1.0, 0.0); } };
const Shape ARC_90{ "arc of 90 degrees", [](double p_share) { return leaning(90.0 * DEGREE * p_share, 0.0); } };
const Shape HELIX{ "helix", [](double p_share) { return leaning((10.0 + 50.0 * p_share) * DEGREE, 200.0 * DEGREE * p_share); } };
const Shape WIDE_HELIX{ "helix of 35 degrees", [](double p_share) { return leaning(35.0 * DEGREE, 270.0 * DEGREE * p_share); } };
const Shape S_40{ "S", [](double p_share) { return leaning(40.0 * DEGREE * std::sin(2.0 * std::numbers::pi * p_share / 0.35), 0.0); } };
const Shape ARC_300{ "arc of 300 degrees", [](double p_share) { return leaning(300.0 * DEGREE * p_share, 0.0); } };
const Shape COIL{ "coil", [](double p_share) { return leaning(35.0 * DEGREE, 720.0 * DEGREE * p_share); } };
const Shape SHAPES[] = { STRAIGHT, ARC_90, HELIX, WIDE_HELIX, S_40, ARC_300, COIL };

// EI / (density area length^4), 1/s^2.
double bending_of(const SolverParams &p_params) {
	const double share = 2.0 * std::numbers::pi * p_params.natural_frequency / 3.5160152685;
	return share * share;
}
// Standing still under a load of density area g length^3 / EI = p_gamma along p_axis, which then is gone.
ElasticBlade make_loaded(const Shape &p_shape, double p_gamma, int p_axis) {
	ElasticBlade blade = along(p_shape.way);
	blade.params.damping_ratio = 1.0;
	for (int i = 0; i < 1500; i++) {
		blade.params.load[p_axis] = p_gamma * bending_of(blade.params) * blade.length() * std::min(1.0, i / 600.0);
		blade.step_aloft(1.0 / 60.0);
	}
	blade.params.load[p_axis] = 0.0;
	for (int k = 0; k < GRASS_KNOTS; k++) {
		blade.blade.before[k] = blade.blade.knots[k];
	}
	return blade;
}
// Returns all knots, six times a second.
std::vector<Eigen::Vector3d> path_of(ElasticBlade p_blade, double p_rate, double p_seconds) {
	std::vector<Eigen::Vector3d> path;
	for (int i = 1; i <= int(p_seconds * p_rate); i++) {
		p_blade.step_aloft(1.0 / p_rate);
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS && i % int(p_rate / 6.0) == 0; k++) {
			path.push_back(p_blade.place(k));
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
	return std::sqrt(sum / double(p_a.size())) / 0.5;
}
double distance_from_rest(const ElasticBlade &p_blade) {
	double most = 0.0;
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		most = std::max(most, length(p_blade.blade.knots[k] - p_blade.blade.rest[k]));
	}
	return most;
}

// Returns all knots, six times a second, for a second and a half from rest on, under a load that is there for a quarter of a second of
// every half.
std::vector<Eigen::Vector3d> gusty_path_of(const Shape &p_shape, double p_gamma, double p_rate) {
	ElasticBlade blade = along(p_shape.way);
	blade.params.damping_ratio = 0.2;
	std::vector<Eigen::Vector3d> path;
	for (int i = 0; i < int(1.5 * p_rate); i++) {
		const bool blows = int(i / p_rate * 4.0 + 1e-6) % 2 == 0;
		blade.params.load[2] = blows ? p_gamma * bending_of(blade.params) * blade.length() : 0.0;
		blade.step_aloft(1.0 / p_rate);
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS && (i + 1) % int(p_rate / 6.0) == 0; k++) {
			path.push_back(blade.place(k));
		}
	}
	return path;
}

ElasticBlade patch_blade(const Patch &p_patch, int p_blade) {
	return ElasticBlade([&](double p_share) {
		const int knot = int(std::lround(glsl::grass_knot_at(float(p_share))));
		const uint16_t *halves = &p_patch.texels[Patch::texel_index(p_blade, knot)];
		return knot == 0 ? Eigen::Vector3d(0.0, 0.0, 0.0)
						 : Eigen::Vector3d(half_to_float(halves[0]), half_to_float(halves[1]), half_to_float(halves[2]));
	});
}

} // namespace

TEST_CASE("METHOD_DIRECT: a blade let go from a bent and twisted shape moves within 0.0155 of its length of the truth at any frame rate") {
	for (const Shape &shape : { ARC_90, HELIX, WIDE_HELIX }) {
		for (const double damping : { 0.1, 0.5 }) {
			ElasticBlade blade = make_loaded(shape, 8.0, 2);
			blade.clock.reset();
			blade.params.damping_ratio = damping;
			const std::vector<Eigen::Vector3d> truth = path_of(blade, 3840.0, 1.0);
			double before = 1.0;
			for (const double rate : { 30.0, 60.0, 144.0 }) {
				const double error = apart_by(path_of(blade, rate, 1.0), truth);
				INFO(shape.name, ", ", rate, " steps a second: ", error);
				CHECK(error > 0.0);
				CHECK(error < 0.0155);
				CHECK(error < before);
				before = error;
			}
		}
	}
}

TEST_CASE(
		"METHOD_DIRECT: a load that ends or begins at once starts no blade ahead of time, whether it stands still, nearly so, or swings") {
	for (const Shape &shape : { ARC_90, HELIX, WIDE_HELIX }) {
		ElasticBlade still = make_loaded(shape, 5.0, 2); // to the bit
		still.params.damping_ratio = 0.2;
		ElasticBlade nearly = still;
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			nearly.blade.before[k] = nearly.blade.knots[k] - Vec3<double>{ 1e-9 * k, 0.0, 0.0 };
		}
		ElasticBlade alone = still;
		alone.clock.reset();
		const std::vector<Eigen::Vector3d> truth = path_of(alone, 3840.0, 1.0), gusty_truth = gusty_path_of(shape, 2.0, 3840.0);
		const double from_still = apart_by(path_of(still, 60.0, 1.0), truth), from_nearly = apart_by(path_of(nearly, 60.0, 1.0), truth);
		const double gusty = apart_by(gusty_path_of(shape, 2.0, 60.0), gusty_truth);
		MESSAGE(shape.name << ": " << from_still << ", nearly still " << from_nearly << ", in gusts " << gusty << " L");
		CHECK(from_still < 0.003);
		CHECK(from_nearly < 0.003);
		CHECK(gusty < 0.0025);
	}
}

TEST_CASE("METHOD_DIRECT: an undamped swing of the second kind dies down by at most 1 a second at any frame rate") {
	constexpr double SECOND = 4.69409; // of a cantilever: its wave number
	const auto slope = [](double p_share) { // of the second kind
		const double x = SECOND * p_share, ratio = (std::sinh(SECOND) - std::sin(SECOND)) / (std::cosh(SECOND) + std::cos(SECOND));
		return std::sinh(x) + std::sin(x) - ratio * (std::cosh(x) - std::cos(x));
	};
	for (const double rate : { 30.0, 60.0, 144.0, 480.0 }) {
		CAPTURE(rate);
		ElasticBlade blade = ElasticBlade::straight();
		blade.params.damping_ratio = 0.0;
		pose(blade, [&](double p_share) { return leaning(1e-5 * slope(p_share), 0.0); });
		const double delta = 1.0 / rate;
		ElasticBlade after = blade, here = blade, before = blade;
		double first = 0.0, last = 0.0; // mean energies of a tenth of a second
		const int mean = int(0.1 * rate), count = int(rate);
		for (int i = 0; i < count; i++) {
			before = here;
			here = after;
			after.step_aloft(delta);
			const double energy = i == 0 ? 0.0 : energy_between(before, here, after, delta);
			first += i >= 1 && i <= mean ? energy : 0.0;
			last += i >= count - mean ? energy : 0.0;
		}
		const double decay = 0.5 * std::log(first / last) / ((count - mean) / rate);
		CHECK(decay < 1.0);
		CHECK(decay > -1e-3);
	}
}

TEST_CASE("METHOD_DIRECT: a slight kick dies down, whatever the blade's shape at rest, and undamped does not grow") {
	for (const Shape &shape : SHAPES) {
		for (const double rate : { 30.0, 60.0, 144.0 }) {
			for (const double damping : { 0.0, 0.5 }) {
				ElasticBlade blade = along(shape.way);
				blade.params.damping_ratio = damping;
				for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
					blade.blade.before[k] = blade.blade.knots[k] - Vec3<double>{ 1.0, 0.0, 1.0 } * (5e-5 * k / GRASS_SEGMENTS);
				}
				double early = 0.0, late = 0.0;
				for (int i = 0; i < int(20.0 * rate); i++) {
					blade.step_aloft(1.0 / rate);
					early = i < 5.0 * rate ? std::max(early, distance_from_rest(blade)) : early;
					late = i > 15.0 * rate ? std::max(late, distance_from_rest(blade)) : late;
				}
				INFO(shape.name, ", ", rate, " steps a second, damping ", damping, ": ", early, " m, then ", late);
				CHECK(early > 1e-5);
				CHECK(late < (damping > 0.0 ? 1e-6 : 1.0) * early);
			}
		}
	}
}

TEST_CASE("METHOD_DIRECT: the energy of a blade that is let go from a violent pose is never above its start") {
	const Shape poses[] = { { "arc of 180 degrees", [](double p_share) { return leaning(180.0 * DEGREE * p_share, 0.0); } }, ARC_300,
		{ "arc across", [](double p_share) { return leaning(180.0 * DEGREE * p_share, 0.5 * std::numbers::pi); } },
		{ "S of 90 degrees",
				[](double p_share) { return leaning(90.0 * DEGREE * std::sin(2.0 * std::numbers::pi * p_share / 0.7), 0.0); } },
		{ "helix of 60 degrees", [](double p_share) { return leaning(60.0 * DEGREE, 360.0 * DEGREE * p_share); } } };
	for (const Shape &shape : { STRAIGHT, ARC_90, HELIX, WIDE_HELIX, S_40, ARC_300 }) {
		for (const Shape &from : poses) {
			for (const double rate : { 30.0, 60.0, 144.0 }) {
				for (const double damping : { 0.0, 0.5 }) {
					ElasticBlade after = along(shape.way);
					after.params.damping_ratio = damping;
					pose(after, from.way);
					const double first = after.energy(1.0 / rate);
					ElasticBlade here = after, before = after;
					double most = 0.0;
					for (int i = 0; i < int(10.0 * rate); i++) {
						before = here;
						here = after;
						after.step_aloft(1.0 / rate);
						// As it is let go its speed has a jump, which no mean of both sides tells.
						most = i == 0 ? most : std::max(most, energy_between(before, here, after, 1.0 / rate));
					}
					INFO(shape.name, " from ", from.name, ", ", rate, " steps a second, damping ", damping, ": ", most / first);
					CHECK((first < 1e-6 || most <= first));
				}
			}
		}
	}
}

TEST_CASE("METHOD_DIRECT: a load along a blade towards its root makes a slight swing slower, not larger, and buckles what is too slender") {
	for (const auto &[gamma, is_stable] : { std::pair(3.0, true), std::pair(6.0, true), std::pair(12.0, false) }) {
		for (const double rate : { 30.0, 60.0, 144.0 }) {
			ElasticBlade blade = ElasticBlade::straight();
			const double load = gamma * bending_of(blade.params) * blade.length();
			blade.params.damping_ratio = 0.0;
			blade.params.load[1] = -load;
			for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
				blade.blade.before[k].x -= 5e-4 * k / GRASS_SEGMENTS / 60.0 * (60.0 / rate);
			}
			double early = 0.0, late = 0.0;
			for (int i = 0; i < int(60.0 * rate); i++) {
				blade.step_aloft(1.0 / rate);
				early = i < 5.0 * rate ? std::max(early, distance_from_rest(blade)) : early;
				late = i > 50.0 * rate ? std::max(late, distance_from_rest(blade)) : late;
			}
			INFO(gamma, ", ", rate, " steps a second: ", early, " m, then ", late);
			if (is_stable) {
				CHECK(late <= early);
			} else {
				CHECK(early > 0.1);
			}
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
