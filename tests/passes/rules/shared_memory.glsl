#version 450
// SPDX-License-Identifier: MIT
// As std430 has it, a vec3 takes as much as a vec4: 16,400 bytes, not 12,300.
layout(local_size_x = 64) in;
layout(set = 0, binding = 40, std430) restrict buffer OutBuffer {
	uint result[];
};
shared vec3 knots[1025];

void main() {
	knots[gl_LocalInvocationIndex] = vec3(1.0);
	barrier();
	result[gl_LocalInvocationIndex] = uint(knots[63u - gl_LocalInvocationIndex].x);
}
