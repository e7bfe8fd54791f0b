// SPDX-License-Identifier: MIT
// Work that may run on several threads: the engine's (shared/parallel.h), or none.
#pragma once

#include <cstddef>
#include <functional>

namespace grass {

// Calls p_body(i) once for every i below p_count, in any order, on any thread, and returns when all are done.
using ParallelFor = std::function<void(int p_count, const std::function<void(int)> &p_body)>;

// Bodies or colliders handed to a thread at a time. Fewer: more is spent on handing them out. More: threads end farther apart.
constexpr size_t PARALLEL_BLOCK = 128;
constexpr size_t count_blocks(size_t p_elements) {
	return (p_elements + PARALLEL_BLOCK - 1) / PARALLEL_BLOCK;
}

// The simplest one: one after the other, here.
inline void serial_for(int p_count, const std::function<void(int)> &p_body) {
	for (int i = 0; i < p_count; i++) {
		p_body(i);
	}
}

} // namespace grass
