// SPDX-License-Identifier: MIT
// The patches of fields on walls and ceilings: made on threads, and shared by all fields that hang alike. Main thread only.
#pragma once

#include "core/blades/patch.h"
#include "core/solver/solver_params.h"

#include <Eigen/Core>

#include <memory>

namespace grass {

// Returns whether find_hung() returns this patch at once. If not, a thread begins to make it.
bool prepare_hung(const std::shared_ptr<const Patch> &p_patch, const SolverParams &p_solver, const Eigen::Vector3d &p_pull, int p_stems);
// Returns the same patch for the same arguments as long as somebody uses it: see hang_patch().
std::shared_ptr<const Patch> find_hung(
		const std::shared_ptr<const Patch> &p_patch, const SolverParams &p_solver, const Eigen::Vector3d &p_pull, int p_stems);

} // namespace grass
