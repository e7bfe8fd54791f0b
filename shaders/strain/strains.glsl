#version 450
// SPDX-License-Identifier: MIT
// Moves the free blades of awake tiles by their strains for one step: one thread a blade, a workgroup a tile. No field uses this pass yet:
// it is compiled, and held against drivers' compilers, with the others (docs/decisions/0101-blades-by-strains.md).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

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
// The pool, at the bindings that simulate has it at: only this pass reads and writes it. The numbers, as [slot][half][number][blade]; one
// half holds those now, the other one those of the step before, and a step writes over the latter.
layout(set = 0, binding = GRASS_BINDING_TWISTS, std430) restrict buffer NumberBuffer {
	float strain_numbers[];
};
// The offsets of every second knot from rest, as [slot][half][component][mass][blade], metres.
layout(set = 0, binding = GRASS_BINDING_KNOTS, std430) restrict buffer MassBuffer {
	float strain_masses[];
};
// By slot: which half holds those now.
layout(set = 0, binding = GRASS_BINDING_HALVES, std430) restrict buffer HalfBuffer {
	uint pool_half[];
};
// As in simulate.
layout(set = 0, binding = GRASS_BINDING_PATCH) uniform sampler2D patch_texture;
layout(set = 0, binding = GRASS_BINDING_POOL_TEXTURE, rgba16f) uniform restrict writeonly image2D pool_texture;
layout(set = 0, binding = GRASS_BINDING_ENERGY, std430) restrict writeonly buffer EnergyBuffer {
	vec4 slot_report[];
};
layout(set = 0, binding = GRASS_BINDING_GROWTH, std430) restrict readonly buffer GrowthBuffer {
	vec4 blade_growth[];
};
// A StrainSection: lower halves of the soft and of the stiff springs, then masses.
layout(set = 0, binding = GRASS_BINDING_SPECIES_STEPS, std430) restrict readonly buffer SectionBuffer {
	float section_numbers[];
};

GrassSlot slot; // of this workgroup's tile

#include "solver/state.inc"

#include "solver/rest.inc"

#include "base/lanes.inc"
#include "base/vector.inc"
#include "base/matrix.inc"
#include "bodies/constants.inc"
#include "solver/constants.inc"
#define GRASS_ROLLED(m_count) (m_count + int(step.field.w) - GRASS_KNOTS) // as WHOLE_COUNT of simulate
#include "strain/constants.inc"
#include "strain/basis.inc"
#include "solver/weights.inc"
#include "strain/kinematics.inc"
#include "strain/rows.inc"
#include "strain/solve.inc"

struct StrainBlade {
	vec3 width; // direction of the width at the root
	float size; // its length, metres
	float shorter; // see joint_axes()
};

uint number_place(uint p_half, uint p_number) {
	return ((2u * uint(slot.tile.w) + p_half) * uint(GRASS_STRAINS) + p_number) * uint(GRASS_BLADES_PER_TILE) + blade.number;
}
uint mass_place(uint p_half, int p_mass, uint p_component) {
	uint row = ((2u * uint(slot.tile.w) + p_half) * 3u + p_component) * uint(GRASS_STRAIN_MASSES) + uint(p_mass);
	return row * uint(GRASS_BLADES_PER_TILE) + blade.number;
}
vec3 mass_at(uint p_half, int p_mass) {
	return vec3(strain_masses[mass_place(p_half, p_mass, 0u)], strain_masses[mass_place(p_half, p_mass, 1u)],
			strain_masses[mass_place(p_half, p_mass, 2u)]);
}
void set_mass(uint p_half, int p_mass, vec3 p_offset) {
	strain_masses[mass_place(p_half, p_mass, 0u)] = p_offset.x;
	strain_masses[mass_place(p_half, p_mass, 1u)] = p_offset.y;
	strain_masses[mass_place(p_half, p_mass, 2u)] = p_offset.z;
}
Strains strains_at(uint p_half) {
	Strains strains;
	[[unroll]]
	for (int n = 0; n < GRASS_STRAINS; n++) {
		strains.at[n] = strain_numbers[number_place(p_half, uint(n))];
	}
	return strains;
}

