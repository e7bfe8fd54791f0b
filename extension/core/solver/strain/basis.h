// SPDX-License-Identifier: MIT
// The basis of a blade's strains, and what a species' section makes of it. docs/internals/solver.md, [Eq Q2] and [Eq Q7].
#pragma once

#include "core/solver/strain/strain.h"

namespace grass {

// Returns by how much joint p_joint is turned, radians, if number p_order of a kind is 1: the numbers in shaders/strain/basis.inc.
double joint_turn_of(int p_joint, int p_order);

// Returns what a section makes of the basis. p_taper, p_width_to_thickness: TAPER and WIDTH_TO_THICKNESS of solver_params.h. Takes some 50
// microseconds.
StrainSection<float> make_strain_section(double p_taper, double p_width_to_thickness);

} // namespace grass
