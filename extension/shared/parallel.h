// SPDX-License-Identifier: MIT
// The engine's worker threads as a ParallelFor of the core.
#pragma once

#include <functional>

namespace grass {

// Calls p_body(i) once for every i below p_count, here and on the engine's WorkerThreadPool; returns when all are done. It waits for no
// thread that has not begun: where all of them are busy, the caller does everything. From any thread.
void run_parallel(int p_count, const std::function<void(int)> &p_body);
// Waits for what run_parallel() still has in the engine's queue: to be called before the library is unloaded.
void finish_parallel();

} // namespace grass
