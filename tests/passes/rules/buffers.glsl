#version 450
// SPDX-License-Identifier: MIT
// Thirty-one buffers and push constants.
layout(local_size_x = 64) in;
layout(set = 0, binding = 40, std430) restrict buffer OutBuffer {
	uint result[];
};
layout(set = 0, binding = 0, std430) restrict readonly buffer MoreBuffer {
	uint more[];
} buffers[30];
layout(push_constant) uniform Block {
	uint pushed;
};

void main() {
	result[gl_LocalInvocationIndex] = buffers[29].more[0] + pushed;
}
