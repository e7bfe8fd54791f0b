// SPDX-License-Identifier: MIT
// The engine's worker threads, as a ParallelFor for the core.
#pragma once

#include <functional>

namespace grass {

// Calls p_body(i) once for every i below p_count, on this thread and on the engine's WorkerThreadPool. Returns when all calls are done.
// Does not wait for a thread that has not begun: if all of them are busy, the caller does all the work. May be called on any thread.
void run_parallel(int p_count, const std::function<void(int)> &p_body);
// Waits for what run_parallel() still has in the engine's queue. Must be called before the library is unloaded.
void finish_parallel();

} // namespace grass
