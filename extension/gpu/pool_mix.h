// SPDX-License-Identifier: MIT
// What a frame between two ticks shows of the pool: the offsets of the last two steps, mixed (docs/decisions/0060). Made where the engine
// interpolates physics; elsewhere it has no texture and no pass. On the render thread.
#pragma once

#include "gpu/device.h"

#include <span>

namespace grass {

class PoolMix {
public:
	~PoolMix() { free(); }

	// p_pool: of p_slots rows. It begins with the pool as it is.
	void create(const godot::RID &p_pool, const godot::RID &p_sampler, int64_t p_slots);
	void free();
	bool is_created() const { return _earlier.is_valid(); }
	// Whether get_shown() is what is drawn; until the driver has compiled the pass the pool itself is.
	bool is_showing() const { return _is_showing; }
	// Before a step: p_pool, of which p_rows are in use, is what the step before left.
	void keep(const godot::RID &p_pool, int p_rows);
	// p_share of the last step. Returns whether it did anything.
	bool mix(float p_share, int p_rows);

	const godot::RID &get_earlier() const { return _earlier; }
	const godot::RID &get_shown() const { return _shown; }
	int64_t get_memory_usage() const; // bytes

private:
	godot::RID _earlier, _shown;
	int64_t _slots = 0;
	bool _is_showing = false;
	GpuPass _pass;
};

} // namespace grass
