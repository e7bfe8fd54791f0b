// SPDX-License-Identifier: MIT
// Reads the knots of a few blades back from a field's pool. Lives on the render thread.
#pragma once

#include "core/field/knot_watch.h"
#include "gpu/device.h"

#include <memory>
#include <mutex>

namespace grass {

// The knots that the render thread passes to the main thread.
struct KnotReport {
	std::mutex mutex;
	KnotWatch::Answer answer;
};

class KnotReader {
public:
	static const PassCode CODE;

	void create(); // the driver may still be compiling its pass when this returns
	// Sets the pool's buffers: positions of all knots, and which half has the current ones.
	void bind(const godot::RID &p_knots, const godot::RID &p_halves);
	// Requests the positions of these blades after all work queued so far. r_report receives them about two frames later.
	void read_later(std::vector<WantedBlade> &&p_blades, uint64_t p_step, const std::shared_ptr<KnotReport> &r_report);
	// Waits for the device, and returns the positions in the order of p_blades; empty if it fails.
	std::vector<float> read_now(std::span<const WantedBlade> p_blades);
	void free();

	int64_t get_memory_usage() const { return _blades.size() + _found.size(); } // bytes

private:
	uint32_t gather(std::span<const WantedBlade> p_blades);

	GpuBuffer _blades, _found;
	GpuPass _pass;
};

} // namespace grass
