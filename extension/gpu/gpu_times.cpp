// SPDX-License-Identifier: MIT
#include "gpu/gpu_times.h"

#include "gpu/device.h"
#include "gpu/render_queue.h"

using namespace godot;

namespace grass {

namespace {

constexpr char BEGIN[] = "GrassField";
constexpr const char *ENDS[] = { "GrassField simulate", "GrassField cull" }; // of Stopwatch::Pass

// Timestamps of all fields in a frame, or in some ticks without one. More: the engine's own, and those of other add-ons, find no room
// (`max_timestamp_query_elements`, 256). Fewer: of many measured fields some have no time.
constexpr int MOST_STAMPS = 128;

// Returns whether two more fit into this batch, and counts them.
bool take_two_stamps() {
	static uint64_t batch = 0;
	static int stamps = 0;
	if (const uint64_t now = RenderQueue::get_singleton()->get_batch(); batch != now) {
		batch = now;
		stamps = 0;
	}
	stamps += 2;
	return stamps <= MOST_STAMPS;
}

String end_of(Stopwatch::Pass p_pass, const void *p_owner) {
	return vformat("%s %d", String(ENDS[p_pass]), int64_t(reinterpret_cast<intptr_t>(p_owner)));
}

} // namespace

Stopwatch::Stopwatch(bool p_measure, Pass p_pass, const void *p_owner) :
		_measures(p_measure && take_two_stamps()), _pass(p_pass), _owner(p_owner) {
	if (_measures) {
		main_device()->capture_timestamp(BEGIN);
	}
}

Stopwatch::~Stopwatch() {
	if (_measures) {
		main_device()->capture_timestamp(end_of(_pass, _owner));
	}
}

void report_gpu_times(const void *p_owner, GpuReport &r_report) {
	RenderingDevice *device = main_device();
	const String cull = end_of(Stopwatch::CULL, p_owner), simulate = end_of(Stopwatch::SIMULATE, p_owner);
	double simulate_ms = 0.0, cull_ms = 0.0;
	int steps = 0; // a slow frame has several
	const uint32_t count = device->get_captured_timestamps_count();
	for (uint32_t i = 1; i < count; i++) { // each of ours ends a span that began at the timestamp before it
		const String name = device->get_captured_timestamp_name(i);
		if (device->get_captured_timestamp_name(i - 1) != String(BEGIN)) {
			continue;
		}
		const double ms = double(device->get_captured_timestamp_gpu_time(i) - device->get_captured_timestamp_gpu_time(i - 1)) * 1e-6;
		if (name == cull) {
			cull_ms = ms;
		} else if (name == simulate) {
			simulate_ms += ms;
			steps++;
		}
	}
	std::lock_guard lock(r_report.mutex);
	BackendStatistics &statistics = r_report.statistics;
	statistics.simulate_ms = simulate_ms > 0.0 ? simulate_ms / steps : statistics.simulate_ms;
	statistics.timed_steps += simulate_ms > 0.0 ? 1 : 0;
	statistics.cull_ms = cull_ms > 0.0 ? cull_ms : statistics.cull_ms;
}

} // namespace grass
