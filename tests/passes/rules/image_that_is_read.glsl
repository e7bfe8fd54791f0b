#version 450
// SPDX-License-Identifier: MIT
// An image of halves that is read.
layout(local_size_x = 64) in;
layout(set = 0, binding = 40, std430) restrict buffer OutBuffer {
	uint result[];
};
layout(set = 0, binding = 0, rgba16f) uniform restrict readonly image2D picture;

void main() {
	result[gl_LocalInvocationIndex] = uint(imageLoad(picture, ivec2(0)).x);
}
