// SPDX-License-Identifier: MIT
// Tussocks: blades whose roots gather around common places, with bare ground between. The roots move within the patch, so drawing and
// simulation read them like all others.
#pragma once

#include "core/blades/patch.h"

namespace grass {

// Moves roots of p_even's 16,384 blades, which begin at blade p_first of r_patch. p_even: where they would be without tussocks.
void gather_roots(Patch &r_patch, int p_first, const Patch &p_even, const Tussocks &p_tussocks);

} // namespace grass
