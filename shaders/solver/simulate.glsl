#version 450
// SPDX-License-Identifier: MIT
// Simulates the awake tiles for one step: one thread a blade; a thread whose own blade is at rest takes another that is not. A workgroup
// has one tile, or several of which few blades are simulated: GrassSlot.group. Twin of core/solver/simulate.h.
#extension GL_GOOGLE_include_directive : require
#pragma variant GRASS_SPECIES // for fields with species
#pragma variant GRASS_EDGES // for tiles with colliders that blades' edges can meet where no knot does: several times slower
#pragma variant GRASS_SPECIES_EDGES
#pragma variant GRASS_FREE // for tiles without colliders: a third of the code, and METHOD_DIRECT takes 40 % less time
#pragma variant GRASS_SPECIES_FREE
#ifdef GRASS_SPECIES_EDGES
#define GRASS_SPECIES
#define GRASS_EDGES
#endif
#ifdef GRASS_SPECIES_FREE
#define GRASS_SPECIES
#define GRASS_FREE
#endif

#include "base/constants.inc"
#include "base/structs.inc"
#include "base/hash.inc"
#include "blades/clump.inc"
#include "blades/blade.inc"

// Where edges are searched, most of the time goes into look_together(), and few tiles are near something sharp: as many helpers as there
// are blades, the later threads, do nothing but test pairs there.
#ifdef GRASS_EDGES
#define GRASS_THREADS (2 * GRASS_BLADES_PER_TILE)
#define IS_HELPER (gl_LocalInvocationID.x >= uint(GRASS_BLADES_PER_TILE))
#else
#define GRASS_THREADS GRASS_BLADES_PER_TILE
#define IS_HELPER false
#endif
layout(local_size_x = GRASS_THREADS) in;
// Unsigned: Godot's translator for Direct3D 12 has no specialization constants of type int.
layout(constant_id = GRASS_CONSTANT_METHOD) const uint METHOD = uint(GRASS_METHOD_DIRECT);
layout(constant_id = GRASS_CONSTANT_TILES) const uint TILES = uint(GRASS_TILES_ONE);
// Whether a tile may have more colliders than GRASS_SHARED_COLLIDERS. The code that reads the others is in so many places that it costs a
// tenth of the time if there are none.
#define CROWD (TILES == uint(GRASS_TILES_CROWD))
// Whether a workgroup has several tiles. With one, much of what a thread knows is the same for all of its workgroup: compilers for AMD's
// and Intel's cards need fewer registers.
#define MANY (TILES == uint(GRASS_TILES_MANY))

// Whether threads keep the state of joints in arrays of their own, not in a buffer (solver/work.inc).
layout(constant_id = GRASS_CONSTANT_OWN_WORK) const bool OWN_WORK = false;

layout(push_constant, std430) uniform StepBlock {
	GrassStep step;
};
// The step as this thread's blade takes it. A species' numbers are read where they are used: a copy would take registers from beginning to
// end.
#ifdef GRASS_SPECIES
#define OWN_STEP species_steps[blade.species]
#else
#define OWN_STEP step
#endif

// GRASS_KNOTS, but a number that no driver knows: NVIDIA's always unrolls loops of known length, into
// 384 KB of code and 168 registers. Rolled up it is half the code and 125 registers: on an H100 METHOD_DIRECT takes 10 to 20 % less time
// among colliders, METHOD_PBD 20 % (when both methods were one program; METHOD_PBD alone 2 %).
#ifdef GRASS_FREE // small enough to be unrolled by NVIDIA's, the only one that OWN_WORK is for
#define KNOT_COUNT (OWN_WORK ? GRASS_KNOTS : int(step.field.w))
#else
#define KNOT_COUNT int(step.field.w)
#endif
// The same for any number of rounds.
#define ROLLED(m_count) ((m_count) + KNOT_COUNT - GRASS_KNOTS)

// Written by the CPU for this step.
layout(set = 0, binding = GRASS_BINDING_SLOTS, std430) restrict readonly buffer SlotBuffer {
	GrassSlot slots[];
};
layout(set = 0, binding = GRASS_BINDING_COLLIDERS, std430) restrict readonly buffer ColliderBuffer {
	GrassCollider colliders[];
};
layout(set = 0, binding = GRASS_BINDING_COLLIDER_LIST, std430) restrict readonly buffer ColliderListBuffer {
	uint collider_list[];
};
layout(set = 0, binding = GRASS_BINDING_PLANES, std430) restrict readonly buffer PlaneBuffer {
	vec4 planes[];
};
// Forces: those whose bits the slot has move the air of the tile.
layout(set = 0, binding = GRASS_BINDING_FORCES, std430) restrict readonly buffer ForceBuffer {
	GrassForce forces[];
};

