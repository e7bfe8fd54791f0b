// SPDX-License-Identifier: MIT
// Measures how long a stage of the work takes.
#pragma once

#include <chrono>

namespace grass {

class CpuClock {
public:
	// Returns the milliseconds since construction or the last call.
	double lap() {
		const auto now = std::chrono::steady_clock::now();
		const std::chrono::duration<double, std::milli> time = now - _begin;
		_begin = now;
		return time.count();
	}

private:
	std::chrono::steady_clock::time_point _begin = std::chrono::steady_clock::now();
};

} // namespace grass
