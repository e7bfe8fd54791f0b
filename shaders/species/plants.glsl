#version 450
// SPDX-License-Identifier: MIT
// Chooses the plants of one species that are drawn with a mesh, near the cameras, and writes an instance for each. One workgroup for each
// tile of the squares around the cameras, one thread a blade. Reads the same buffers as cull.glsl, and runs after it. Twin of
// core/lod/plant_cull.h.
#pragma variant GRASS_MAP // for fields with a map, on which species may be painted
#extension GL_GOOGLE_include_directive : require

#include "base/constants.inc"
#include "base/structs.inc"
#include "base/hash.inc"
#include "base/rows.inc"
#include "lod/levels.inc"
#include "lod/lod.inc"
#include "species/constants.inc"
#include "species/stages.inc"
#include "species/species.inc"

layout(local_size_x = GRASS_BLADES_PER_TILE) in;

layout(push_constant) uniform Phase {
	// x: GRASS_PLANTS_*; y: the species + GRASS_MAX_SPECIES * GRASS_PLANT_MESH or GRASS_PLANT_IMPOSTOR; z: plants that the MultiMesh holds;
	// w: surfaces of its mesh.
	ivec4 phase;
	vec4 box; // xy: tiles around a camera along x, z; z: up to which distance plants are drawn so, metres; w: from which on
	vec4 map; // xy: map_origin; z: metres, length of a mean plant; w: area that one shows to an eye beside it, divided by a tile's
};

layout(set = 0, binding = GRASS_PLANTS_VIEW, std430) readonly buffer ViewBuffer {
	GrassView view;
};
layout(set = 0, binding = GRASS_PLANTS_CAMERAS, std430) readonly buffer CameraBuffer {
	GrassCamera cameras[];
};
layout(set = 0, binding = GRASS_PLANTS_TABLE, std430) readonly buffer TableBuffer {
	int table[];
};
// As in cull.glsl.
struct Cover {
	float low, high, grown, cut, slope;
};
layout(set = 0, binding = GRASS_PLANTS_COVER, std430) readonly buffer CoverBuffer {
	Cover covers[];
};
layout(set = 0, binding = GRASS_PLANTS_PATCH) uniform sampler2D patch_knots;
// Written by the CPU, as long as the field: PlantPasses::Mix.
layout(set = 0, binding = GRASS_PLANTS_MIX, std430) readonly buffer MixBuffer {
	ivec4 species_mix[GRASS_MAX_SPECIES];
	ivec4 species_origin[GRASS_MAX_SPECIES];
	int species_stems[GRASS_MAX_SPECIES];
	int species_fray[GRASS_MAX_SPECIES];
	int species_count;
	int species_texel;
};
// Plants chosen, by phase.y. Cleared before the first phase.
layout(set = 0, binding = GRASS_PLANTS_COUNTS, std430) buffer CountBuffer {
	uint chosen[GRASS_MAX_SPECIES * GRASS_PLANT_STAGES];
};
// The MultiMesh's own buffers.
layout(set = 0, binding = GRASS_PLANTS_INSTANCES, std430) writeonly buffer InstanceBuffer {
	float instances[];
};
layout(set = 0, binding = GRASS_PLANTS_COMMANDS, std430) buffer CommandBuffer {
	uint commands[];
};

#define GRASS_PLANTS
#define tiles view.field.xy
#define tile_size view.field.z
#ifdef GRASS_MAP
layout(set = 0, binding = GRASS_PLANTS_PAGES) uniform sampler2D map_pages;
layout(set = 0, binding = GRASS_PLANTS_PAINTED) uniform sampler2DArray map_species;
#define map_origin map.xy
#include "map/painted.inc"
#endif

ivec2 patch_texel(int p_blade, int p_knot) {
	return ivec2(GRASS_PATCH_BLADES_PER_ROW * p_knot + p_blade % GRASS_PATCH_BLADES_PER_ROW, p_blade / GRASS_PATCH_BLADES_PER_ROW);
}

#include "lod/casts.inc"
#include "species/choice.inc"

shared uint plants_of_tile; // of the species

// Returns the first tile of the square around a camera. The square is inside of the field.
ivec2 corner_of(uint p_camera) {
	vec2 place = cameras[p_camera].eye.xz / tile_size + 0.5 * tiles;
	return clamp(ivec2(floor(place)) - ivec2(box.xy) / 2, ivec2(0), ivec2(tiles) - ivec2(box.xy));
}

bool is_in_square(uint p_camera, ivec2 p_tile) {
	ivec2 from = p_tile - corner_of(p_camera);
	return all(greaterThanEqual(from, ivec2(0))) && all(lessThan(from, ivec2(box.xy)));
}

// Returns whether a camera sees the tile, or its shadow, with plants.
bool is_wanted(vec3 p_middle, vec3 p_half) {
	for (uint i = 0u; i < view.counts.x; i++) {
		float away = distance(cameras[i].eye.xyz, p_middle) - length(p_half);
		bool is_seen = grass_tile_visible(cameras[i].planes, p_middle, p_half, 0.0, vec3(0.0));
		if (away < box.z && (is_seen || (away < view.shadow.y && casts_into(cameras[i], p_middle, p_half)))) {
			return true;
		}
	}
	return false;
}

bool is_near(vec3 p_root, float p_low, float p_high) {
	for (uint i = 0u; i < view.counts.x; i++) {
		vec3 eye = cameras[i].eye.xyz;
		float away = distance(eye, vec3(p_root.x, clamp(eye.y, p_low, p_high), p_root.z));
		if (away >= box.w && away < box.z) {
			return true;
		}
	}
	return false;
}

