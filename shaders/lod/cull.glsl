#version 450
// SPDX-License-Identifier: MIT
// Chooses the tiles to draw and to cast shadows, and the detail of each: one thread a tile, in two dispatches of the same
// pass. GRASS_CULL_COUNT counts the tiles of each level; GRASS_CULL_WRITE gives each level its stretch of the list of drawn tiles, and
// writes the tiles there and the number of instances of each surface. A tile that one camera sees is drawn for all of them, as finely as
// the nearest one needs it. Twin of core/lod/cull.h.
// Fields of more tiles than a MultiMesh has room for take two more dispatches in between, which do nothing unless so many
// are chosen: GRASS_CULL_TURNS counts the tiles of each turn; GRASS_CULL_FIT (one workgroup) decides which ranks have room.
// GRASS_CULL_BEGIN puts all instances of new MultiMeshes at the field's place, where they stay.
#extension GL_GOOGLE_include_directive : require

#include "base/constants.inc"
#include "base/structs.inc"
#include "base/hash.inc"
#include "base/rows.inc"

// The tables of levels.inc, which each thread looks through: segments in the lowest bits, then blades. NVIDIA's compiler may give each
// thread a copy of a constant array, in memory. One more than it uses, see group_tiles.
shared uint level_meshes[GRASS_ALL_LEVELS + 1];
#define LEVEL_SEGMENT_BITS 4
#define GRASS_SEGMENTS_AT(m_level) int(level_meshes[m_level] & ((1u << LEVEL_SEGMENT_BITS) - 1u))
#define GRASS_BLADES_AT(m_level) int(level_meshes[m_level] >> LEVEL_SEGMENT_BITS)
#include "lod/lod.inc"

layout(local_size_x = GRASS_CULL_GROUP) in;

layout(push_constant) uniform Phase {
	uvec4 phase; // x: GRASS_CULL_*; y: threads, one a tile or an instance; z, w: instances of the MultiMeshes of picture and shadows
};

layout(set = 0, binding = GRASS_CULL_VIEW, std430) readonly buffer ViewBuffer {
	GrassView view;
};
layout(set = 0, binding = GRASS_CULL_CAMERAS, std430) readonly buffer CameraBuffer {
	GrassCamera cameras[];
};
// Slot + 1 of each tile in the pool, 0 without one. Written by simulate; lives as long as the field.
layout(set = 0, binding = GRASS_CULL_TABLE, std430) readonly buffer TableBuffer {
	int table[];
};
// Counts: tiles counted and tiles written at each level; blades, and tiles without room, in picture and shadows. If there are such tiles:
// how many ranks have room, and the tiles of each level and turn. Cleared before the first phase.
layout(set = 0, binding = GRASS_CULL_COUNTS, std430) buffer CountBuffer {
	uint counted[GRASS_ALL_LEVELS];
	uint written[GRASS_ALL_LEVELS];
	uint blades_written[2];
	uint left_out[2];
	uint ranks[2];
	uint turns[GRASS_ALL_LEVELS * GRASS_TURNS];
};
// The list of drawn tiles, see GRASS_PLACES_PER_ROW: read by the blade shader as `drawn_tiles`. Every level draws its instances from 0 on,
// since Direct3D 12 always numbers them so, for any indirect command; the list's first row holds the place at which a level begins.
layout(set = 0, binding = GRASS_CULL_DRAWN, rgba32f) writeonly uniform image2D drawn_tiles;
// The MultiMeshes' own buffers: read by the renderer when it draws.
layout(set = 0, binding = GRASS_CULL_INSTANCES, std430) writeonly buffer InstanceBuffer {
	float instances[];
};
layout(set = 0, binding = GRASS_CULL_COMMANDS, std430) buffer CommandBuffer {
	uint commands[];
};
layout(set = 0, binding = GRASS_CULL_SHADOW_INSTANCES, std430) writeonly buffer ShadowInstanceBuffer {
	float shadow_instances[];
};
layout(set = 0, binding = GRASS_CULL_SHADOW_COMMANDS, std430) buffer ShadowCommandBuffer {
	uint shadow_commands[];
};

// The map's data of a tile: TileCover::Tile in core/map/tile_cover.h.
struct Cover {
	float low, high; // of the ground, metres; low > high where nothing grows
	float grown, cut, slope;
};
// Written by the CPU when the map changes; only fields with a map have it.
layout(set = 0, binding = GRASS_CULL_COVER, std430) readonly buffer CoverBuffer {
	Cover covers[];
};

