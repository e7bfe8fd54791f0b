// SPDX-License-Identifier: MIT
// Keeps the steps of a field within a time, by simulating blades more coarsely than they are drawn
// (docs/history/0090-a-budget-for-the-simulation.md).
#pragma once

#include "core/base/tunable.h"

#include <array>
#include <cstddef>

namespace grass {

// The time that a step may take on the device. 0: as long as it needs. Below a tenth of what a step takes without it: far blades move in
// groups.
inline constexpr Tunable SIMULATION_BUDGET{ "simulation_budget", "ms", 0.0, 50.0, 0.01, 0.0 };

class SimulationBudget {
public:
	// The coarsest. More would change little: four of a far tile's blades are simulated anyway.
	static constexpr float MOST = 8.0f;
	// The largest share by which the coarseness changes in a step. Larger: many tiles change at once which of their blades are simulated.
	static constexpr float FASTEST = 0.02f;
	// Steps that take between AIM and the budget, or as little less than AIM, change nothing.
	static constexpr double AIM = 0.9, BAND = 0.1;
	// The median of this many times counts, so that single slow frames do not.
	static constexpr size_t TIMES = 5;

	// Must be called after each step. p_budget: milliseconds; not positive: none, and the coarseness goes back to 1. p_time: milliseconds
	// of a step that was measured since the last call; not positive or not finite: none was, and nothing changes.
	void advance(double p_budget, double p_time);
	float get_coarseness() const { return _coarseness; } // 1 .. MOST; 1: every drawn blade is simulated
	void reset() { *this = SimulationBudget(); }

private:
	double median() const;

	float _coarseness = 1.0f;
	std::array<double, TIMES> _times{}; // the last ones, in a ring
	size_t _count = 0;
};

} // namespace grass