// [Eq L13] Returns the share of the tile's plants that is drawn. p_plants: of the species, on the tile; p_middle: of its box.
float share_of(float p_plants, Cover p_cover, vec3 p_middle) {
	float height = min(map.z, p_cover.cut);
	float cover = p_plants * p_cover.grown * map.w * height / map.z;
	float share = 0.0;
	for (uint i = 0u; i < view.counts.x; i++) {
		vec3 to_eye = cameras[i].eye.xyz - p_middle;
		bool hides = cameras[i].pixel.y > 0.0 && view.lod.z > 0.0; // an orthogonal camera has no eye
		share = max(share, hides ? grass_lod_in_sight(0.5 * cover, length(to_eye.xz), to_eye.y, height, p_cover.slope) : 1.0);
	}
	return grass_lod_plants(share, cover, view.shadow.y > 0.0 ? 1.0 : 0.0);
}

void write_plant(ivec2 p_tile, int p_index, float p_hash, uint p_start, float p_presence) {
	uint place = atomicAdd(chosen[phase.y], 1u);
	if (place >= uint(phase.z)) {
		return;
	}
	int slot = table[p_index] - 1;
	int low = slot == GRASS_NO_SLOT ? GRASS_NO_SLOT : slot % GRASS_SLOT_HALF;
	int high = slot == GRASS_NO_SLOT ? 0 : slot / GRASS_SLOT_HALF;
	float values[GRASS_INSTANCE_FLOATS] = float[GRASS_INSTANCE_FLOATS](
			1.0, 0.0, 0.0, 0.0, // the shader moves it to its tile's place
			0.0, 1.0, 0.0, 0.0,
			0.0, 0.0, 1.0, 0.0,
			float(p_tile.x), float(p_tile.y), float(gl_LocalInvocationID.x), p_presence,
			float(p_start / uint(GRASS_START_STRIDE)), float(low), p_hash, float(high));
	for (int i = 0; i < GRASS_INSTANCE_FLOATS; i++) {
		instances[place * uint(GRASS_INSTANCE_FLOATS) + uint(i)] = values[i];
	}
}

void choose() {
	uint side = uint(box.x), in_square = side * uint(box.y);
	uint group = gl_WorkGroupID.x + gl_WorkGroupID.y * grass_row_width(in_square * view.counts.x);
	uint camera = group / in_square;
	if (camera >= view.counts.x) {
		return; // the last row has more workgroups than there are tiles left
	}
	ivec2 tile = corner_of(camera) + ivec2(int(group % in_square % side), int(group % in_square / side));
	for (uint i = 0u; i < camera; i++) {
		if (is_in_square(i, tile)) {
			return; // that camera's square draws the tile
		}
	}
	int index = tile.y * int(tiles.x) + tile.x;
	Cover cover = Cover(0.0, 0.0, 1.0, GRASS_UNCUT, 0.0);
	if (view.counts.w == 1u) {
		cover = covers[index];
	}
	vec2 place = (vec2(tile) + 0.5 - 0.5 * tiles) * tile_size;
	float reach = 0.5 * tile_size + view.blades.x;
	vec3 half_extents = vec3(reach, 0.5 * (view.field.w + cover.high - cover.low), reach);
	vec3 middle = vec3(place.x, cover.low + half_extents.y, place.y);
	if (cover.low > cover.high || !is_wanted(middle, half_extents)) {
		return;
	}
	float hash = grass_tile_hash(uint(tile.x), uint(tile.y), view.counts.z);
	uint start = grass_tile_start(uint(tile.x), uint(tile.y), view.counts.z);
	uint blade = gl_LocalInvocationID.x;
	vec2 root = texelFetch(patch_knots, patch_texel(int(start + blade), 0), 0).xy;
	uint bits = grass_tile_bits(uint(tile.x), uint(tile.y), uint(hash * 2048.0));
	bool is_painted;
	float apart;
	int species = choose_species(tile, root, bits, blade, int(start), is_painted, apart);
	if (blade == 0u) {
		plants_of_tile = 0u;
	}
	barrier();
	int wanted = phase.y % GRASS_MAX_SPECIES;
	if (species == wanted) {
		atomicAdd(plants_of_tile, 1u);
	}
	barrier();
	float share = share_of(float(plants_of_tile), cover, middle);
	float presence = species == wanted ? grass_lod_plant(int(blade), species_stems[species], share, hash) : 0.0;
	if (presence <= 0.0) {
		return;
	}
	vec4 own = texelFetch(patch_knots, patch_texel(int(start + blade) + GRASS_PATCH_BLADES * species, 0), 0);
	vec3 centre = vec3(place.x, 0.0, place.y);
	if (own.w > 0.0 && is_near(centre + vec3(own.x - 0.5, 0.0, own.y - 0.5) * tile_size, cover.low, cover.high)) {
		write_plant(tile, index, hash, start, presence);
	}
}

void main() {
	if (phase.x == GRASS_PLANTS_CHOOSE) {
		choose();
	} else if (int(gl_LocalInvocationID.x) < phase.w) {
		uint command = gl_LocalInvocationID.x * uint(GRASS_COMMAND_WORDS);
		commands[command + 1u] = min(chosen[phase.y], uint(phase.z)); // instanceCount
		commands[command + 4u] = 0u; // firstInstance
	}
}
