// SPDX-License-Identifier: MIT
// The pool as a frame between two ticks shows it: a mix of the offsets of the last two steps (docs/history/0060). It is made if the
// engine interpolates physics; otherwise it has no texture and no pass. Render thread.
#pragma once

#include "gpu/device.h"
#include "gpu/pool_room.h"

#include <functional>

namespace grass {

class PoolMix {
public:
	~PoolMix() { free(); }

	// Creates the mix of p_pool, which has p_slots rows. It begins as a copy of the first p_rows, those in use.
	void create(const godot::RID &p_pool, const godot::RID &p_sampler, int64_t p_slots, int p_rows);
	// Follows p_pool, which has another number of rows now, that of r_room. Rows keep what they show, as for move_rows(). p_show: shows
	// get_shown() in place of the old texture, before that is freed.
	void resize(const godot::RID &p_pool, const godot::RID &p_sampler, PoolRoom &r_room, int p_kept, std::span<const SlotMove> p_moves,
			const std::function<void()> &p_show);
	void free();
	bool is_created() const { return _earlier.is_valid(); }
	// Returns true if get_shown() is drawn. Until the driver has compiled the pass, the pool itself is drawn.
	bool is_showing() const { return _is_showing; }
	// Must be called before a step. p_pool: the result of the step before, with p_rows in use.
	void keep(const godot::RID &p_pool, int p_rows);
	// Mixes p_share of the last step with the rest of the one before. Returns whether it did anything.
	bool mix(float p_share, int p_rows);

	const godot::RID &get_earlier() const { return _earlier; }
	const godot::RID &get_shown() const { return _shown; }
	int64_t get_memory_usage() const; // bytes

private:
	void bind(const godot::RID &p_pool, const godot::RID &p_sampler);

	godot::RID _earlier, _shown;
	int64_t _slots = 0;
	bool _is_showing = false;
	GpuPass _pass;
};

} // namespace grass
