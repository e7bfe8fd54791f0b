#version 450
// SPDX-License-Identifier: MIT
// Gathers the knots of a few blades, so that the CPU reads back no more than those. One thread a blade.
#extension GL_GOOGLE_include_directive : require

#include "base/constants.inc"

layout(local_size_x = GRASS_GATHER_GROUP) in;

layout(push_constant) uniform Count {
	uvec4 count; // x: blades; yzw unused
};

// Blades by slot: GRASS_BLADES_PER_TILE times the slot, and the blade's place in the tile. Written by the CPU when others are requested.
layout(set = 0, binding = GRASS_GATHER_BLADES, std430) readonly buffer BladeBuffer {
	uint blades[];
};
// The pool, as simulate keeps it.
layout(set = 0, binding = GRASS_GATHER_KNOTS, std430) readonly buffer KnotBuffer {
	float pool_knots[];
};
layout(set = 0, binding = GRASS_GATHER_HALVES, std430) readonly buffer HalfBuffer {
	uint pool_halves[];
};
// [blade][free knot][component]: read by the CPU.
layout(set = 0, binding = GRASS_GATHER_FOUND, std430) writeonly buffer FoundBuffer {
	float found[];
};

void main() {
	uint index = gl_GlobalInvocationID.x;
	if (index >= count.x) {
		return;
	}
	uint slot = blades[index] / uint(GRASS_BLADES_PER_TILE);
	uint blade = blades[index] % uint(GRASS_BLADES_PER_TILE);
	uint numbers = uint(3 * GRASS_FREE_KNOTS);
	uint from = (2u * slot + (pool_halves[slot] & 1u)) * numbers * uint(GRASS_BLADES_PER_TILE) + blade;
	for (uint knot = 0u; knot < uint(GRASS_FREE_KNOTS); knot++) {
		for (uint component = 0u; component < 3u; component++) {
			found[index * numbers + knot * 3u + component] =
					pool_knots[from + (component * uint(GRASS_FREE_KNOTS) + knot) * uint(GRASS_BLADES_PER_TILE)];
		}
	}
}
