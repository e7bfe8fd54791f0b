// SPDX-License-Identifier: MIT
// Measures how long the passes take on the GPU, with timestamps around them that are read about two frames later. Render thread.
#pragma once

#include "gpu/gpu_report.h"

namespace grass {

// Brackets work between two GPU timestamps, named so that report_gpu_times() finds them.
class Stopwatch {
public:
	enum Pass { SIMULATE, CULL };

	// Begins to measure. p_owner: the object that passes itself to report_gpu_times().
	Stopwatch(bool p_measure, Pass p_pass, const void *p_owner);
	~Stopwatch();

private:
	bool _measures;
	Pass _pass;
	const void *_owner;
};

// Reports the times of p_owner's passes in the newest frame that the GPU has finished. A pass that did not run keeps its last time.
void report_gpu_times(const void *p_owner, GpuReport &r_report);

} // namespace grass
