#version 450
// SPDX-License-Identifier: MIT
// Moves the blades of awake tiles without colliders by their strains: one thread a blade; a workgroup has one tile, or several of which
// few blades are simulated, as in simulate. docs/history/0101-blades-by-strains.md
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#pragma variant GRASS_SPECIES // for fields with species

#include "base/constants.inc"
#include "base/structs.inc"
#include "base/hash.inc"
#include "blades/clump.inc"
#include "blades/blade.inc"

layout(local_size_x = GRASS_BLADES_PER_TILE) in;

layout(push_constant, std430) uniform StepBlock {
	GrassStep step;
};

layout(set = 0, binding = GRASS_BINDING_SLOTS, std430) restrict readonly buffer SlotBuffer {
	GrassSlot slots[];
};
layout(set = 0, binding = GRASS_BINDING_FORCES, std430) restrict readonly buffer ForceBuffer {
	GrassForce forces[];
};
// The pool, and what blades grow from: see simulate.glsl.
layout(set = 0, binding = GRASS_BINDING_KNOTS, std430) restrict buffer KnotBuffer {
	float pool_knots[];
};
layout(set = 0, binding = GRASS_BINDING_HALVES, std430) restrict buffer HalfBuffer {
	uint pool_half[];
};
layout(set = 0, binding = GRASS_BINDING_TWISTS, std430) restrict buffer TwistBuffer {
	float pool_twists[];
};
layout(set = 0, binding = GRASS_BINDING_PATCH) uniform sampler2D patch_texture;
layout(set = 0, binding = GRASS_BINDING_POOL_TEXTURE, rgba16f) uniform restrict writeonly image2D pool_texture;
layout(set = 0, binding = GRASS_BINDING_ENERGY, std430) restrict writeonly buffer EnergyBuffer {
	vec4 slot_report[];
};
layout(set = 0, binding = GRASS_BINDING_GROWTH, std430) restrict readonly buffer GrowthBuffer {
	vec4 blade_growth[];
};
// Written by the CPU for this step, by species: a StrainSection, lower halves of the soft and of the stiff springs, then masses.
layout(set = 0, binding = GRASS_BINDING_SECTIONS, std430) restrict readonly buffer SectionBuffer {
	float section_numbers[];
};
#ifdef GRASS_SPECIES
layout(set = 0, binding = GRASS_BINDING_BLADE_SPECIES, std430) restrict readonly buffer BladeSpeciesBuffer {
	uint blade_species[];
};
layout(set = 0, binding = GRASS_BINDING_SPECIES_STEPS, std430) restrict readonly buffer SpeciesStepBuffer {
	GrassStep species_steps[GRASS_MAX_SPECIES];
};
#define OWN_STEP species_steps[blade.species]
#define OWN_SECTION (int(blade.species) * SECTION_NUMBERS)
#else
#define OWN_STEP step
#define OWN_SECTION 0
#endif

GrassSlot slot; // of this thread's tile

#include "solver/air.inc"
#include "solver/report.inc"

#include "base/lanes.inc"
#include "base/vector.inc"
#include "bodies/constants.inc"
#include "solver/constants.inc"
#include "strain/constants.inc"
#include "strain/basis.inc"
// The table of basis.inc, written and read by all threads of a step: a card quickly fetches a number of a shared array for any joint.
shared float joint_turns[GRASS_STRAIN_JOINTS * GRASS_STRAIN_ORDERS];
#define GRASS_JOINT_TURN(m_joint, m_order) joint_turns[((m_joint) - 1) * GRASS_STRAIN_ORDERS + (m_order)]
#include "solver/weights.inc"
#include "solver/plane.inc"
#include "strain/kinematics.inc"
#include "strain/rows.inc"
#include "strain/solve.inc"

#define SECTION_NUMBERS (2 * GRASS_STRAIN_SPRINGS + GRASS_STRAIN_MASSES)

struct StrainBlade {
	vec3 width; // direction of the width at the root
	float size; // its length, metres
	float shorter; // see joint_axes()
};

void share_joint_turns() {
	for (uint i = gl_LocalInvocationID.x; i < uint(GRASS_STRAIN_JOINTS * GRASS_STRAIN_ORDERS); i += gl_WorkGroupSize.x) {
		joint_turns[i] = JOINT_TURNS[i / uint(GRASS_STRAIN_ORDERS)][i % uint(GRASS_STRAIN_ORDERS)];
	}
}