// The workgroup's own tiles of each level, where its stretch of the level begins, and its blades. One atomic a level and
// workgroup on the shared counters instead of one a tile.
// Each has one element more than it uses: if a buffer contains an array of the same size, glslang gives a shared array its layout, which is
// not allowed.
shared uint group_tiles[GRASS_ALL_LEVELS + 1];
shared uint group_first[GRASS_ALL_LEVELS + 1];
shared uint group_blades[2 + 1];
// A thread's tile.
struct Tile {
	uint index;
	bool exists; // the last workgroup has more threads than there are tiles left
	ivec2 at; // column along x, row along z
	vec3 centre; // at the field's height, field space
	float hash;
};
// The detail that a tile needs (core/lod/lod.h: LodNeed).
struct Need {
	float blades, segments, covering;
};
// How a tile is drawn, or casts its shadow.
struct Choice {
	int level; // of GRASS_ALL_LEVELS; -1: not at all
	float blades; // below one: the share of similar tiles that show a blade
	float covering; // number of blades that would cover as much as all
	float morph;
	uint place; // among the workgroup's tiles of the level
};

#include "lod/room.inc"

// Returns the number of this thread. Fields of millions of tiles take more workgroups than fit in one row.
uint find_thread() {
	uint groups = (phase.y - 1u) / uint(GRASS_CULL_GROUP) + 1u;
	return gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * grass_row_width(groups) * uint(GRASS_CULL_GROUP);
}

Tile find_tile() {
	Tile tile;
	tile.index = find_thread();
	tile.exists = tile.index < phase.y;
	ivec2 tiles = ivec2(view.field.xy);
	tile.at = ivec2(int(tile.index) % tiles.x, int(tile.index) / tiles.x);
	vec2 place = (vec2(tile.at) + 0.5 - 0.5 * view.field.xy) * view.field.z;
	tile.centre = vec3(place.x, 0.0, place.y);
	tile.hash = grass_tile_hash(uint(tile.at.x), uint(tile.at.y), view.counts.z);
	return tile;
}

// Adds what one camera needs in a tile. p_least: the least width of a blade; p_error: how far it may be from its curve; p_near: distance of
// the near plane; all in metres. p_in_sight: grass_lod_in_sight().
void add_need(inout Need r_need, float p_distance, float p_least, float p_error, float p_near, float p_in_sight) {
	float by_distance = grass_lod_blades(p_distance, p_near, view.lod.x);
	float by_width = grass_lod_blades_of_width(view.blades.y, p_least);
	float all = min(by_distance, by_width);
	r_need.blades = max(r_need.blades, all * p_in_sight);
	r_need.segments = max(r_need.segments, grass_lod_needed(view.blades.z, p_error));
	r_need.covering = max(r_need.covering, all);
}

Choice choose(Need p_need, float p_hash, int p_first, int p_end) {
	float shown = grass_lod_shown(p_need.blades, p_hash);
	Choice choice = Choice(-1, p_need.blades < 1.0 ? p_need.blades : shown, grass_lod_shown(p_need.covering, p_hash), 0.0, 0u);
	if (shown > 0.0) {
		int segments = min(grass_lod_segments(p_need.segments), GRASS_SEGMENTS_AT(p_first));
		choice.level = grass_lod_level(shown, segments, p_first, p_end, view.levels.x, view.levels.y);
		choice.morph = grass_lod_morph(p_need.segments, segments);
	}
	return choice;
}

#include "lod/casts.inc"

// [Eq L7] [Eq L9] Returns the share of a tile's blades that an eye needs. p_to_eye: from the middle of the tile's box; p_pixel: metres of
// it in a pixel.
float in_sight(vec3 p_to_eye, float p_pixel, float p_grown, float p_cut, float p_slope) {
	float height = p_cut < GRASS_UNCUT ? min(view.blades.z, p_cut) : view.blades.z;
	float cover = p_grown * grass_lod_cover(view.blades.y, height, view.field.z);
	float share = grass_lod_in_sight(cover, length(p_to_eye.xz), p_to_eye.y, height, p_slope);
	return share * grass_lod_ends(height / (view.lod.z * p_pixel), share, view.blades.w);
}

