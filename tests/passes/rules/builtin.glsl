#version 450
// SPDX-License-Identifier: MIT
// The size of the dispatch.
layout(local_size_x = 64) in;
layout(set = 0, binding = 40, std430) restrict buffer OutBuffer {
	uint result[];
};

void main() {
	result[gl_LocalInvocationIndex] = gl_NumWorkGroups.x;
}
