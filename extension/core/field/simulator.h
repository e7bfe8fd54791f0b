// SPDX-License-Identifier: MIT
// What a field's ticks need of the code that moves its blades: a backend, or a test.
#pragma once

#include "core/solver/solver_params.h"
#include "core/solver/step.h"

namespace grass {

class Simulator {
public:
	virtual ~Simulator() = default;

	// Whether step() can do its work: the driver may still compile the pass. Until then all blades stand at rest, and step() is not called.
	virtual bool can_simulate() { return true; }
	// Whether no pass stands in for one that is still being compiled, so that results no longer change with it.
	virtual bool is_complete() const { return true; }
	// Simulates the awake tiles for one tick. p_input is read before the call returns.
	virtual void step(const StepInput &p_input) = 0;
	// Runs in every tick, with or without a step: frees memory that nothing has needed for a while.
	virtual void tidy() {}
	// The newest that is known, without waiting; holds until the next call.
	virtual EnergyReport read_energy() = 0;
};

} // namespace grass
