// SPDX-License-Identifier: MIT
// The simulation on the CPU: the pool's state and the step of the awake tiles, from the same records. Twin of
// shaders/solver/simulate.glsl. It is the backend in headless and Compatibility, and the reference in tests.
#pragma once

#include "core/base/parallel_for.h"
#include "core/blades/patch.h"
#include "core/solver/step.h"
#include "core/solver/strain/sections.h"
#include "core/solver/tile_step.h"

#include <Eigen/Core>

#include <memory>
#include <span>
#include <vector>

namespace grass {

class CpuPool {
public:
	// Makes a pool of the patch's blades. Memory is allocated when a slot is first used, and freed with the slot.
	explicit CpuPool(std::shared_ptr<const Patch> p_patch, int p_slots = 0);
	~CpuPool();

	// Sets other blades. Tiles that are awake must wake again.
	void set_patch(std::shared_ptr<const Patch> p_patch) { _patch = std::move(p_patch); }
	// Sets another number of slots. Awake tiles go on where p_moves says.
	void resize(int p_slots, std::span<const SlotMove> p_moves);
	int get_size() const { return int(_slots.size()); } // slots

	// Takes one step of every tile in p_input; the result does not depend on p_parallel_for. Ignores records of slots that do not exist and
	// of blades beyond the patch. p_step: one of those in tile_step.h; step_scalar_double() is the reference: slow, with its state stored
	// as float.
	void step(const StepInput &p_input, const ParallelFor &p_parallel_for = serial_for, TileStep p_step = step_lanes);

	// Gives the blades of a slot that join or follow the simulated ones their poses, [Eq 49]. p_slot: a record of TileManager::widen() or
	// get_followers(). Ignores unknown slots.
	void join(const GrassSlot &p_slot);

	// Returns the knots of a blade, in blade space, metres: GRASS_KNOTS points. Empty if the slot was never awake or has no such blade.
	std::vector<Eigen::Vector3f> get_knots(int p_slot, int p_blade) const;
	// Writes the slot's row of the pool texture: 4 halves for each knot of each blade; xyz is its offset from rest (blade space, metres),
	// w is its twist; w of the first texel, whose offset is zero, is the number of blades that the last step simulated. Zeros if the slot
	// was never awake.
	// r_texels: GRASS_POOL_BLADES_PER_ROW * GRASS_KNOTS * 4 values.
	void pack_row(int p_slot, std::span<uint16_t> r_texels) const;
	// [Eq 19] Returns the energy of every slot's liveliest blade, J/kg; 0 if the slot was never awake.
	std::span<const float> get_energy() const { return _energy; }
	// [Eq M5] Returns, for every slot, the mean offset of its blades' tips from rest, as shares of the blades' lengths.
	std::span<const Eigen::Vector3f> get_bends() const { return _bends; }

	// Returns a hash of where the blades of all slots are, bit for bit.
	uint64_t hash() const;
	int64_t get_simulated_blades() const { return _simulated_blades; } // since construction
	int64_t get_strain_blades() const { return _strain_blades; } // likewise: those that moved by their strains
	int64_t get_growth_looks() const { return _growth_looks; } // likewise: at records of StepInput::growth, to find those of the slots
	int64_t get_memory_usage() const; // bytes
	static int64_t find_slot_bytes(); // of a slot that is used

	// Replaces a blade's state, for tests: GRASS_KNOTS points each, the clamped ones ignored.
	void set_knots(int p_slot, int p_blade, std::span<const Eigen::Vector3f> p_knots, std::span<const Eigen::Vector3f> p_before);

private:
	struct AwakeSlot {
		const GrassSlot &record;
		const SlotGrowth *growth; // null: its blades grow as before
	};

	void find_rest(const GrassSlot &p_slot, const GrassStep &p_step, const SlotGrowth *p_growth);
	void wake(const GrassSlot &p_slot);
	void keep_shapes(const GrassSlot &p_slot);
	void step_slot(const AwakeSlot &p_awake, const StepInput &p_input, std::span<const GrassStep> p_steps, TileStep p_step);

	std::shared_ptr<const Patch> _patch;
	std::vector<std::unique_ptr<TileState>> _slots;
	std::vector<float> _energy;
	std::vector<Eigen::Vector3f> _bends;
	int64_t _simulated_blades = 0, _strain_blades = 0, _growth_looks = 0;
	StrainSections _sections;
};

} // namespace grass
