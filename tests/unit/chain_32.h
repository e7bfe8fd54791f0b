// SPDX-License-Identifier: MIT
// The solver with 32 knots, beside that with 16.
#pragma once

#include "rolled.h"
#include "swings.h"

namespace grass_32::test {

// roll_through() of rolled_blades.h.
std::vector<rolled::Look> roll_32_through(const rolled::Roll &p_roll, const rolled::Stepping &p_stepping, double p_looks);
// swing_chains() of swinging_blades.h.
swings::Swing swing_32_chains(swings::SwingKind p_kind, double p_rate);

} // namespace grass_32::test
