#version 450
// SPDX-License-Identifier: MIT
// Integers of 64 bits.
#extension GL_ARB_gpu_shader_int64 : require
layout(local_size_x = 64) in;
layout(set = 0, binding = 40, std430) restrict buffer OutBuffer {
	uint result[];
};

void main() {
	result[gl_LocalInvocationIndex] = uint(uint64_t(result[0]) * 3ul >> 32);
}
