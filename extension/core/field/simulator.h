// SPDX-License-Identifier: MIT
// What a field's ticks need from whatever moves its blades: a backend, or a test.
#pragma once

#include "core/solver/solver_params.h"
#include "core/solver/step.h"

namespace grass {

class Simulator {
public:
	virtual ~Simulator() = default;

	// Whether step() can do its work: the driver may still compile the pass. Until then all blades stand at rest, and nobody calls step().
	virtual bool can_simulate() { return true; }
	// The method to simulate by from now on: p_wanted, as soon as all of its passes are there.
	virtual Method choose_method(Method p_wanted) { return p_wanted; }
	// Whether blades are simulated as they always will be: no pass is being compiled that another one stands in for.
	virtual bool is_complete() const { return true; }
	// Simulates the awake tiles for one tick. p_input is read before the call returns.
	virtual void step(const StepInput &p_input) = 0;
	// In every tick, whether there is a step or not: gives back memory that nothing has needed for a while.
	virtual void tidy() {}
	// The newest that is known, without waiting; holds until the next call.
	virtual EnergyReport read_energy() = 0;
};

} // namespace grass
