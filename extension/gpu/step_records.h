// SPDX-License-Identifier: MIT
// The records of one simulation step, copied on the main thread for the render thread.
#pragma once

#include "core/solver/slot_passes.h"
#include "gpu/field_passes.h"

namespace grass {

struct StepRecords {
	uint64_t number;
	std::vector<GrassSlot> slots;
	std::vector<GrassCollider> colliders;
	std::vector<uint32_t> collider_list;
	std::vector<Eigen::Vector4f> planes;
	std::vector<SlotGrowth> growth;
	std::vector<GrassStep> species;
	std::vector<GrassForce> forces;
	std::vector<GrassSlot> followers;
	GrassStep step;
	SlotPasses passes; // of the slots
	double copy_ms; // CPU time of this copy

	// Copies a step. p_energies: see choose_passes(). p_kind: of the field.
	StepRecords(const StepInput &p_input, std::span<const float> p_energies, const PassKind &p_kind);

	uint32_t count_groups() const; // workgroups of all passes
	int64_t count_blades() const; // that the step simulates
};

} // namespace grass