// What step.inc asks for.
float mass_of(StrainSection p_section, int p_mass) {
	return section_numbers[2 * GRASS_STRAIN_SPRINGS + p_mass];
}
float whole_length(StrainBlade p_blade) {
	return p_blade.size;
}
vec3 rest_knot(StrainBlade p_blade, int p_knot) {
	return rest_at(p_knot);
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
	return mass_at(blade.half_now, p_mass);
}
vec3 mass_before(StrainBlade p_blade, int p_mass) {
	return mass_at(1u - blade.half_now, p_mass);
}
// The halves change roles after the step: what is now becomes what was before, and is written only where less than all of it does.
void move_to(inout StrainBlade r_blade, Strains p_next, float p_share) {
	[[unroll]]
	for (int n = 0; n < GRASS_STRAINS; n++) {
		uint now = number_place(blade.half_now, uint(n));
		if (p_share < 1.0) {
			strain_numbers[now] = p_share > 0.0 ? strain_numbers[now] * p_share : 0.0;
		}
		strain_numbers[number_place(1u - blade.half_now, uint(n))] = p_next.at[n];
	}
	if (p_share < 1.0) {
		for (int i = 0; i < GRASS_STRAIN_MASSES; i++) {
			set_mass(blade.half_now, i, p_share > 0.0 ? mass_at(blade.half_now, i) * p_share : vec3(0.0));
		}
	}
}
void put_knot(inout StrainBlade r_blade, int p_knot, vec3 p_offset) {
	imageStore(pool_texture, ivec2(GRASS_POOL_BLADES_PER_ROW * p_knot + int(blade.number), slot.tile.w), vec4(p_offset, 0.0));
	if ((p_knot & 1) == 1) {
		set_mass(1u - blade.half_now, (p_knot - GRASS_STRAIN_FIRST_MASS) / 2, p_offset);
	}
}

// Kept where the masses of the step before are, which have been read then.
void put_force(inout StrainBlade r_blade, int p_mass, vec3 p_force) {
	set_mass(1u - blade.half_now, p_mass, p_force);
}
vec3 force_on(StrainBlade p_blade, int p_mass) {
	return mass_at(1u - blade.half_now, p_mass);
}

#include "strain/step.inc"

StrainSection load_section() {
	StrainSection section;
	[[unroll]]
	for (int i = 0; i < GRASS_STRAIN_SPRINGS; i++) {
		section.soft.at[i] = section_numbers[i];
		section.stiff.at[i] = section_numbers[GRASS_STRAIN_SPRINGS + i];
	}
	return section;
}
StrainStep make_step() {
	float swing = step.chain.x * WILD;
	return StrainStep(step.load.xyz, step.free_motion.x, step.chain.y, step.chain.w * step.chain.x, step.chain.z * step.free_motion.z,
			swing * swing * step.chain.z, step.pbd_motion.y, step.load.w, step.energy.x);
}

StrainBlade load_blade() {
	float azimuth = texelFetch(patch_texture, patch_texel(0), 0).z;
	float size = float(GRASS_SEGMENTS) * length(rest_at(1)); // all segments are equally long
	return StrainBlade(vec3(cos(azimuth), 0.0, sin(azimuth)), size, 0.5 * float(GRASS_SEGMENTS) / max(size, 1e-12));
}

shared uint liveliest; // bits of a float

void main() {
	slot = slots[gl_WorkGroupID.x];
	blade.number = gl_LocalInvocationID.x;
	blade.half_now = pool_half[slot.tile.w] & 1u;
	if (blade.number == 0u) {
		liveliest = 0u;
	}
	find_growth(texelFetch(patch_texture, patch_texel(0), 0).xy);
	StrainBlade own = load_blade();
	StrainSection section = load_section();
	StrainStep own_step = make_step();
	barrier();
	float energy = strain_energy(own, section, own_step);
	atomicMax(liveliest, floatBitsToUint(energy < 1e30 ? energy : 0.0)); // of a blade that is not finite, and is put to rest: 0
	take_free_step(own, section, own_step, (slot.list.w & GRASS_SLOT_SETTLING) != 0u ? slot.blend.x : 0.0);
	barrier();
	if (blade.number == 0u) {
		pool_half[slot.tile.w] = 1u - blade.half_now;
		slot_report[slot.tile.w] = vec4(uintBitsToFloat(liveliest), 0.0, 0.0, 0.0);
	}
}
