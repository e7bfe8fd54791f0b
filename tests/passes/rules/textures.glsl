#version 450
// SPDX-License-Identifier: MIT
// Seventeen textures, and one sampler for all.
layout(local_size_x = 64) in;
layout(set = 0, binding = 40, std430) restrict buffer OutBuffer {
	uint result[];
};
layout(set = 0, binding = 0) uniform texture2D pictures[17];
layout(set = 0, binding = 1) uniform sampler filtered;

void main() {
	result[gl_LocalInvocationIndex] = uint(textureLod(sampler2D(pictures[16], filtered), vec2(0.5), 0.0).x);
}
