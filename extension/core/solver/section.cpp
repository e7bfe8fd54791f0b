// SPDX-License-Identifier: MIT
#include "core/solver/section.h"

#include "core/base/layout.h"

#include <array>

namespace grass {

namespace {

// Pieces of a blade of length 1.
constexpr int PIECES = 64;
constexpr double PIECE = 1.0 / PIECES;

// Returns the square of the first frequency of a cantilever whose stiffness and mass are 1 at the root, by inverse iteration from a
// parabola.
double first_swing(double p_taper) {
	constexpr int ROUNDS = 4; // each reduces the other modes to 1/39, and their effect on the frequency by its square
	std::array<double, PIECES> width, shape, next;
	for (int i = 0; i < PIECES; i++) {
		const double place = (i + 0.5) * PIECE;
		width[size_t(i)] = 1.0 - p_taper * place;
		shape[size_t(i)] = place * place;
	}
	double square = 0.0;
	for (int round = 0; round < ROUNDS; round++) {
		double shear = 0.0, moment = 0.0;
		std::array<double, PIECES> curvature;
		for (size_t i = PIECES; i-- > 0;) { // at the middle of each piece
			const double force = width[i] * shape[i] * PIECE;
			curvature[i] = (moment + 0.5 * PIECE * (shear + 0.25 * force)) / width[i];
			moment += PIECE * (shear + 0.5 * force);
			shear += force;
		}
		double slope = 0.0, place = 0.0, given = 0.0, found = 0.0;
		for (size_t i = 0; i < PIECES; i++) {
			const double turn = curvature[i] * PIECE;
			next[i] = place + 0.5 * PIECE * (slope + 0.25 * turn);
			place += PIECE * (slope + 0.5 * turn);
			slope += turn;
			given += width[i] * shape[i] * next[i];
			found += width[i] * next[i] * next[i];
		}
		square = given / found;
		for (size_t i = 0; i < PIECES; i++) {
			shape[i] = next[i] / place;
		}
	}
	return square;
}

// Returns the moment of an even acceleration at p_place of a blade of length 1.
double moment_at(double p_taper, double p_place) {
	const double beyond = 1.0 - p_place, width = 1.0 - p_taper * p_place;
	return beyond * beyond * (0.5 * width - p_taper * beyond / 3.0);
}

// Returns the sag of the tip from the stretch of blade that the first joint represents, divided by the sag from a moment of 1 in that
// joint.
double first_length(double p_taper) {
	constexpr double FIRST = GRASS_CLAMP_SHARE, LENGTH = FIRST + 0.5 * GRASS_SEGMENT_SHARE;
	double sum = 0.0;
	for (int i = 0; i < PIECES; i++) {
		const double place = (i + 0.5) * PIECE * LENGTH;
		sum += moment_at(p_taper, place) * (1.0 - place) / (1.0 - p_taper * place);
	}
	return sum * PIECE * LENGTH / (moment_at(p_taper, FIRST) * (1.0 - FIRST));
}

} // namespace

Section make_section(double p_taper) {
	static const double even_swing = first_swing(0.0), even_length = first_length(0.0);
	return { p_taper * GRASS_SEGMENT_SHARE, even_swing / first_swing(p_taper), even_length / first_length(p_taper) };
}

} // namespace grass
