#version 450
// SPDX-License-Identifier: MIT
// Seventeen samplers, and one texture for all.
layout(local_size_x = 64) in;
layout(set = 0, binding = 40, std430) restrict buffer OutBuffer {
	uint result[];
};
layout(set = 0, binding = 0) uniform texture2D picture;
layout(set = 0, binding = 1) uniform sampler filtered[17];

void main() {
	result[gl_LocalInvocationIndex] = uint(textureLod(sampler2D(picture, filtered[16]), vec2(0.5), 0.0).x);
}
