// SPDX-License-Identifier: MIT
// How held keys and turns of the wheel change a brush.
#pragma once

#include "core/base/tunable.h"
#include "core/paint/brush.h"

namespace grass {

// The brush that undoes what p_brush does: paint erases, cut regrows, and a tool that brings a channel to a target brings
// it to its unpainted value.
Brush opposite_of(const Brush &p_brush);

// The brush that evens out what p_brush changes. Species cannot be averaged: they are planted as before.
Brush smoothing_of(const Brush &p_brush);

// A value after some notches of a wheel or strokes of a key, up or down: radii grow and shrink by a share of themselves,
// other numbers by five of the inspector's steps. Stays within limits, on whole steps.
double nudged(const Tunable &p_tunable, double p_value, int p_notches);

} // namespace grass
