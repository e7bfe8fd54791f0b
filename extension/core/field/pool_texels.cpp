// SPDX-License-Identifier: MIT
#include "core/field/pool_texels.h"

#include "core/base/half.h"
#include "core/base/resize_exactly.h"

#include <algorithm>
#include <bit>

namespace grass {

namespace {

uint16_t mix_halves(uint16_t p_before, uint16_t p_after, float p_share) {
	if (p_before == p_after || p_share >= 1.0f) {
		return p_after;
	}
	return float_to_half(half_to_float(p_before) * (1.0f - p_share) + half_to_float(p_after) * p_share);
}

} // namespace

void PoolTexels::reset(int p_pool_size) {
	_pool_size = p_pool_size;
	_changed.reset(_pool_size, false);
	begin_between();
}

void PoolTexels::resize_pool(int p_pool_size, std::span<const SlotMove> p_moves) {
	for (const SlotMove &move : p_moves) {
		if (move.to == GRASS_NO_SLOT) {
			continue;
		}
		_changed.insert(move.to); // the pool has the blades there now
		if (_is_between) {
			(_moved.has(move.from) ? _moved : _settled).insert(move.to);
			std::ranges::copy(row(_earlier, move.from), row(_earlier, move.to).begin());
		}
	}
	for (SlotSet *set : { &_changed, &_moved, &_settled }) {
		if (set == &_changed || _is_between) {
			set->resize(_pool_size, p_pool_size, false);
		}
	}
	_pool_size = p_pool_size;
}

void PoolTexels::begin_between() {
	_moved = SlotSet(); // new objects, since copies would keep the memory
	_settled = SlotSet();
	if (_is_between) {
		_moved.reset(_pool_size, false);
		_settled = _changed;
	}
}

void PoolTexels::set_between(bool p_is_between) {
	if (p_is_between == _is_between) {
		return;
	}
	_is_between = p_is_between;
	_share = 1.0f;
	begin_between();
	_earlier = _is_between ? _now : std::vector<uint16_t>();
	_shown = std::vector<uint16_t>(_earlier); // a copy would keep the memory
}

void PoolTexels::resize_rows(int p_rows) {
	if (p_rows == _rows) {
		return;
	}
	_rows = p_rows;
	for (std::vector<uint16_t> *texels : { &_now, &_earlier, &_shown }) {
		if (texels == &_now || _is_between) {
			resize_exactly(*texels, size_t(_rows) * ROW);
		}
	}
}

// Slots beyond the rows fell asleep since, otherwise they would have a row.
void PoolTexels::pack(const CpuPool &p_pool) {
	for (const int slot : _changed) {
		if (slot >= _rows) {
			break;
		}
		p_pool.pack_row(slot, row(_now, slot));
	}
	_changed.clear();
}

void PoolTexels::begin_step(const CpuPool &p_pool, std::span<const GrassSlot> p_slots) {
	if (!_is_between) {
		return;
	}
	int highest = _rows - 1;
	for (const GrassSlot &slot : p_slots) {
		highest = std::max(highest, slot.tile.w);
	}
	resize_rows(highest < _rows ? _rows : int(std::bit_ceil(unsigned(highest + 1))));
	pack(p_pool);
	for (const int slot : _moved) {
		if (slot < _rows) {
			std::ranges::copy(row(_now, slot), row(_earlier, slot).begin());
		}
	}
	_settled.insert_all(_moved);
	_moved.clear();
	for (const GrassSlot &slot : p_slots) {
		if ((slot.list.w & GRASS_SLOT_FRESH) != 0) {
			std::ranges::fill(row(_earlier, slot.tile.w), uint16_t(0)); // it was at rest; another tile left its blades here
		}
	}
}

void PoolTexels::end_step(std::span<const GrassSlot> p_slots) {
	for (const GrassSlot &slot : p_slots) {
		if ((slot.list.w & GRASS_SLOT_RETIRED) == 0) {
			_changed.insert(slot.tile.w);
			if (_is_between) {
				_moved.insert(slot.tile.w);
			}
		}
	}
}

void PoolTexels::change(const CpuPool &p_pool, std::span<const GrassSlot> p_slots) {
	for (const GrassSlot &slot : p_slots) {
		_changed.insert(slot.tile.w);
		if (!_is_between || slot.tile.w >= _rows) {
			continue;
		}
		const std::span<uint16_t> now = row(_now, slot.tile.w), earlier = row(_earlier, slot.tile.w);
		p_pool.pack_row(slot.tile.w, now);
		for (int texel = 0; texel < ROW_TEXELS; texel++) {
			const int blade = texel % GRASS_POOL_BLADES_PER_ROW;
			if (blade >= GRASS_BLADES_PER_TILE - int(slot.blend.z)) {
				std::copy_n(now.begin() + ptrdiff_t(texel) * 4, 4, earlier.begin() + ptrdiff_t(texel) * 4);
			}
		}
		_settled.insert(slot.tile.w);
	}
}

void PoolTexels::mix(float p_share) {
	for (const int slot : _settled) {
		if (slot < _rows && !_moved.has(slot)) {
			std::ranges::copy(row(_now, slot), row(_earlier, slot).begin());
			std::ranges::copy(row(_now, slot), row(_shown, slot).begin());
		}
	}
	_settled.clear();
	for (const int slot : _moved) {
		if (slot < _rows) {
			std::ranges::transform(row(_earlier, slot), row(_now, slot), row(_shown, slot).begin(),
					[p_share](uint16_t p_before, uint16_t p_after) { return mix_halves(p_before, p_after, p_share); });
		}
	}
}

bool PoolTexels::show(const CpuPool &p_pool, int p_rows, float p_share) {
	const bool has_changed = p_rows != _rows || !_changed.is_empty();
	resize_rows(p_rows);
	pack(p_pool);
	if (!_is_between) {
		return has_changed;
	}
	const bool is_other = has_changed || !_settled.is_empty() || (_share != p_share && !_moved.is_empty());
	_share = p_share;
	if (is_other) {
		mix(p_share);
	}
	return is_other;
}

} // namespace grass