// The pool: only this pass reads and writes it; lives as long as the field. Knots 2 .. 15 in blade space, metres, as
// [slot][half][component][knot][blade]. One half holds the places now, the other one those of the step before; a step writes its places
// over the latter, and the halves change roles: so nothing is copied. Within a step the places now are what is called start below, and the
// other half is `before`: METHOD_DIRECT keeps the target of its stage there, since the other state of a thread would push it out of the
// caches.
layout(set = 0, binding = GRASS_BINDING_KNOTS, std430) restrict buffer KnotBuffer {
	float pool_knots[];
};
// By slot. Lowest bit: which half holds the places now. Highest: HAS_STRAINS. The others: for how many steps to take all blades without a
// test which ones are at rest.
layout(set = 0, binding = GRASS_BINDING_HALVES, std430) restrict buffer HalfBuffer {
	uint pool_half[];
};
// The number of such steps if no blade was at rest.
#define STEPS_UNASKED 7u
// Twists of the joints below knots 2 .. 15, radians, or strains, and the blade's length, metres, as [slot][row, the length last][blade].
layout(set = 0, binding = GRASS_BINDING_TWISTS, std430) restrict buffer TwistBuffer {
	float pool_twists[];
};

// Lives for a dispatch; only the thread that wrote it reads it. It is not used if OWN_WORK is true.
layout(set = 0, binding = GRASS_BINDING_WORK, std430) restrict buffer WorkBuffer {
	uvec4 work[];
};

// Written once, when the field is made.
layout(set = 0, binding = GRASS_BINDING_PATCH) uniform sampler2D patch_texture;
// Written here, read by the blade shader: a knot's offset from rest, metres. w: twist of the joint below it, radians.
layout(set = 0, binding = GRASS_BINDING_POOL_TEXTURE, rgba16f) uniform restrict writeonly image2D pool_texture;
// Written here, read by the CPU some frames later; by slot: the liveliest blade's energy, J/kg; the tile's bend, [Eq M5].
layout(set = 0, binding = GRASS_BINDING_ENERGY, std430) restrict writeonly buffer EnergyBuffer {
	vec4 slot_report[];
};
// Slot + 1 of every tile of the field, 0 without one: a new table is all zeros. Written here, read by cull.
layout(set = 0, binding = GRASS_BINDING_TILE_TABLE, std430) restrict writeonly buffer TileTableBuffer {
	int tile_table[];
};
// Written by the CPU when a tile of a field with a map or species wakes, and when the map changes below it; by slot and blade: factor
// on the length; lean x, z; ground under the root, metres.
layout(set = 0, binding = GRASS_BINDING_GROWTH, std430) restrict readonly buffer GrowthBuffer {
	vec4 blade_growth[];
};
#ifdef GRASS_SPECIES
// Written with blade_growth; by slot and blade, a byte each: the species.
layout(set = 0, binding = GRASS_BINDING_BLADE_SPECIES, std430) restrict readonly buffer BladeSpeciesBuffer {
	uint blade_species[];
};
// Written by the CPU for this step: the step as each species takes it. Of known size, since the engine prints a warning if a shader asks a
// buffer for its length.
layout(set = 0, binding = GRASS_BINDING_SPECIES_STEPS, std430) restrict readonly buffer SpeciesStepBuffer {
	GrassStep species_steps[GRASS_MAX_SPECIES];
};
#endif

GrassSlot slot; // of this thread's tile

#include "solver/air.inc"
#include "solver/report.inc"

// Returns the direction of the blade's width at the root.
vec3 width_at_root() {
	float azimuth = texelFetch(patch_texture, patch_texel(0), 0).z;
	return vec3(cos(azimuth), 0.0, sin(azimuth));
}

#include "solver/work.inc"

#include "base/lanes.inc"
#include "base/vector.inc"
#include "base/matrix.inc"
#include "bodies/constants.inc"
#include "solver/constants.inc"
#include "bodies/collider.inc"
#include "solver/edge.inc"

#include "solver/near.inc"
#include "solver/beyond.inc"
#include "solver/contact.inc"
#include "solver/chain.inc"
#ifndef GRASS_FREE
#include "solver/plan.inc"
#endif
#include "solver/finish.inc"
#include "solver/solve.inc"
#define GRASS_ROLLED(m_count) ROLLED(m_count)
#include "strain/leave.inc"

// [Eq W6] Finds the effect of forces on the blade. Called in one place: each copy costs registers.
void find_air_load() {
	vec4 air = air_of_forces(root_of_blade());
	float pbd = METHOD == GRASS_METHOD_PBD ? OWN_STEP.free_motion.x * OWN_STEP.free_motion.x : 1.0;
	keep_of_blade(BLADE_AIR, vec4(air.xyz * pbd, air.w));
}

