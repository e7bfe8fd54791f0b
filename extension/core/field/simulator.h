// SPDX-License-Identifier: MIT
// The functions that a field's ticks need of the code that moves its blades: a backend, or a test.
#pragma once

#include "core/solver/solver_params.h"
#include "core/solver/step.h"
#include "core/tiles/tile_params.h"

#include <span>

namespace grass {

struct StepTime {
	uint64_t count = 0; // grows with each measured step
	double ms = 0.0; // of the last one
};

class Simulator {
public:
	virtual ~Simulator() = default;

	// Returns true once step() can work: the driver may still be compiling the pass. Until then all blades are at rest, and step() is not
	// called.
	virtual bool can_simulate() { return true; }
	// Returns true if no pass stands in for one that is still being compiled: then results no longer depend on that.
	virtual bool is_complete() const { return true; }
	// Returns the newest known time of a step, and how many were measured so far: none unless set_measure_time() says so, and none on a
	// device without timestamps.
	virtual StepTime read_step_time() { return {}; }
	// Simulates the awake tiles for one tick. p_input is read before the call returns.
	virtual void step(const StepInput &p_input) = 0;
	// Returns true once join() can work; until then all blades of awake tiles are simulated.
	virtual bool can_join() { return true; }
	// Gives the blades that are drawn from now on the poses of the simulated ones beside them, [Eq 49]. p_slots: of TileManager::widen();
	// p_step: the last one.
	virtual void join(std::span<const GrassSlot> p_slots, const GrassStep &p_step) = 0;
	// Changes the number of slots, none at first. p_moves: tiles that get another slot or none; the others keep theirs, and all keep their
	// blades.
	virtual void resize_pool(int p_slots, std::span<const SlotMove> p_moves) = 0;
	// Returns how many slots resize_pool() can make within a tick without a visible pause.
	virtual int get_slots_at_once() const { return TileParams::MAX_POOL_SIZE; }
	// Prepares memory for p_slots slots beside the frames; 0: stops. Must be called in each tick. Returns true once resize_pool() can make
	// exactly that many without a pause.
	virtual bool prepare_pool(int p_slots) { return p_slots > 0; }
	// Returns the newest known report without waiting; it is valid until the next call.
	virtual EnergyReport read_energy() = 0;
};

} // namespace grass
