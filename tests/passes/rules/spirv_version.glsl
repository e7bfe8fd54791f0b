#version 450
// SPDX-License-Identifier: MIT
// target vulkan1.2: SPIR-V 1.5.
layout(local_size_x = 64) in;
layout(set = 0, binding = 40, std430) restrict buffer OutBuffer {
	uint result[];
};

void main() {
	result[gl_LocalInvocationIndex] = 1u;
}
