// SPDX-License-Identifier: MIT
#include "core/field/field_params.h"

#include "core/base/layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace grass {

// Largest load of a blade that moves by its strains, over its length times the square of its frequency, 1/s. With 7 its tip is within 0.012
// lengths of a chain of 32 knots, with 15 it is off by 0.1; blades may be half as long as the longest.
constexpr double MOST_ALONE_LOAD = 4.0;

double FieldParams::calm_time() const {
	double time = species.empty() ? solver.calm_time() : 0.0;
	for (const SolverParams &own : species) {
		time = std::max(time, own.calm_time());
	}
	return time;
}

double FieldParams::alone_air(double p_length) const {
	double frequency = species.empty() ? solver.natural_frequency : NATURAL_FREQUENCY.maximum;
	for (const SolverParams &own : species) {
		frequency = std::min(frequency, own.natural_frequency);
	}
	const double swing = 2.0 * std::numbers::pi * frequency;
	return swing * std::sqrt(MOST_ALONE_LOAD * p_length / double(GRASS_FORCE_DRAG)); // the load is the drag times the square of the speed
}

double FieldParams::energy_within(double p_distance) const {
	double energy = species.empty() ? solver.energy_within(p_distance) : std::numeric_limits<double>::max();
	for (const SolverParams &own : species) {
		energy = std::min(energy, own.energy_within(p_distance));
	}
	return energy;
}

double FieldParams::calm_energy() const {
	return energy_within(1e-3 * sleep_motion);
}

} // namespace grass