// Knots 1 .. 15 of the threads' blades at rest, metres, as [component][knot][thread]. A thread writes its own in a step, and each sweep
// reads them.
shared float kept_rest[3 * GRASS_SEGMENTS * GRASS_BLADES_PER_TILE];
uint rest_place(int p_knot, uint p_component) {
	return (p_component * uint(GRASS_SEGMENTS) + uint(p_knot - 1)) * uint(GRASS_BLADES_PER_TILE) + gl_LocalInvocationID.x;
}
void keep_rest() {
	for (int k = 1; k < GRASS_KNOTS; k++) {
		vec3 rest = rest_of(k);
		kept_rest[rest_place(k, 0u)] = rest.x;
		kept_rest[rest_place(k, 1u)] = rest.y;
		kept_rest[rest_place(k, 2u)] = rest.z;
	}
}

uint number_row(uint p_half, int p_number) {
	return twist_row(p_half * uint(GRASS_STRAINS) + uint(p_number));
}
Strains strains_at(uint p_half) {
	Strains strains;
	[[unroll]]
	for (int n = 0; n < GRASS_STRAINS; n++) {
		strains.at[n] = pool_twists[number_row(p_half, n)];
	}
	return strains;
}
int knot_of_mass(int p_mass) {
	return GRASS_STRAIN_FIRST_MASS + 2 * p_mass;
}

// The functions that step.inc needs.
float mass_of(StrainSection p_section, int p_mass) {
	return section_numbers[OWN_SECTION + 2 * GRASS_STRAIN_SPRINGS + p_mass];
}
float whole_length(StrainBlade p_blade) {
	return p_blade.size;
}
vec3 rest_knot(StrainBlade p_blade, int p_knot) {
	return vec3(kept_rest[rest_place(p_knot, 0u)], kept_rest[rest_place(p_knot, 1u)], kept_rest[rest_place(p_knot, 2u)]);
}
JointAxes axes_of(StrainBlade p_blade, int p_joint, Joint p_at) {
	return joint_axes(p_at.below, p_at.above, p_blade.width, p_blade.shorter);
}
Strains strains_now(StrainBlade p_blade) {
	return strains_at(blade.half_now);
}
Strains strains_before(StrainBlade p_blade) {
	return strains_at(1u - blade.half_now);
}
vec3 mass_now(StrainBlade p_blade, int p_mass) {
	return start_of(knot_of_mass(p_mass));
}
vec3 mass_before(StrainBlade p_blade, int p_mass) {
	return before_of(knot_of_mass(p_mass));
}
// Moves the blade to its next numbers. The halves change roles after the step: what is current becomes what was before, and is written only
// if less than all of it does.
void move_to(inout StrainBlade r_blade, Strains p_next, float p_share) {
	[[unroll]]
	for (int n = 0; n < GRASS_STRAINS; n++) {
		uint now = number_row(blade.half_now, n);
		if (p_share < 1.0) {
			pool_twists[now] = p_share > 0.0 ? pool_twists[now] * p_share : 0.0;
		}
		pool_twists[number_row(1u - blade.half_now, n)] = p_next.at[n];
	}
}
void put_knot(inout StrainBlade r_blade, int p_knot, vec3 p_rest, vec3 p_place, float p_twist, float p_share, bool p_is_stopped) {
	if (p_is_stopped) {
		set_start(p_knot, p_place);
	} else if (p_share < 1.0) {
		set_start(p_knot, p_share > 0.0 ? p_rest + (start_of(p_knot) - p_rest) * p_share : p_rest);
	}
	set_before(p_knot, p_place);
	imageStore(pool_texture, pool_texel(p_knot), vec4(p_place - p_rest, p_twist));
}

// Keeps a force where the masses of the step before are, which have been read by then.
void put_force(inout StrainBlade r_blade, int p_mass, vec3 p_force) {
	set_before(knot_of_mass(p_mass), p_force);
}
vec3 force_on(StrainBlade p_blade, int p_mass) {
	return before_of(knot_of_mass(p_mass));
}

#include "strain/step.inc"

// The functions that take_chain.inc needs. The numbers are written over the twists.
float twist_of(StrainBlade p_blade, int p_joint) {
	return start_twist_of(p_joint);
}
void set_strains(inout StrainBlade r_blade, Strains p_now, Strains p_before) {
	[[unroll]]
	for (int n = 0; n < GRASS_STRAINS; n++) {
		pool_twists[number_row(blade.half_now, n)] = p_now.at[n];
		pool_twists[number_row(1u - blade.half_now, n)] = p_before.at[n];
	}
}
void move_knot(inout StrainBlade r_blade, int p_knot, vec3 p_place) {
	set_before(p_knot, before_of(p_knot) + (p_place - start_of(p_knot)));
	set_start(p_knot, p_place);
}

