#version 450
// SPDX-License-Identifier: MIT
// Five images.
layout(local_size_x = 64) in;
layout(set = 0, binding = 40, std430) restrict buffer OutBuffer {
	uint result[];
};
layout(set = 0, binding = 0, rgba16f) uniform restrict writeonly image2D pictures[5];

void main() {
	imageStore(pictures[4], ivec2(0), vec4(1.0));
	result[gl_LocalInvocationIndex] = 1u;
}
