// SPDX-License-Identifier: MIT
// Which tiles wake. Other parts: meetings in tile_meetings.cpp, yielding of slots in tiles_yield.cpp, sleep in tiles_sleep.cpp, the
// resulting records in tiles_records.cpp, another size of the pool in tiles_pool.cpp.
#include "core/tiles/tiles.h"

#include <cmath>

namespace grass {

void TileManager::set_grid(const TileGrid &p_grid) {
	if (!(p_grid == _grid)) {
		_grid = p_grid;
		reset();
	}
}

void TileManager::set_params(const TileParams &p_params) {
	const TileParams before = _params;
	_params = p_params.sanitised();
	if (_params.pool_size != before.pool_size || _params.seed != before.seed) {
		reset();
	}
	if (!(_params == before)) {
		_meetings.forget();
	}
}

void TileManager::reset() {
	_time = 0.0;
	_has_passed_unseen = false;
	_used.clear();
	std::vector<SlotMove> moves; // none
	set_room(0, moves);
	_followers.clear();
	_bends.clear();
	_reported_step = _bend_step = 0;
	_room_plan.reset();
	_meetings.reset();
	_record_count = 0;
	_colliders.clear();
	_collider_list.clear();
	_statistics = {};
}

// Runs Algorithm 1. Each line of the paper's three loops is one function here.
void TileManager::update(double p_delta, std::span<ColliderShape> p_colliders, const ParallelFor &p_parallel_for) {
	const double delta = std::isfinite(p_delta) ? std::max(p_delta, 0.0) : 0.0;
	_time += delta;
	_step_number++;
	begin_step();
	_meetings.find(
			{ _grid, _params, get_limit(), _room, _bounds.get(), _view, _slot_of_tile, _held, _yielded, _met, _stirred, _statistics },
			p_colliders, p_parallel_for); // lines 1 to 9
	activate_tiles(); // lines 11 to 16
	sign_meetings(p_colliders);
	deactivate_tiles(delta); // lines 18 to 25
	count_meetings(p_colliders);
	write_records();
	write_list();
}

void TileManager::begin_step() {
	_yielding_known = false;
	_record_count = 0;
	_view.prepare(_grid, _params);
	yield_to_waiting();
}

void TileManager::activate_tiles() {
	const int needed = std::min(_used.count() + int(_meetings.get_wanted().size()), get_limit());
	const int next = _room_plan.find_next(needed, _room, _params.pool_size);
	if (needed > next) { // tiles for which there are no slots yet are met again in the next step
		_meetings.hold_back(size_t(next - _used.count()));
	}
	_given_slots.clear();
	const std::vector<int> &wanted = _meetings.get_wanted();
	for (const int tile : wanted) {
		_given_slots.push_back(take_slot(wanted.size() - _given_slots.size()));
		activate(_given_slots.back(), tile);
	}
}

void TileManager::activate(int p_slot, int p_tile) {
	const int x = _grid.get_x(p_tile), z = _grid.get_z(p_tile);
	_places[size_t(p_slot)] = { { uint16_t(x), uint16_t(z) }, grass_tile_start(uint32_t(x), uint32_t(z), _params.seed) };
	_times[size_t(p_slot)] = {};
	_motions[size_t(p_slot)] = {};
	_lives[size_t(p_slot)] = { _step_number, 0.0, 0.0f };
	const int drawn = _detail.blades_of(x, z, 0);
	_blades[size_t(p_slot)] = { uint8_t(drawn), uint8_t(_detail.simulated_of(x, z, 0, drawn)), 0 };
	_fresh.insert(p_slot);
	_met.insert(p_slot); // deactivate_tiles() sets the timestamps
	_stirred.insert(p_slot);
	_slot_of_tile.insert(x, z, p_slot);
	_used.insert(p_slot);
	_statistics.woken++;
}

int TileManager::get_slot_of(int p_tile) const {
	const bool exists = p_tile >= 0 && p_tile < _grid.get_tile_count();
	return exists ? _slot_of_tile.find(_grid.get_x(p_tile), _grid.get_z(p_tile)) : GRASS_NO_SLOT;
}

int TileManager::get_tile_of(int p_slot) const {
	if (p_slot < 0 || p_slot >= _room || !_used.has(p_slot)) {
		return TileMap::NONE;
	}
	const TileBounds::Tile tile = _places[size_t(p_slot)].tile;
	return _grid.get_index(tile.x, tile.z);
}

bool TileManager::is_awake(int p_tile) const {
	return get_slot_of(p_tile) != GRASS_NO_SLOT;
}

bool TileManager::is_settling(int p_tile) const {
	const int slot = get_slot_of(p_tile);
	return slot != GRASS_NO_SLOT && _settling.has(slot);
}

Eigen::Vector3f TileManager::get_bend(int p_tile) const {
	const int slot = get_slot_of(p_tile);
	const bool is_known = slot != GRASS_NO_SLOT && size_t(slot) < _bends.size() && _bend_step >= _lives[size_t(slot)].woken_step;
	return is_known && _bends[size_t(slot)].allFinite() ? _bends[size_t(slot)] : Eigen::Vector3f(Eigen::Vector3f::Zero());
}

size_t TileManager::get_memory_usage() const {
	const auto bytes = [](const auto &p_vector) { return p_vector.capacity() * sizeof(p_vector[0]); };
	size_t sets = 0;
	for (const SlotSet *set : { &_free, &_used, &_settling, &_held, &_met, &_stirred, &_unmet, &_fresh, &_skipped, &_simulated }) {
		sets += set->get_memory_usage();
	}
	return sets + _detail.get_memory_usage() + bytes(_times) + bytes(_motions) + bytes(_places) + bytes(_lives) + bytes(_blades) +
			bytes(_entries) + bytes(_forces) + bytes(_air) + bytes(_bends) + bytes(_signatures) + bytes(_signatures_before) +
			_slot_of_tile.get_memory_usage() + _meetings.get_memory_usage() + bytes(_given_slots) + bytes(_calm) + bytes(_yielding) +
			bytes(_yielded) + bytes(_seen_worst) + bytes(_widened) + bytes(_followers) + bytes(_records) + _colliders.get_memory_usage() +
			bytes(_collider_list);
}

} // namespace grass
