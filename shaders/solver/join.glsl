#version 450
// SPDX-License-Identifier: MIT
// Gives blades the poses of the simulated ones of their tile: blades that join these since a camera has come nearer, and blades that follow
// them in each step. One workgroup a tile, one thread a blade. Dispatched over GrassSlot records, before a frame is drawn or after a step.
// Twin of core/solver/join.h.
#extension GL_GOOGLE_include_directive : require
#pragma variant GRASS_SPECIES // for fields with species

#include "base/constants.inc"
#include "base/structs.inc"
#include "base/hash.inc"
#include "blades/clump.inc"

layout(local_size_x = GRASS_BLADES_PER_TILE) in;

layout(push_constant, std430) uniform StepBlock {
	GrassStep step;
};

// Written by the CPU for this frame or step.
layout(set = 0, binding = GRASS_BINDING_SLOTS, std430) restrict readonly buffer SlotBuffer {
	GrassSlot slots[];
};
// The pool and what the blades grow from: see simulate.glsl.
layout(set = 0, binding = GRASS_BINDING_KNOTS, std430) restrict buffer KnotBuffer {
	float pool_knots[];
};
layout(set = 0, binding = GRASS_BINDING_HALVES, std430) restrict readonly buffer HalfBuffer {
	uint pool_half[];
};
layout(set = 0, binding = GRASS_BINDING_TWISTS, std430) restrict buffer TwistBuffer {
	float pool_twists[];
};
layout(set = 0, binding = GRASS_BINDING_PATCH) uniform sampler2D patch_texture;
layout(set = 0, binding = GRASS_BINDING_POOL_TEXTURE, rgba16f) uniform restrict writeonly image2D pool_texture;
layout(set = 0, binding = GRASS_BINDING_GROWTH, std430) restrict readonly buffer GrowthBuffer {
	vec4 blade_growth[];
};
#ifdef GRASS_SPECIES
layout(set = 0, binding = GRASS_BINDING_BLADE_SPECIES, std430) restrict readonly buffer BladeSpeciesBuffer {
	uint blade_species[];
};
#endif

GrassSlot slot; // of this workgroup's tile
shared vec2 places[GRASS_BLADES_PER_TILE + 1]; // of the blades' roots in the tile, shares of its side

#include "strain/leave.inc"

void find_blade(uint p_number) {
	take_blade(p_number);
	places[p_number] = texelFetch(patch_texture, patch_texel(0), 0).xy;
	find_growth(places[p_number]);
}

// Returns the nearest of the first p_count blades.
uint find_nearest(vec2 p_place, uint p_count) {
	uint nearest = 0u;
	float least = 1e30;
	for (uint other = 0u; other < p_count; other++) {
		vec2 way = places[other] - p_place;
		if (dot(way, way) < least) {
			least = dot(way, way);
			nearest = other;
		}
	}
	return nearest;
}

// A knot of the other blade, metres from its place at rest: its offset, and how far it moved in the last step. w: its twist, radians.
struct Bent {
	vec3 offset, moved;
	float twist;
};
Bent bent_of(int p_knot, bool p_has_strains) {
	vec3 knot = start_of(p_knot);
	float twist = p_has_strains ? twist_by(twist_strains(), p_knot - 1) : start_twist_of(p_knot - 1);
	return Bent(knot - rest_of(p_knot), knot - before_of(p_knot), twist);
}

// [Eq 50] Returns how far knot p_k is from rest if it moves with its neighbour, and the twist of the joint below it. A step exchanges the
// halves: what was current in the step before is `before` in this one.
Bent alone_of(int p_k, vec3 p_rest, vec3 p_moved) {
	vec3 last = step.contact.x >= 1.0 ? before_of(p_k) : start_of(p_k);
	return Bent(last - p_rest + p_moved, p_moved, start_twist_of(p_k - 1));
}

void copy_strains(Blade p_from, Blade p_to) {
	for (uint row = 0u; row < uint(GRASS_LENGTH_ROW); row++) {
		blade = p_from;
		float number = pool_twists[twist_row(row)];
		blade = p_to;
		pool_twists[twist_row(row)] = number;
	}
}

// [Eq 49] Lets the thread's blade join p_other.
void join_blade(uint p_other) {
	Blade own = blade;
	vec3 parent = rest_of(1), parent_rest = parent, parent_offset = vec3(0.0);
	float size = length(parent);
	find_blade(p_other);
	Blade other = blade;
	float ratio = size / max(length(rest_of(1)), 1e-6);
	bool has_strains = (pool_half[slot.tile.w] & HAS_STRAINS) != 0u;
	if (has_strains) {
		copy_strains(other, own);
	}
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		blade = other;
		Bent bent = bent_of(k, has_strains);
		blade = own;
		vec3 rest = rest_of(k), offset = bent.offset * ratio, moved = bent.moved * ratio, knot = rest;
		float twist = bent.twist;
		if (slot.blend.x < 1.0) {
			Bent alone = alone_of(k, rest, moved);
			offset = alone.offset + (offset - alone.offset) * slot.blend.x;
			twist = alone.twist + (twist - alone.twist) * slot.blend.x;
		}
		if (dot(offset, offset) > 0.0 || dot(parent_offset, parent_offset) > 0.0) {
			vec3 segment = (rest - parent_rest) + (offset - parent_offset);
			knot = parent + segment * (length(rest - parent_rest) / max(length(segment), 1e-6));
		}
		set_start(k, knot);
		set_before(k, knot - moved);
		if (!has_strains) {
			set_twist(k - 1, twist);
		}
		imageStore(pool_texture, pool_texel(k), vec4(knot - rest, twist));
		parent = knot;
		parent_rest = rest;
		parent_offset = offset;
	}
}

void main() {
	slot = slots[gl_WorkGroupID.x];
	uint from = uint(GRASS_BLADES_PER_TILE) - uint(slot.blend.z), to = uint(GRASS_BLADES_PER_TILE) - uint(slot.blend.y);
	uint sources = uint(GRASS_BLADES_PER_TILE) - uint(slot.blend.w);
	uint number = gl_LocalInvocationID.x;
	find_blade(number);
	barrier();
	if (number >= from && number < to) {
		join_blade(find_nearest(places[number], sources));
	}
}
