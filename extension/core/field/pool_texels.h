// SPDX-License-Identifier: MIT
// The pool's texture as the CPU makes it: a row for each slot, 4 halves for each knot of each blade. Between two ticks it shows a mix of
// the offsets of the last two steps (docs/history/0060); if that is not needed, it keeps only those of the last step. Twin of
// shaders/solver/mix.glsl.
#pragma once

#include "core/solver/simulate.h"
#include "core/tiles/slot_set.h"

#include <cstdint>
#include <span>
#include <vector>

namespace grass {

class PoolTexels {
public:
	static constexpr int ROW_TEXELS = GRASS_KNOTS * GRASS_POOL_BLADES_PER_ROW;

	// Sets the number of slots; no tile is awake.
	void reset(int p_pool_size = 0);
	// Sets another number of slots. The blades of awake tiles stay, where p_moves says.
	void resize_pool(int p_pool_size, std::span<const SlotMove> p_moves);
	// Sets whether frames show a mix of two steps. Begins with the last step.
	void set_between(bool p_is_between);
	bool is_between() const { return _is_between; }

	// Must be called before and after a step. p_pool: its state before the step; p_slots: those that the step moves.
	void begin_step(const CpuPool &p_pool, std::span<const GrassSlot> p_slots);
	void end_step(std::span<const GrassSlot> p_slots);

	// Must be called when blades of these slots were posed again between two steps: both steps show them so.
	void change(const CpuPool &p_pool, std::span<const GrassSlot> p_slots);

	// Makes the texels of a texture of p_rows, with p_share of the last step, 0..1. Returns whether they have changed.
	bool show(const CpuPool &p_pool, int p_rows, float p_share);
	std::span<const uint16_t> get_shown() const { return _is_between ? _shown : _now; }
	size_t get_memory_usage() const { // bytes
		return (_now.capacity() + _earlier.capacity() + _shown.capacity()) * sizeof(uint16_t) + _changed.get_memory_usage() +
				_moved.get_memory_usage() + _settled.get_memory_usage();
	}

private:
	static constexpr size_t ROW = size_t(ROW_TEXELS) * 4;

	void begin_between();
	void resize_rows(int p_rows);
	void pack(const CpuPool &p_pool);
	void mix(float p_share);
	std::span<uint16_t> row(std::vector<uint16_t> &r_texels, int p_slot) const {
		return std::span(r_texels).subspan(size_t(p_slot) * ROW, ROW);
	}

	int _rows = 0, _pool_size = 0;
	bool _is_between = false;
	float _share = 1.0f; // that is visible
	std::vector<uint16_t> _now, _earlier, _shown; // after the last step, after the one before, and their mix; the last two may be empty
	SlotSet _changed; // rows that are not in _now yet
	SlotSet _moved; // by the last step: rows to mix
	SlotSet _settled; // rows that were mixed or not visible yet, and that the last step did not move
};

} // namespace grass