// Finds the detail that the cameras need in a tile, for the picture and for shadows.
void find_needs(Tile p_tile, out Need r_seen, out Need r_casting) {
	r_seen = r_casting = Need(0.0, 0.0, 0.0);
	Cover cover = Cover(0.0, 0.0, 1.0, GRASS_UNCUT, 0.0); // TileCover::FULL
	if (p_tile.exists && view.counts.w == 1u) {
		cover = covers[p_tile.index];
	}
	uint watching = p_tile.exists && cover.low <= cover.high ? view.counts.x : 0u; // no camera needs a bare tile
	float side = 0.5 * view.field.z + view.blades.x;
	vec3 half_extents = vec3(side, 0.5 * (view.field.w + cover.high - cover.low), side);
	vec3 middle = p_tile.centre + vec3(0.0, cover.low + half_extents.y, 0.0);
	for (uint i = 0u; i < watching; i++) {
		vec4 eye = cameras[i].eye;
		vec2 pixel_at = cameras[i].pixel.xy;
		float eye_distance = max(distance(eye.xyz, middle), eye.w);
		float lod_distance = pixel_at.y > 0.0 ? eye_distance : eye.w; // to an orthogonal camera all distances are equal
		float pixel = pixel_at.x + pixel_at.y * lod_distance;
		if (grass_tile_visible(cameras[i].planes, middle, half_extents, 0.0, vec3(0.0))) {
			bool hides = pixel_at.y > 0.0 && view.lod.z > 0.0; // an orthogonal camera has no eye
			float shown = hides ? in_sight(eye.xyz - middle, pixel, cover.grown, cover.cut, cover.slope) : 1.0;
			add_need(r_seen, lod_distance, view.lod.z * pixel, view.lod.y * pixel, eye.w, shown);
		}
		if (eye_distance < view.shadow.y && casts_into(cameras[i], middle, half_extents)) {
			float least = view.lod.z * grass_lod_shadow(view.lod.w, eye_distance, view.shadow.y);
			float error = view.lod.y * GRASS_SHADOW_ANGULAR * view.lod.w;
			add_need(r_casting, lod_distance, least * pixel, error * pixel, eye.w, 1.0);
		}
	}
}

// Adds a tile to the workgroup's counts.
void enlist(inout Choice r_choice, int p_list) {
	if (r_choice.level >= 0) {
		r_choice.place = atomicAdd(group_tiles[r_choice.level], 1u);
		atomicAdd(group_blades[p_list], uint(ceil(r_choice.blades)));
	}
}

// Returns the number of levels before p_level that have a surface.
uint count_surfaces(int p_level) {
	uint low = p_level < 32 ? (1u << uint(p_level)) - 1u : 0xffffffffu;
	uint high = p_level < 32 ? 0u : (1u << uint(p_level - 32)) - 1u;
	return uint(bitCount(view.levels.z & low) + bitCount(view.levels.w & high));
}

// Writes how many instances a level has, and where they begin. Its command's firstInstance stays 0.
void write_command(int p_level) {
	bool casts = p_level >= GRASS_LOD_LEVELS, has_surface = grass_has_level(view.levels.z, view.levels.w, p_level);
	uint count = group_counted[p_level];
	uint command = (count_surfaces(p_level) - (casts ? count_surfaces(GRASS_LOD_LEVELS) : 0u)) * uint(GRASS_COMMAND_WORDS);
	if (has_surface && casts) {
		shadow_commands[command + 1u] = count; // instanceCount
	} else if (has_surface) {
		commands[command + 1u] = count;
	}
	imageStore(drawn_tiles, ivec2(p_level, 0), vec4(float(first_place(p_level)), 0.0, 0.0, 0.0));
}

// Fills the tables of levels. Must be followed by a barrier.
void share_levels(int p_thread) {
	if (p_thread < GRASS_ALL_LEVELS) {
		level_meshes[p_thread] = uint(GRASS_SEGMENTS_OF[p_thread]) | (uint(GRASS_BLADES_OF[p_thread]) << LEVEL_SEGMENT_BITS);
	}
}

// Clears a workgroup's counts before its tiles are added.
void clear_group(int p_thread) {
	if (p_thread < GRASS_ALL_LEVELS) {
		group_tiles[p_thread] = 0u;
	}
	if (p_thread < 2) {
		group_blades[p_thread] = 0u;
	}
}

// In GRASS_CULL_COUNT, adds the workgroup's counts to those of all tiles.
void count_tiles_of_group(int p_thread) {
	if (p_thread < GRASS_ALL_LEVELS && group_tiles[p_thread] > 0u) {
		atomicAdd(counted[p_thread], group_tiles[p_thread]);
	}
}

