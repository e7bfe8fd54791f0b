// SPDX-License-Identifier: MIT
// The results that the render thread reports to the main thread.
#pragma once

#include "core/field/backend_statistics.h"

#include <Eigen/Core>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <vector>

namespace grass {

struct GpuReport {
	std::mutex mutex;
	BackendStatistics statistics;
	uint64_t energy_step = 0; // StepInput::number of the step after which `energy` was read
	std::vector<float> energy; // per slot
	std::vector<Eigen::Vector3f> bends; // per slot
	std::atomic<uint64_t> settled = 0; // ViewRecords::number of the last frame that found everything up to date
};

} // namespace grass
