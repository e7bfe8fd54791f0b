// SPDX-License-Identifier: MIT
// Blades that join the simulated ones of their tile, since a camera has come nearer. Twin of shaders/solver/join.glsl.
#pragma once

#include "core/solver/tile_state.h"

namespace grass {

// [Eq 49] Gives the blades from p_from to p_to the pose and the motion of the nearest of the first p_from blades: its offsets from rest, as
// shares of the length. A blade whose neighbour is at rest is at rest, bit for bit.
void join_blades(TileState &r_state, int p_from, int p_to);

} // namespace grass
