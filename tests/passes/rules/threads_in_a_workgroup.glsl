#version 450
// SPDX-License-Identifier: MIT
// A thread too many.
layout(local_size_x = 43, local_size_y = 3) in;
layout(set = 0, binding = 40, std430) restrict buffer OutBuffer {
	uint result[];
};

void main() {
	result[gl_LocalInvocationIndex] = 1u;
}
