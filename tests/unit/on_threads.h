// SPDX-License-Identifier: MIT
// A ParallelFor like the engine's: threads take the next index until there is none.
#pragma once

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace grass::test {

inline void on_threads(int p_count, const std::function<void(int)> &p_body) {
	constexpr int THREADS = 4;
	std::atomic<int> next = 0;
	std::vector<std::thread> threads;
	for (int t = 0; t < THREADS; t++) {
		threads.emplace_back([&] {
			for (int i = next++; i < p_count; i = next++) {
				p_body(i);
			}
		});
	}
	for (std::thread &thread : threads) {
		thread.join();
	}
}

} // namespace grass::test
