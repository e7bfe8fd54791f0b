#version 450
// SPDX-License-Identifier: MIT
// A specialization constant of type int.
layout(local_size_x = 64) in;
layout(set = 0, binding = 40, std430) restrict buffer OutBuffer {
	uint result[];
};
layout(constant_id = 0) const int METHOD = 0;

void main() {
	result[gl_LocalInvocationIndex] = uint(METHOD);
}
