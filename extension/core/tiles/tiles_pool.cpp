// SPDX-License-Identifier: MIT
// How the pool becomes larger or smaller while tiles in it are awake.
#include "core/tiles/tiles.h"

namespace grass {

std::vector<SlotMove> TileManager::resize_pool(int p_slots) {
	TileParams params = _params;
	params.pool_size = p_slots;
	const int before = _params.pool_size, after = params.sanitised().pool_size;
	std::vector<SlotMove> moves;
	if (after == before) {
		return moves;
	}
	rest_calmest(_used.count() - after, moves);
	for (const int slot : _used) {
		if (slot >= after) { // one below is free, since no more tiles are awake than there are slots
			const int to = _free.take_lowest();
			moves.push_back({ get_tile_of(slot), slot, to });
			move_slot(slot, to);
		}
	}
	if (!moves.empty()) {
		_moved_step = _step_number;
	}
	_params.pool_size = after;
	const auto resize = [after](auto &r_states) {
		r_states.resize(size_t(after));
		r_states.shrink_to_fit(); // else a smaller pool would save nothing
	};
	resize(_times);
	resize(_motions);
	resize(_places);
	resize(_lives);
	resize(_blades);
	resize(_entries);
	resize(_forces);
	resize(_signatures);
	resize(_signatures_before);
	for (SlotSet *set : slot_sets()) {
		set->resize(before, after, set == &_free);
	}
	_slot_of_tile.reserve(after);
	for (const int slot : _used) {
		_slot_of_tile.insert(_places[size_t(slot)].tile.x, _places[size_t(slot)].tile.z, slot);
	}
	_records = std::vector<GrassSlot>(2 * size_t(after));
	_record_count = 0;
	_followers = {};
	_collider_list.clear();
	_meetings.forget();
	_statistics.awake = _used.count();
	return moves;
}

// Puts p_count tiles to rest at once, without records: the backend learns of it by r_moves.
void TileManager::rest_calmest(int p_count, std::vector<SlotMove> &r_moves) {
	if (p_count <= 0) {
		return;
	}
	_view.prepare(_grid, _params); // cameras may have moved since the last step
	_calm.clear();
	for (const int slot : _used) {
		_held.insert_if(slot, is_seen(slot));
		_calm.push_back(calm_of(slot));
	}
	std::partial_sort(_calm.begin(), _calm.begin() + p_count, _calm.end());
	for (int i = 0; i < p_count; i++) {
		const int slot = int(_calm[size_t(i)] & ((1 << SLOT_BITS) - 1));
		r_moves.push_back({ get_tile_of(slot), slot, GRASS_NO_SLOT });
		_slot_of_tile.erase(_places[size_t(slot)].tile.x, _places[size_t(slot)].tile.z);
		for (SlotSet *set : slot_sets()) {
			set->erase(slot);
		}
		_free.give_back(slot);
	}
	_statistics.evicted += uint64_t(p_count);
}

void TileManager::move_slot(int p_from, int p_to) {
	const size_t from = size_t(p_from), to = size_t(p_to);
	_times[to] = _times[from];
	_motions[to] = _motions[from];
	_places[to] = _places[from];
	_lives[to] = _lives[from];
	_blades[to] = _blades[from];
	_signatures[to] = _signatures[from];
	if (from < _bends.size()) {
		_bends[to] = _bends[from];
	}
	for (SlotSet *set : slot_sets()) {
		if (set != &_free) {
			set->insert_if(p_to, set->has(p_from));
			set->erase(p_from);
		}
	}
}

} // namespace grass
