#version 450
// SPDX-License-Identifier: MIT
// Mixes the offsets of the last two steps for a frame between two ticks: one thread a texel. Runs only if the engine interpolates physics.
// Twin of core/field/pool_texels.h.
#extension GL_GOOGLE_include_directive : require

#include "base/constants.inc"
#include "base/rows.inc"
#include "solver/mix.inc"

layout(local_size_x = GRASS_MIX_GROUP) in;

layout(push_constant) uniform Share {
	vec4 share; // x: of the last step, 0..1; y: rows of the textures, one a slot; zw unused
};

// The pool texture a step before the last one: a copy, as long as physics is interpolated.
layout(set = 0, binding = GRASS_MIX_EARLIER) uniform sampler2D earlier;
// The pool texture, as simulate writes it.
layout(set = 0, binding = GRASS_MIX_NOW) uniform sampler2D now;
// Read by the blade shader in place of the pool texture.
layout(set = 0, binding = GRASS_MIX_SHOWN, rgba16f) writeonly uniform image2D shown;

void main() {
	uint width = uint(GRASS_KNOTS * GRASS_POOL_BLADES_PER_ROW);
	uint texels = uint(share.y) * width;
	uint groups = (texels - 1u) / uint(GRASS_MIX_GROUP) + 1u;
	uint index = gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * grass_row_width(groups) * uint(GRASS_MIX_GROUP);
	if (index < texels) {
		ivec2 texel = ivec2(int(index % width), int(index / width));
		vec4 before = texelFetch(earlier, texel, 0), after = texelFetch(now, texel, 0);
		imageStore(shown, texel, share.x < 1.0 ? mix(before, after, share.x) : after);
	}
}
