// SPDX-License-Identifier: MIT
// Measures how long the passes take on the GPU, with timestamps around them that are read about two frames later. Render thread.
#pragma once

namespace grass {

// Brackets work between two GPU timestamps, named so that read_gpu_times() finds them.
class Stopwatch {
public:
	enum Pass { SIMULATE, CULL };

	// p_owner: the object that passes itself to read_gpu_times().
	Stopwatch(bool p_measure, Pass p_pass, const void *p_owner);
	~Stopwatch();

private:
	bool _measures;
	Pass _pass;
	const void *_owner;
};

// The times of a frame that the GPU has finished, in milliseconds; 0: the frame had no such pass.
struct GpuTimes {
	double simulate_ms = 0.0, cull_ms = 0.0; // of one step, of one cull
};

// p_owner: whose.
GpuTimes read_gpu_times(const void *p_owner);

} // namespace grass