void find_blade(uint p_number) {
	blade.number = p_number;
#ifdef GRASS_SPECIES
	blade.species = species_of_blade();
#endif
	vec2 place = texelFetch(patch_texture, patch_texel(0), 0).xy;
	float ground = find_growth(place);
	keep_of_blade(BLADE_ROOT, vec4((place.x - 0.5) * step.field.x, ground, (place.y - 0.5) * step.field.x, 0.0));
	blade.blend = (slot.list.w & GRASS_SLOT_SETTLING) != 0u ? slot.blend.x : 0.0;
}

#include "solver/wake.inc"

// Takes the tile of thread p_thread. Returns whether it has one that is simulated.
bool find_tile(uvec4 p_group, uint p_thread) {
	uint tile = MANY ? p_thread / p_group.y : 0u;
	slot = slots[p_group.x + min(tile, p_group.z - 1u)];
	if (MANY && !IS_HELPER) {
		tile_of[gl_LocalInvocationID.x] = tile;
	}
	if (!CROWD) { // also where the pass for crowds is still compiled
		slot.list.z = min(slot.list.z, uint(GRASS_SHARED_COLLIDERS));
	}
	blade.half_now = pool_half[slot.tile.w] & 1u;
	return !MANY || (tile < p_group.z && (slot.list.w & GRASS_SLOT_RETIRED) == 0u);
}

// Steps the workgroup's tiles. All of its threads call it together.
void step_tiles(uvec4 p_group) {
	Stage stage;
	uint thread = gl_LocalInvocationID.x, lanes = MANY ? p_group.y : uint(GRASS_BLADES_PER_TILE), lane = thread % lanes;
	blade.work_start = p_group.w * uint(GRASS_WORK_PARTS * GRASS_SEGMENTS * GRASS_BLADES_PER_TILE) + thread;
	bool has_tile = find_tile(p_group, thread) && !IS_HELPER, leads = lane == 0u && !IS_HELPER;
	if (leads) {
		uint tile = MANY ? thread / lanes : 0u;
		begin_report(tile);
	}
	share_colliders(lane, lanes, has_tile);
	if (!IS_HELPER) {
		find_blade(lane);
	}
	bool is_fresh = (slot.list.w & GRASS_SLOT_FRESH) != 0u;
	uint blades = has_tile ? uint(GRASS_BLADES_PER_TILE) - uint(slot.blend.y) : 0u, count = uint(GRASS_BLADES_PER_TILE);
	bool is_whole = !MANY && slot.blend.y <= 0.0 && !is_fresh;
	uint unasked = is_whole ? (pool_half[slot.tile.w] & ~HAS_STRAINS) >> 1u : 0u;
	if (unasked == 0u) {
		// So that as few warps as possible have work.
		count = share_blades(thread, lane < blades && (is_fresh || !is_idle(slot.list.z)));
		unasked = is_fresh || count < uint(GRASS_BLADES_PER_TILE) ? 0u : STEPS_UNASKED + 1u;
	}
	bool takes_step = thread < count;
	if (takes_step) {
		if (count < uint(GRASS_BLADES_PER_TILE)) {
			if (MANY) {
				find_tile(p_group, blade_of[thread]);
			}
			find_blade(blade_of[thread] % lanes);
		}
		find_air_load();
		if ((pool_half[slot.tile.w] & HAS_STRAINS) != 0u) {
			leave_strains();
		}
		load_rest((slot.list.w & GRASS_SLOT_FRESH) != 0u);
	}
	if (step.contact.x >= 1.0) { // else no time passes
		step_blade(stage, takes_step, slot.list.z);
		blade.half_now = 1u - blade.half_now; // the next step starts from this step's places, which overwrote those before it
	}
	if (takes_step) {
		add_bend(tile_of_blade(), start_of(GRASS_KNOTS - 1) - rest_of(GRASS_KNOTS - 1)); // the step is over: the next one starts here
	}
	barrier();
	if (leads && (!MANY || find_tile(p_group, thread))) {
		if (MANY && step.contact.x >= 1.0) {
			blade.half_now = 1u - blade.half_now;
		}
		report_tile(MANY ? thread / lanes : 0u, (max(unasked, 1u) - 1u) << 1u);
	}
}

// Keeps the table of awake tiles.
void list_tiles(uvec4 p_group) {
	if (gl_LocalInvocationID.x < p_group.z) {
		GrassSlot own = slots[p_group.x + gl_LocalInvocationID.x];
		bool is_retired = (own.list.w & GRASS_SLOT_RETIRED) != 0u;
		if (is_retired || (own.list.w & GRASS_SLOT_FRESH) != 0u) {
			tile_table[own.tile.z] = is_retired ? 0 : own.tile.w + 1;
		}
	}
}

void main() {
	uvec4 group = slots[uint(step.contact.w) + gl_WorkGroupID.x].group;
	list_tiles(group);
	if (MANY || (slots[group.x].list.w & GRASS_SLOT_RETIRED) == 0u) {
		step_tiles(group);
	}
}
