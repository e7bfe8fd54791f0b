// SPDX-License-Identifier: MIT
// How many slots there are: as many as the awake tiles need, within the pool's size and what a PoolBudget grants.
#include "core/tiles/tiles.h"

#include "core/base/resize_exactly.h"

#include <utility>

namespace grass {

std::vector<SlotMove> TileManager::resize_pool(int p_slots) {
	TileParams params = _params;
	params.pool_size = p_slots;
	_params.pool_size = params.sanitised().pool_size;
	return fit_limit();
}

std::vector<SlotMove> TileManager::grant(int p_slots) {
	_granted = std::max(p_slots, 0);
	return fit_limit();
}

std::vector<SlotMove> TileManager::fit_limit() {
	std::vector<SlotMove> moves;
	rest_calmest(_used.count() - get_limit(), moves);
	if (_room > _params.pool_size) {
		set_room(_params.pool_size, moves);
	} else if (!moves.empty()) {
		forget_step();
	}
	return moves;
}

std::vector<SlotMove> TileManager::trim(double p_delta) {
	std::vector<SlotMove> moves;
	const int room = _room_plan.find_trimmed(_used.count(), _room, p_delta);
	if (room != RoomPlan::KEEP) {
		set_room(room, moves);
	}
	return moves;
}

// Tiles that have slots beyond the new room get others.
void TileManager::set_room(int p_slots, std::vector<SlotMove> &r_moves) {
	for (const int slot : _used) {
		if (slot >= p_slots) { // one below is free, since no more tiles are awake than there are slots
			const int to = _free.take_lowest();
			r_moves.push_back({ get_tile_of(slot), slot, to });
			move_slot(slot, to);
		}
	}
	const int before = std::exchange(_room, p_slots);
	_room_plan.made();
	const auto resize = [this](auto &r_states, size_t p_for_each = 1) { resize_exactly(r_states, p_for_each * size_t(_room)); };
	resize(_times);
	resize(_motions);
	resize(_places);
	resize(_lives);
	resize(_blades);
	resize(_entries);
	resize(_forces);
	resize(_air);
	resize(_signatures);
	resize(_signatures_before);
	resize(_records, 2);
	for (SlotSet *set : slot_sets()) {
		set->resize(before, _room, set == &_free);
	}
	if (_room >= before) {
		_slot_of_tile.grow_to(_room);
		return;
	}
	_slot_of_tile.reserve(_room);
	for (const int slot : _used) {
		_slot_of_tile.insert(_places[size_t(slot)].tile.x, _places[size_t(slot)].tile.z, slot);
	}
	if (!r_moves.empty()) {
		_moved_step = _step_number;
	}
	forget_step();
}

// Forgets what the last step found: its tiles have other slots now, or none.
void TileManager::forget_step() {
	_record_count = 0;
	_followers = {};
	_collider_list.clear();
	_meetings.forget();
	_statistics.awake = _used.count();
}

// Returns a slot for a tile that wakes: a free one, or a new one, or that of a calm tile. p_wanted: how many slots this step still needs.
int TileManager::take_slot(size_t p_wanted) {
	if (_used.count() >= get_limit()) {
		return take_calmest_slot(p_wanted);
	}
	const int slot = _free.take_lowest();
	if (slot != SlotSet::NONE) {
		return slot;
	}
	std::vector<SlotMove> none;
	set_room(_room_plan.find_possible(std::min(_room + int(p_wanted), get_limit()), _room, _params.pool_size), none);
	return _free.take_lowest();
}

// Tiles that nothing touches count as if out of view: they give way first, as within a field.
PoolDemand TileManager::find_demand() {
	PoolDemand demand;
	demand.most = _params.pool_size;
	_view.prepare(_grid, _params); // cameras may have moved since the last step
	for (const int slot : _used) {
		const TileBounds::Tile tile = _places[size_t(slot)].tile;
		const bool is_met = _motions[size_t(slot)].met_step == uint32_t(_step_number);
		demand.tiles[size_t(
				is_met ? _view.get_band({ tile.x, tile.x + 1, tile.z, tile.z + 1 }, TileParams::HELD_MARGIN) : TileView::UNSEEN)]++;
	}
	for (const TileMeetings::Waiting &waiting : _meetings.get_waiting()) {
		demand.tiles[size_t(waiting.band)]++;
	}
	const int others = _meetings.count_refused() - int(_meetings.get_waiting().size());
	demand.tiles[_view.sees_all() ? 0 : TileView::UNSEEN] += std::max(others, 0);
	return demand;
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
