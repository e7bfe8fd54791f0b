// SPDX-License-Identifier: MIT
// Work beside the frames: on a thread of its own, or at once where the library must not start threads (on the Web without threads, starting
// one ends the page). Nothing else in the library starts threads; the layer `format` looks for that.
#pragma once

#include <algorithm>
#include <future>
#include <thread>
#include <type_traits>
#include <utility>

namespace grass {

#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
inline constexpr bool HAS_THREADS = false;
#else
inline constexpr bool HAS_THREADS = true;
#endif

// Begins p_work, and returns the future of its result. Without threads the work has ended when this returns.
template <bool ON_THREAD = HAS_THREADS, class Work> auto run_beside(Work p_work) {
	if constexpr (ON_THREAD) {
		return std::async(std::launch::async, std::move(p_work));
	} else {
		std::packaged_task<std::invoke_result_t<Work>()> task(std::move(p_work));
		task();
		return task.get_future();
	}
}

// Returns how many threads can run at once; 1 without threads.
inline int count_processors() {
	return HAS_THREADS ? std::max(int(std::thread::hardware_concurrency()), 1) : 1;
}

} // namespace grass
