// SPDX-License-Identifier: MIT
// The parameters that may change while a field runs: how its blades move, and when they sleep.
#pragma once

#include "core/lod/simulation_budget.h"
#include "core/solver/solver_params.h"
#include "core/tiles/tiles.h"

#include <vector>

namespace grass {

struct FieldParams {
	SolverParams solver;
	std::vector<SolverParams> species; // the same for each species; empty in a field without
	SleepMode sleep_mode = SleepMode::ENERGY;
	double sleep_delay = SLEEP_DELAY.initial; // seconds
	double sleep_motion = SLEEP_MOTION.initial; // mm
	double contact_distance = CONTACT_DISTANCE.initial; // metres
	SimulationDetail detail = SimulationDetail::SEEN;
	double budget = SIMULATION_BUDGET.initial; // milliseconds that a step may take; 0: no limit
	double settle_time = SETTLE_TIME.initial; // seconds

	// Returns the time in which a swing dies down, in seconds, for the species that swings longest.
	double calm_time() const;
	// [Eq Q11] Returns the speed of air that bends blades of the softest species, p_length metres long, as far as their strains can
	// describe, m/s.
	double alone_air(double p_length) const;
	// Returns the energy up to which the blades of every species are calm, J/kg.
	double calm_energy() const;
	// Returns the least energy, over the species, of a blade of which only the tip is p_distance metres from rest, J/kg.
	double energy_within(double p_distance) const;
};

} // namespace grass
