#version 450
// SPDX-License-Identifier: MIT
// Thirty-three numbers.
layout(local_size_x = 64) in;
layout(set = 0, binding = 40, std430) restrict buffer OutBuffer {
	uint result[];
};
layout(push_constant, std430) uniform Block {
	uint pushed[33];
};

void main() {
	result[gl_LocalInvocationIndex] = pushed[32];
}
