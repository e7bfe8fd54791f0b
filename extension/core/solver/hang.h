// SPDX-License-Identifier: MIT
// [Eq B7] The blades of a field that is turned on its side or upside down. A patch shows blades as gravity bends them on level ground; on a
// wall or a ceiling gravity pulls another way.
#pragma once

#include "core/blades/patch.h"
#include "core/solver/solver_params.h"

#include <Eigen/Core>

#include <atomic>

namespace grass {

// A field that is tilted less counts as upright, so that a deck may roll. Degrees.
inline constexpr double UPRIGHT_TILT = 20.0;

// Returns gravity in a field's axes, less the gravity of level ground, m/s^2. Zero for an upright field. Rounded, so that fields on nearly
// parallel walls share their blades. p_turn: from the field's axes to the world's, orthonormal.
Eigen::Vector3d find_pull(const Eigen::Matrix3d &p_turn);

// Returns the blades of p_patch, one species, as they come to rest in the solver if p_pull acts on them as well. p_solver: the species'.
// p_stems: how many of its blades share a root; join_patches() will turn them. p_stop: once it is true, set by any thread, the blades not
// done yet stay as they are.
Patch hang_patch(const Patch &p_patch, const SolverParams &p_solver, const Eigen::Vector3d &p_pull, int p_stems = 1,
		const std::atomic<bool> *p_stop = nullptr);

} // namespace grass