#include "strain/take_chain.inc"

StrainSection load_section() {
	StrainSection section;
	[[unroll]]
	for (int i = 0; i < GRASS_STRAIN_SPRINGS; i++) {
		section.soft.at[i] = section_numbers[OWN_SECTION + i];
		section.stiff.at[i] = section_numbers[OWN_SECTION + GRASS_STRAIN_SPRINGS + i];
	}
	return section;
}
// Returns the step of this thread's blade. p_air: by air_of_forces().
StrainStep make_strain_step(vec4 p_air) {
	float swing = step.chain.x * WILD;
	return StrainStep(OWN_STEP.load.xyz + p_air.xyz, OWN_STEP.free_motion.x, step.chain.y, (OWN_STEP.chain.w + p_air.w) * step.chain.x,
			OWN_STEP.chain.z * OWN_STEP.free_motion.z, swing * swing * OWN_STEP.chain.z, step.pbd_motion.y, OWN_STEP.load.w, step.energy.x,
			step.contact.z);
}

void find_blade(uint p_number) {
	take_blade(p_number);
	find_growth(texelFetch(patch_texture, patch_texel(0), 0).xy);
}
// [Eq W6] Returns air_of_forces() of the blade. Called where few other values are needed afterwards: each of them would take a register.
vec4 find_air() {
	if (slot.list.w >> GRASS_SLOT_FORCES == 0u) {
		return vec4(0.0);
	}
	vec2 place = texelFetch(patch_texture, patch_texel(0), 0).xy;
	float ground = find_growth(place);
	return air_of_forces(vec3((place.x - 0.5) * step.field.x, ground, (place.y - 0.5) * step.field.x));
}
StrainBlade load_blade() {
	float azimuth = texelFetch(patch_texture, patch_texel(0), 0).z;
	float size = grass_blade_length(rest_of(1));
	return StrainBlade(vec3(cos(azimuth), 0.0, sin(azimuth)), size, 0.5 / max(size * float(GRASS_SEGMENT_SHARE), 1e-12));
}

// Returns whether a step would change nothing: the blade is at rest, and nothing moves it.
bool is_resting(vec4 p_air) {
	float sum = sum_of(OWN_STEP.load.xyz + p_air.xyz);
	[[unroll]]
	for (uint row = 0u; row < uint(2 * GRASS_STRAINS); row++) {
		sum += abs(pool_twists[twist_row(row)]);
	}
	return sum <= 0.0;
}

void step_blade(uint p_tile) {
	StrainBlade own = load_blade();
	keep_rest();
	if ((pool_half[slot.tile.w] & HAS_STRAINS) == 0u) {
		take_chain(own);
	}
	vec4 air = find_air();
	if (!is_resting(air)) {
		StrainSection section = load_section();
		StrainStep own_step = make_strain_step(air);
		MassMotion motion = mass_motion(own, section);
		float energy = strain_energy(own, section, own_step, motion);
		atomicMax(liveliest[p_tile], floatBitsToUint(energy < 1e30 ? energy : 0.0)); // of a blade that is not finite, and is put to rest: 0
		take_free_step(own, section, own_step, motion, (slot.list.w & GRASS_SLOT_SETTLING) != 0u ? slot.blend.x : 0.0);
	}
}

void main() {
	uvec4 group = slots[uint(step.contact.w) + gl_WorkGroupID.x].group;
	uint tile = gl_LocalInvocationID.x / group.y, lane = gl_LocalInvocationID.x % group.y;
	bool has_tile = tile < group.z, passes = step.contact.x >= 1.0; // else no time passes
	slot = slots[group.x + min(tile, group.z - 1u)];
	find_blade(lane);
	uint state = passes ? HAS_STRAINS : pool_half[slot.tile.w] & ~1u;
	if (lane == 0u) {
		begin_report(tile);
	}
	share_joint_turns();
	barrier();
	bool is_simulated = has_tile && lane < uint(GRASS_BLADES_PER_TILE) - uint(slot.blend.y);
	if (is_simulated && passes) {
		step_blade(tile);
	}
	blade.half_now = passes ? 1u - blade.half_now : blade.half_now; // the next step starts from this step's places
	if (is_simulated) {
		add_bend(tile, start_of(GRASS_KNOTS - 1) - rest_of(GRASS_KNOTS - 1));
	}
	barrier();
	if (has_tile && lane == 0u) {
		report_tile(tile, state);
	}
}
