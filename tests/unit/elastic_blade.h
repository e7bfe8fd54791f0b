// SPDX-License-Identifier: MIT
// One blade in double precision by METHOD_DIRECT, for the tests of its physics. elastic_blade.cpp compiles its large step once.
// once.
#pragma once

#include "core/solver/solver.h"
#include "core/solver/solver_params.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace grass::test {

struct ElasticBlade {
	Blade<double> blade{};
	SolverParams params;
	StepClock clock;

	// p_place: of the share of the way from root to tip, metres.
	explicit ElasticBlade(const std::function<Eigen::Vector3d(double)> &p_place) {
		params.taper = 0.0; // theory's rods are even and round
		params.width_to_thickness = 1.0;
		blade.width = { 0.0, 0.0, 1.0 };
		for (int k = 0; k < GRASS_KNOTS; k++) {
			const Eigen::Vector3d place = p_place(knot_share(k));
			blade.rest[k] = blade.knots[k] = blade.before[k] = { place.x(), place.y(), place.z() };
		}
	}
	// Of half a metre, upright.
	static ElasticBlade straight() {
		return ElasticBlade([](double p_share) { return Eigen::Vector3d(0.0, 0.5 * p_share, 0.0); });
	}
	// Upright at the root, level at the tip.
	static ElasticBlade quarter_circle() {
		return ElasticBlade([](double p_share) {
			const double angle = 0.5 * std::numbers::pi * p_share, radius = 0.3;
			return Eigen::Vector3d(radius * (1.0 - std::cos(angle)), radius * std::sin(angle), 0.0);
		});
	}

	Eigen::Vector3d place(int p_knot) const { return { blade.knots[p_knot].x, blade.knots[p_knot].y, blade.knots[p_knot].z }; }
	double rest_length(int p_segment) const { return grass::length(rest_segment(blade, p_segment)); }
	double length() const {
		double sum = 0.0;
		for (int s = 0; s < GRASS_SEGMENTS; s++) {
			sum += rest_length(s);
		}
		return sum;
	}
	// Returns the worst of the segments, shares of it.
	double stretch() const {
		double most = 0.0;
		for (int s = 0; s < GRASS_SEGMENTS; s++) {
			most = std::max(most, std::abs(grass::length(segment(blade, s)) / rest_length(s) - 1.0));
		}
		return most;
	}

	// To an arc towards +x, p_angle radians from root to tip, standing still.
	void bend(double p_angle) {
		for (int k = 1; k < GRASS_SEGMENTS; k++) {
			const double angle = p_angle * (knot_share(k) + 0.5 * segment_share(k)), length = rest_length(k);
			blade.knots[k + 1] = blade.knots[k] + Vec3<double>{ length * std::sin(angle), length * std::cos(angle), 0.0 };
			blade.before[k + 1] = blade.knots[k + 1];
		}
	}
	void step(double p_delta);
	// Far above the ground.
	void step_aloft(double p_delta);
	void step_for(double p_seconds, double p_rate) {
		for (int i = 0; i < int(std::lround(p_seconds * p_rate)); i++) {
			step(1.0 / p_rate);
		}
	}

	// Of the knots' speed and of the joints' turns, per mass of a segment: J/kg. p_delta: of the last step, seconds.
	double energy(double p_delta) {
		measure_lengths(blade);
		StepClock other;
		const StepTerms<double> terms = make_terms<double>(other.advance(params, p_delta), 0.0f, {});
		const ChainTerms<double> chain = make_chain_terms(blade, terms);
		JointGain<double> joints[GRASS_SEGMENTS];
		measure_joints(blade, chain, joints);
		double sum = 0.0;
		for (int s = 1; s < GRASS_SEGMENTS; s++) {
			const Vec3<double> speed = (blade.knots[s + 1] - blade.before[s + 1]) * (1.0 / p_delta);
			sum += 0.5 * knot_mass(blade, s + 1, chain) * dot(speed, speed);
			const double stiffer = dot(joints[s].axis, joints[s].turn); // [Eq 45]
			sum += 0.5 * joint_stiffness(blade, s, chain, chain.bending) * (dot(joints[s].turn, joints[s].turn) + stiffer * stiffer);
		}
		return sum;
	}
};

// Returns the energy at the blade's place of the step before: of the speed between the steps on both sides, and of its joints. J/kg.
inline double energy_between(const ElasticBlade &p_before, const ElasticBlade &p_here, const ElasticBlade &p_after, double p_delta) {
	ElasticBlade here = p_here;
	for (int k = 0; k < GRASS_KNOTS; k++) {
		here.blade.before[k] = here.blade.knots[k] - (p_after.blade.knots[k] - p_before.blade.knots[k]) * 0.5;
	}
	return here.energy(p_delta);
}

} // namespace grass::test
