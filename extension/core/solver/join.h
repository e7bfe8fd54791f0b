// SPDX-License-Identifier: MIT
// Blades that take the pose of simulated ones of their tile: those that join them since a camera has come nearer, and those that follow
// them in each step. Twin of shaders/solver/join.glsl.
#pragma once

#include "core/solver/tile_state.h"

namespace grass {

// Which blades of a tile get the pose of others.
struct Joining {
	int sources; // the first blades, which are simulated
	int begin, end; // those that get a pose
	float share = 1.0f; // of the way there, 0..1
};

// [Eq 49] Gives blades the pose and the motion of the nearest source: its offsets from rest, as shares of the length. A blade whose
// neighbour is at rest is at rest, bit for bit. [Eq 50] With a share below 1 each moves with its neighbour, and that share of the way from
// its own pose to the neighbour's.
void join_blades(TileState &r_state, const Joining &p_joining);

} // namespace grass
