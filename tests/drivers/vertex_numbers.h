// SPDX-License-Identifier: MIT
// Vertex shaders whose instances and vertices count from 0 in every draw call, as Direct3D 12 has them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

enum class Counting {
	FROM_BASE, // as Vulkan does: shaders stay as they are
	FROM_ZERO,
	RESTORED, // rewritten likewise, then the base is added again: a picture that differs shows a fault of the rewriting
};

// Returns the SPIR-V of p_code with InstanceIndex and VertexIndex less BaseInstance and BaseVertex. Empty where nothing is to be rewritten:
// no vertex shader, or one that reads neither.
std::vector<uint32_t> count_vertices(std::span<const uint32_t> p_code, Counting p_counting);
