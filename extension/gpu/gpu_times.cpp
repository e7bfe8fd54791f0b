// SPDX-License-Identifier: MIT
#include "gpu/gpu_times.h"

#include "gpu/device.h"

using namespace godot;

namespace grass {

namespace {

constexpr char BEGIN[] = "GrassField";
constexpr const char *ENDS[] = { "GrassField simulate", "GrassField cull" }; // of Stopwatch::Pass

} // namespace

Stopwatch::Stopwatch(bool p_measure, Pass p_pass) : _measures(p_measure), _pass(p_pass) {
	if (_measures) {
		main_device()->capture_timestamp(BEGIN);
	}
}

Stopwatch::~Stopwatch() {
	if (_measures) {
		main_device()->capture_timestamp(ENDS[_pass]);
	}
}

GpuTimes read_gpu_times() {
	RenderingDevice *device = main_device();
	GpuTimes times;
	int steps = 0; // a slow frame has several
	const uint32_t count = device->get_captured_timestamps_count();
	for (uint32_t i = 1; i < count; i++) { // each of ours ends a span that began at the timestamp before it
		const String name = device->get_captured_timestamp_name(i);
		if (device->get_captured_timestamp_name(i - 1) != String(BEGIN)) {
			continue;
		}
		const double ms = double(device->get_captured_timestamp_gpu_time(i) - device->get_captured_timestamp_gpu_time(i - 1)) * 1e-6;
		if (name == String(ENDS[Stopwatch::CULL])) {
			times.cull_ms = ms;
		} else if (name == String(ENDS[Stopwatch::SIMULATE])) {
			times.simulate_ms += ms;
			steps++;
		}
	}
	times.simulate_ms /= steps > 0 ? steps : 1;
	return times;
}

} // namespace grass
