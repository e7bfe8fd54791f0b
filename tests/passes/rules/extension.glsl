#version 450
// SPDX-License-Identifier: MIT
// A set of instructions that prints.
#extension GL_EXT_debug_printf : require
layout(local_size_x = 64) in;
layout(set = 0, binding = 40, std430) restrict buffer OutBuffer {
	uint result[];
};

void main() {
	debugPrintfEXT("blade");
	result[gl_LocalInvocationIndex] = 1u;
}
