// SPDX-License-Identifier: MIT
// What may change while a field goes on: how its blades move, and when they sleep.
#pragma once

#include "core/solver/solver_params.h"
#include "core/tiles/tiles.h"

#include <vector>

namespace grass {

struct FieldParams {
	SolverParams solver;
	std::vector<SolverParams> species; // the same for each species; none in a field without
	SleepMode sleep_mode = SleepMode::ENERGY;
	double sleep_delay = SLEEP_DELAY.initial; // seconds
	double sleep_motion = SLEEP_MOTION.initial; // mm
	double settle_time = SETTLE_TIME.initial; // seconds

	// Of the species that swings longest, seconds.
	double calm_time() const;
	// Up to here the blades of every species are calm, J/kg.
	double calm_energy() const;
};

} // namespace grass
