// SPDX-License-Identifier: MIT
// How the core runs work on several threads: on the engine's (shared/parallel.h), or on none.
#pragma once

#include <cstddef>
#include <functional>

namespace grass {

// Calls p_body(i) once for every i below p_count, in any order, on any thread. Returns when all calls are done.
using ParallelFor = std::function<void(int p_count, const std::function<void(int)> &p_body)>;

// Bodies or colliders that a thread takes at a time. Fewer: handing them out costs more. More: threads finish at less equal times.
constexpr size_t PARALLEL_BLOCK = 128;
constexpr size_t count_blocks(size_t p_elements) {
	return (p_elements + PARALLEL_BLOCK - 1) / PARALLEL_BLOCK;
}

// Makes the calls one after the other on the calling thread.
inline void serial_for(int p_count, const std::function<void(int)> &p_body) {
	for (int i = 0; i < p_count; i++) {
		p_body(i);
	}
}

} // namespace grass
