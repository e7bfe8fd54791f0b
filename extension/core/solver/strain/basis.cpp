// SPDX-License-Identifier: MIT
#include "core/solver/strain/basis.h"

#include <Eigen/LU>

#include <cmath>
#include <utility>

namespace grass {

namespace {

// Returns function p_order of the basis at the share p_place of the way from root to tip: 1 - s times the Jacobi polynomial of 2 s - 1 that
// makes all of them orthonormal, by its recurrence.
double basis_at(int p_order, double p_place) {
	const double x = 2.0 * p_place - 1.0;
	double before = 0.0, now = 1.0;
	for (int n = 1; n <= p_order; n++) {
		const double next = n == 1
				? 2.0 * x + 1.0
				: ((2 * n + 1) * ((n + 1) * n * x + 1.0) * now - (n + 1) * (n + 1) * (n - 1) * before) / (n * n * (n + 2));
		before = std::exchange(now, next);
	}
	return std::sqrt(2.0 * p_order + 3.0) * (1.0 - p_place) * now;
}

// Returns the integral of a polynomial of up to degree 9 between two places, by Gauss.
template <class Body> double integral(double p_from, double p_to, const Body &p_body) {
	constexpr double PLACES[] = { 0.0, 0.538469310105683, 0.906179845938664 }; // in the half of the interval, on both sides
	constexpr double WEIGHTS[] = { 0.568888888888889, 0.478628670499366, 0.236926885056189 };
	const double middle = 0.5 * (p_from + p_to), half = 0.5 * (p_to - p_from);
	double sum = WEIGHTS[0] * p_body(middle);
	for (int i = 1; i < 3; i++) {
		sum += WEIGHTS[i] * (p_body(middle - half * PLACES[i]) + p_body(middle + half * PLACES[i]));
	}
	return sum * half;
}
// Integrates along the whole blade.
template <class Body> double along_blade(const Body &p_body) {
	double sum = 0.0;
	for (int s = 0; s < GRASS_SEGMENTS; s++) {
		sum += integral(knot_share(s), knot_share(s + 1), p_body);
	}
	return sum;
}

// [Eq Q7] Returns the masses of a blade of length 1. They weigh the powers 2 to POWERS + 1 of the way as the blade does, and are otherwise
// as near as they can be to what lies nearest to each. One more power would make some negative.
constexpr int POWERS = 6;
Eigen::Vector<double, GRASS_STRAIN_MASSES> masses_of(double p_taper) {
	Eigen::Vector<double, GRASS_STRAIN_MASSES> nearest;
	Eigen::Matrix<double, POWERS, GRASS_STRAIN_MASSES> powers;
	Eigen::Vector<double, POWERS> wanted;
	const auto place_of = [](int p_mass) { return knot_share(GRASS_STRAIN_FIRST_MASS + 2 * p_mass); };
	for (int i = 0; i < GRASS_STRAIN_MASSES; i++) {
		const double from = i == 0 ? 0.0 : 0.5 * (place_of(i - 1) + place_of(i));
		const double to = i + 1 == GRASS_STRAIN_MASSES ? 1.0 : 0.5 * (place_of(i) + place_of(i + 1));
		nearest[i] = (to - from) * (1.0 - p_taper * 0.5 * (from + to));
		for (int n = 0; n < POWERS; n++) {
			powers(n, i) = std::pow(place_of(i), n + 2);
		}
	}
	for (int n = 0; n < POWERS; n++) {
		wanted[n] = 1.0 / (n + 3) - p_taper / (n + 4);
	}
	const Eigen::Matrix<double, GRASS_STRAIN_MASSES, POWERS> shares = nearest.asDiagonal() * powers.transpose();
	const Eigen::Matrix<double, POWERS, POWERS> both = powers * shares;
	return nearest + shares * both.partialPivLu().solve(wanted - powers * nearest);
}

} // namespace

double joint_turn_of(int p_joint, int p_order) {
	// The share of joint p_joint in the bend at a place. What lies below the first joint counts in it and, negatively, in the second: so
	// all that is above is where bending along the way would bring it.
	const auto part = [&](int p_from, double p_at_from, double p_at_to) {
		const double from = knot_share(p_from), to = knot_share(p_from + 1);
		return integral(from, to, [&](double p_place) {
			const double way = (p_place - from) / (to - from);
			return basis_at(p_order, p_place) * (p_at_from * (1.0 - way) + p_at_to * way);
		});
	};
	const double above = part(p_joint, 1.0, 0.0);
	const double below = p_joint == 1 ? part(0, 1.0 + GRASS_CLAMP_SEGMENTS, 1.0) : part(p_joint - 1, 0.0, 1.0);
	return above + below + (p_joint == 2 ? part(0, -GRASS_CLAMP_SEGMENTS, 0.0) : 0.0);
}

StrainSection<float> make_strain_section(double p_taper, double p_width_to_thickness) {
	StrainSection<float> section;
	const double stiffer = p_width_to_thickness * p_width_to_thickness - 1.0;
	for (int i = 0; i < GRASS_STRAIN_ORDERS; i++) {
		for (int j = 0; j <= i; j++) {
			const auto spring = [&](double p_stiffer) {
				return float(along_blade([&](double p_place) {
					const double width = 1.0 - p_taper * p_place;
					return basis_at(i, p_place) * basis_at(j, p_place) * width * (1.0 + p_stiffer * width * width);
				}));
			};
			section.soft.at[i * (i + 1) / 2 + j] = spring(0.0);
			section.stiff.at[i * (i + 1) / 2 + j] = spring(stiffer);
		}
	}
	Eigen::Map<Eigen::Vector<float, GRASS_STRAIN_MASSES>>(section.mass) = masses_of(p_taper).cast<float>();
	return section;
}

} // namespace grass
