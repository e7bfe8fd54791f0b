#version 450
// SPDX-License-Identifier: MIT
// Eight buffers and an image, all written.
layout(local_size_x = 64) in;
layout(set = 0, binding = 40, std430) restrict buffer OutBuffer {
	uint result[];
};
layout(set = 0, binding = 0, rgba16f) uniform restrict writeonly image2D picture;
layout(set = 0, binding = 1, std430) restrict buffer MoreBuffer {
	uint more[];
} buffers[7];

void main() {
	imageStore(picture, ivec2(0), vec4(1.0));
	buffers[6].more[0] = 1u;
	result[gl_LocalInvocationIndex] = 1u;
}