// In GRASS_CULL_WRITE, takes a stretch of each level for the workgroup's tiles.
void take_stretches(int p_thread) {
	if (p_thread < 2 && group_blades[p_thread] > 0u) {
		atomicAdd(blades_written[p_thread], group_blades[p_thread]);
	}
	if (p_thread < GRASS_ALL_LEVELS) {
		if (group_tiles[p_thread] > 0u) {
			group_first[p_thread] = first_place(p_thread) + atomicAdd(written[p_thread], group_tiles[p_thread]);
		}
		if (gl_WorkGroupID.x + gl_WorkGroupID.y == 0u) {
			write_command(p_thread);
		}
	}
}

// Writes a chosen tile into the list of drawn ones. p_end: end of the places in its list.
void write_tile(Tile p_tile, Choice p_choice, int p_slot, uint p_end) {
	if (p_choice.level < 0 || group_first[p_choice.level] + p_choice.place >= p_end) {
		return;
	}
	int place = int(group_first[p_choice.level] + p_choice.place);
	int low = p_slot == GRASS_NO_SLOT ? GRASS_NO_SLOT : p_slot % GRASS_SLOT_HALF;
	int high = p_slot == GRASS_NO_SLOT ? 0 : p_slot / GRASS_SLOT_HALF;
	uint start = grass_tile_start(uint(p_tile.at.x), uint(p_tile.at.y), view.counts.z);
	float covering = GRASS_COVERING_SCALE / float(GRASS_BLADES_PER_TILE) * p_choice.covering;
	ivec2 texel = ivec2(2 * (place % GRASS_PLACES_PER_ROW), 1 + place / GRASS_PLACES_PER_ROW);
	imageStore(drawn_tiles, texel, vec4(vec2(p_tile.at), p_choice.blades, p_choice.morph));
	imageStore(drawn_tiles, texel + ivec2(1, 0),
			vec4(float(start / uint(GRASS_START_STRIDE)), float(low), p_tile.hash, float(high) + covering));
}

// In GRASS_CULL_BEGIN, writes the identity transform.
void begin_instance(uint p_instance) {
	for (uint i = 0u; i < uint(GRASS_LISTED_FLOATS); i++) {
		float value = i == 0u || i == 5u ? 1.0 : 0.0;
		if (p_instance < phase.z) {
			instances[p_instance * uint(GRASS_LISTED_FLOATS) + i] = value;
		}
		if (p_instance < phase.w) {
			shadow_instances[p_instance * uint(GRASS_LISTED_FLOATS) + i] = value;
		}
	}
}

void main() {
	int thread = int(gl_LocalInvocationID.x);
	if (phase.x == uint(GRASS_CULL_BEGIN)) {
		begin_instance(find_thread());
		return;
	}
	share_levels(thread);
	if (phase.x != uint(GRASS_CULL_COUNT)) {
		read_counts(thread);
	}
	if (phase.x == uint(GRASS_CULL_TURNS) || phase.x == uint(GRASS_CULL_FIT)) {
		if (!is_crowded()) {
			return;
		}
		if (phase.x == uint(GRASS_CULL_FIT)) {
			fit(thread);
			return;
		}
	}
	clear_group(thread);
	barrier();
	Tile tile = find_tile();
	Need needed_to_see, needed_to_cast;
	find_needs(tile, needed_to_see, needed_to_cast);
	Choice drawn = choose(needed_to_see, tile.hash, 0, GRASS_LOD_LEVELS);
	Choice casting = choose(needed_to_cast, tile.hash, GRASS_LOD_LEVELS, GRASS_ALL_LEVELS);
	uint turn = grass_tile_turn(uint(tile.at.x), uint(tile.at.y), view.counts.z);
	if (phase.x == uint(GRASS_CULL_TURNS)) {
		count_turn(drawn.level, turn);
		count_turn(casting.level, turn);
		return;
	}
	make_room(drawn, turn, 0);
	make_room(casting, turn, 1);
	enlist(drawn, 0);
	enlist(casting, 1);
	barrier();
	if (phase.x == uint(GRASS_CULL_COUNT)) {
		count_tiles_of_group(thread);
		return;
	}
	take_stretches(thread);
	barrier();
	int slot = tile.exists ? table[tile.index] - 1 : GRASS_NO_SLOT;
	write_tile(tile, drawn, slot, phase.z);
	write_tile(tile, casting, slot, phase.z + phase.w);
}
