#version 450
// SPDX-License-Identifier: MIT
// Chooses the tiles to draw and the detail of each: one thread a tile, in two dispatches of the same pass.
// Phase 0 counts the visible tiles of each level of detail; phase 1 gives each level its stretch of the
// MultiMesh's instance buffer, writes the instances there, and the indirect command of each surface.
#extension GL_GOOGLE_include_directive : require

#include "constants.inc"
#include "structs.inc"
#include "hash.inc"
#include "lod.inc"

layout(local_size_x = GRASS_CULL_GROUP) in;

layout(push_constant) uniform Phase {
	uvec4 phase; // x: 0 count, 1 write; y: tiles of the field; z: instances that the MultiMesh holds; w unused
};

layout(set = 0, binding = GRASS_CULL_VIEW, std430) readonly buffer ViewBuffer {
	GrassView view;
};
// Slot + 1 of each tile in the pool, 0 without one. Written by simulate; lives as long as the field.
layout(set = 0, binding = GRASS_CULL_TABLE, std430) readonly buffer TableBuffer {
	int table[];
};
// Tiles counted (first half) and written (second half) at each level. Cleared before phase 0.
layout(set = 0, binding = GRASS_CULL_COUNTS, std430) buffer CountBuffer {
	uint counts[2 * GRASS_LOD_LEVELS];
};
// The MultiMesh's own buffers: read by the renderer when it draws.
layout(set = 0, binding = GRASS_CULL_INSTANCES, std430) writeonly buffer InstanceBuffer {
	float instances[];
};
layout(set = 0, binding = GRASS_CULL_COMMANDS, std430) buffer CommandBuffer {
	uint commands[];
};

uint first_instance(int p_level) {
	uint first = 0u;
	for (int level = 0; level < p_level; level++) {
		first += counts[level];
	}
	return first;
}

void write_instance(uint p_instance, ivec2 p_tile, vec3 p_centre, float p_blades, int p_level, int p_slot) {
	float tint = 0.0;
	if (view.blades.y == float(GRASS_DEBUG_AWAKE)) {
		tint = p_slot == GRASS_NO_SLOT ? 0.0 : 1.0;
	} else if (view.blades.y == float(GRASS_DEBUG_LOD)) {
		tint = 2.0 + float(p_level);
	}
	int low = p_slot == GRASS_NO_SLOT ? GRASS_NO_SLOT : p_slot % GRASS_SLOT_HALF;
	int high = p_slot == GRASS_NO_SLOT ? 0 : p_slot / GRASS_SLOT_HALF;
	uint start = grass_tile_start(uint(p_tile.x), uint(p_tile.y), view.patch_seed.x);
	float values[GRASS_INSTANCE_FLOATS] = float[GRASS_INSTANCE_FLOATS](
			1.0, 0.0, 0.0, p_centre.x,
			0.0, 1.0, 0.0, p_centre.y,
			0.0, 0.0, 1.0, p_centre.z,
			float(p_tile.x), float(p_tile.y), p_blades, tint,
			float(start / uint(GRASS_START_STRIDE)), float(low), grass_tile_hash(uint(p_tile.x), uint(p_tile.y), view.patch_seed.x), float(high));
	uint at = p_instance * uint(GRASS_INSTANCE_FLOATS);
	for (int i = 0; i < GRASS_INSTANCE_FLOATS; i++) {
		instances[at + uint(i)] = values[i];
	}
}

void main() {
	// Fields of millions of tiles take more workgroups than fit in one row.
	uint tile_index = gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * uint(GRASS_CULL_GROUP);
	if (phase.x == 1u && tile_index < uint(GRASS_LOD_LEVELS)) {
		uint command = tile_index * uint(GRASS_COMMAND_WORDS);
		uint first = min(first_instance(int(tile_index)), phase.z);
		commands[command + 1u] = min(counts[tile_index], phase.z - first); // instanceCount
		commands[command + 4u] = first; // firstInstance
	}
	if (tile_index >= phase.y) {
		return;
	}
	ivec2 tiles = ivec2(view.field.xy);
	ivec2 tile = ivec2(int(tile_index) % tiles.x, int(tile_index) / tiles.x);
	vec2 place = (vec2(tile) + 0.5 - 0.5 * view.field.xy) * view.field.z;
	vec3 centre = vec3(place.x, 0.0, place.y);
	float side = 0.5 * view.field.z + view.blades.x;
	vec3 middle = centre + vec3(0.0, 0.5 * view.field.w, 0.0);
	if (!grass_tile_visible(view.planes, middle, vec3(side, 0.5 * view.field.w, side), view.eye.w)) {
		return;
	}
	float eye_distance = distance(view.eye.xyz, middle);
	float blades = grass_lod_blades(eye_distance, view.lod.x, view.lod.y);
	int level = grass_lod_level(blades, eye_distance, view.lod.z, view.lod.w);
	if (phase.x == 0u) {
		atomicAdd(counts[level], 1u);
		return;
	}
	uint instance = first_instance(level) + atomicAdd(counts[GRASS_LOD_LEVELS + level], 1u);
	if (instance < phase.z) {
		write_instance(instance, tile, centre, blades, level, table[tile_index] - 1);
	}
}
