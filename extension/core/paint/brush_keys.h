// SPDX-License-Identifier: MIT
// How held keys and the mouse wheel change a brush.
#pragma once

#include "core/base/tunable.h"
#include "core/paint/brush.h"

namespace grass {

// Returns the brush that undoes what p_brush does: paint becomes erase, cut becomes regrow, and a tool that moves a channel to a target
// moves it to its unpainted value.
Brush opposite_of(const Brush &p_brush);

// Returns the brush that smooths what p_brush changes. Species cannot be averaged, so they are planted as before.
Brush smoothing_of(const Brush &p_brush);

// Returns a value after some notches of the wheel or presses of a key, up or down: radii grow and shrink by a share of themselves, other
// numbers by five of the inspector's steps. The result is within limits and on whole steps.
double nudged(const Tunable &p_tunable, double p_value, int p_notches);

} // namespace grass
