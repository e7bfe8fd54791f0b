// SPDX-License-Identifier: MIT
// Measures how long the passes take on the GPU, with timestamps around them that are read about two frames later. Render thread.
#pragma once

namespace grass {

// Brackets work between two GPU timestamps, named so that read_gpu_times() finds them.
class Stopwatch {
public:
	enum Pass { SIMULATE, CULL };

	Stopwatch(bool p_measure, Pass p_pass);
	~Stopwatch();

private:
	bool _measures;
	Pass _pass;
};

// The times of a frame that the GPU has finished, in milliseconds; 0: the frame had no such pass.
struct GpuTimes {
	double simulate_ms = 0.0, cull_ms = 0.0; // of one step, of one cull
};

GpuTimes read_gpu_times();

} // namespace grass
