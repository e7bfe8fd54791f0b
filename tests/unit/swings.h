// SPDX-License-Identifier: MIT
// Free blades of 64 shapes that loads swing, whatever describes them: what tests that compare descriptions exchange.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace swings {

enum SwingKind { SHAKEN, TWISTED, LET_GO };
inline constexpr int KINDS = 3;
inline constexpr int SWING_PLACES = 15; // between root and tip; with 16 knots the knots
// Of all blades, in every sixtieth of a second: offsets of their places from rest, blade lengths.
using Swing = std::vector<Eigen::Vector3f>;

} // namespace swings
