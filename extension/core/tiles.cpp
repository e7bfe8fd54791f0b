// SPDX-License-Identifier: MIT
// Which tiles wake. Who gives way: tiles_yield.cpp; how they sleep: tiles_sleep.cpp; what comes of it: tiles_records.cpp.
#include "core/tiles.h"

#include <cmath>

namespace grass {

namespace {

double limit(double p_value, double p_max, double p_default) {
	return std::isnan(p_value) ? p_default : std::clamp(p_value, 0.0, p_max);
}

// At most p_limit tiles of the range: those around (p_x, p_z).
TileRange shrink(const TileRange &p_range, int64_t p_limit, int p_x, int p_z) {
	if (p_range.count() <= p_limit) {
		return p_range;
	}
	if (p_limit <= 0) {
		return {};
	}
	int width = std::min(p_range.width(), std::max(1, int(std::sqrt(double(p_limit)))));
	const int depth = int(std::min<int64_t>(p_range.depth(), p_limit / width));
	width = int(std::min<int64_t>(p_range.width(), p_limit / depth));
	TileRange range;
	range.x_begin = std::clamp(p_x - width / 2, p_range.x_begin, p_range.x_end - width);
	range.z_begin = std::clamp(p_z - depth / 2, p_range.z_begin, p_range.z_end - depth);
	range.x_end = range.x_begin + width;
	range.z_end = range.z_begin + depth;
	return range;
}

} // namespace

TileParams TileParams::sanitised() const {
	const TileParams defaults;
	TileParams params = *this;
	params.pool_size = std::clamp(pool_size, 0, MAX_POOL_SIZE);
	params.sleep_delay = limit(sleep_delay, 3600.0, defaults.sleep_delay);
	params.sleep_energy = limit(sleep_energy, 1e6, defaults.sleep_energy);
	params.settle_time = limit(settle_time, 60.0, defaults.settle_time);
	params.still_delay = limit(still_delay, 3600.0, defaults.still_delay);
	params.reach = limit(reach, 100.0, defaults.reach);
	params.low = std::isfinite(low) ? low : defaults.low;
	params.height = std::isfinite(height) ? height : defaults.height;
	params.segment = limit(segment, 100.0, defaults.segment);
	return params;
}

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
}

void TileManager::reset() {
	_time = 0.0;
	_has_passed_unseen = false;
	_times.assign(size_t(_params.pool_size), {});
	_motions.assign(size_t(_params.pool_size), {});
	_places.assign(size_t(_params.pool_size), {});
	_lives.assign(size_t(_params.pool_size), {});
	_entries.assign(size_t(_params.pool_size), 0);
	_signatures.assign(size_t(_params.pool_size), 0);
	_signatures_before.assign(size_t(_params.pool_size), 0);
	_bends.clear();
	_reported_step = _bend_step = 0;
	_free.reset(_params.pool_size, true);
	for (SlotSet *set : { &_used, &_settling, &_touched, &_stirred, &_left, &_fresh, &_unseen, &_sharp }) {
		set->reset(_params.pool_size, false);
	}
	_slot_of_tile.reserve(_params.pool_size);
	_place_of_tile.clear();
	_touches.clear();
	_records.assign(2 * size_t(_params.pool_size), {}); // each slot may be given away and live on
	_record_count = 0;
	_colliders.clear();
	_collider_list.clear();
	_planes.clear();
	_statistics = {};
}

// Algorithm 1. One line each of the paper's three loops is one function here.
void TileManager::update(double p_delta, std::span<ColliderShape> p_colliders) {
	const double delta = std::isfinite(p_delta) ? std::max(p_delta, 0.0) : 0.0;
	_time += delta;
	_step_number++;
	begin_step();
	find_touched_tiles(p_colliders); // lines 1 to 9
	activate_tiles(); // lines 11 to 16
	sign_touches(p_colliders);
	deactivate_tiles(delta); // lines 18 to 25
	count_touches(p_colliders);
	write_records();
	write_list();
}

void TileManager::begin_step() {
	_touches.clear();
	_to_activate.clear();
	_yielding_known = false;
	_record_count = 0;
	find_tile_frustums();
}

void TileManager::find_touched_tiles(std::span<ColliderShape> p_colliders) {
	_ranges.clear();
	_swept.clear();
	_has_met.assign(p_colliders.size(), 0);
	int64_t total = 0;
	for (ColliderShape &collider : p_colliders) {
		const char *reason = nullptr;
		const bool is_good = collider.sanitise(reason);
		_statistics.bad_colliders += is_good ? 0 : 1;
		_swept.push_back(is_good ? collider.get_swept_bounds() : Bounds{});
		_ranges.push_back(is_good ? find_range(_swept.back()) : TileRange{});
		total += _ranges.back().count();
	}
	// A body over more tiles than the pool holds, or bodies that together fill the list, get those around their centres.
	const int64_t capacity = get_list_capacity();
	const int64_t share = total <= capacity ? capacity : std::max<int64_t>(1, capacity / int64_t(p_colliders.size()));
	const int64_t most = std::min<int64_t>(share, _params.pool_size);
	int64_t left = capacity;
	_squares.clear();
	for (size_t i = 0; i < _ranges.size(); i++) {
		TileRange &range = _ranges[i];
		if (const int64_t limit = std::min(most, left); range.count() > limit) {
			const TilePlace centre = _grid.get_place(p_colliders[i].now.position);
			_statistics.capped += uint64_t(range.count());
			range = shrink(range, limit, centre.x, centre.z);
			_statistics.capped -= uint64_t(range.count());
		}
		_statistics.looked_at += uint64_t(range.count());
		left -= range.count();
		find_squares(range);
	}
	if (_bounds && total > GRASS_START_COUNT / 4) {
		_bounds->prefetch();
	}
	size_t square = 0;
	for (size_t i = 0; i < _ranges.size(); i++) {
		if (_ranges[i].count() > 0) {
			_has_met[i] = touch_range(_ranges[i], &_squares[square], _swept[i], uint32_t(i), p_colliders[i].has_moved()) ? 1 : 0;
			square += size_t(SlotMap::squares_of(_ranges[i]).count());
		}
	}
}

// Those of the range, row by row. For all objects before anything is done with them: what has to be fetched from memory is then
// fetched side by side.
void TileManager::find_squares(const TileRange &p_range) {
	const TileRange squares = SlotMap::squares_of(p_range);
	for (int z = squares.z_begin; z < squares.z_end; z++) {
		for (int x = squares.x_begin; x < squares.x_end; x++) {
			_squares.push_back(&_slot_of_tile.find_square(x * SlotMap::SIDE, z * SlotMap::SIDE));
		}
	}
}

// Touches the tiles of the range, whose squares are p_squares, whose blades' box the collider's meets; whether there is any.
bool TileManager::touch_range(
		const TileRange &p_range, const SlotMap::Square *const *p_squares, const Bounds &p_swept, uint32_t p_collider, bool p_moves) {
	const size_t count = size_t(find_met(p_range, p_swept)), before = _touches.size();
	const TileRange squares = SlotMap::squares_of(p_range);
	const int width = squares.width();
	_touches.resize(before + count);
	for (size_t n = 0; n < count; n++) {
		const int x = _met[n].x, z = _met[n].z;
		int slot = p_squares[(z / SlotMap::SIDE - squares.z_begin) * width + x / SlotMap::SIDE - squares.x_begin]->at(x, z);
		if (slot != SlotMap::NONE) {
			_touched.insert(slot);
			_stirred.insert_if(slot, p_moves);
		} else {
			slot = touch_asleep(_grid.get_index(x, z));
		}
		_touches[before + n] = { slot, p_collider };
	}
	return count > 0;
}

// Writes those tiles of the range to _met whose blades' box the collider's meets; how many.
int TileManager::find_met(const TileRange &p_range, const Bounds &p_swept) {
	_met.resize(std::max(_met.size(), size_t(p_range.count())));
	if (_bounds) {
		return _bounds->find_met(p_range, p_swept, _met.data());
	}
	int count = 0;
	for (int z = p_range.z_begin; z < p_range.z_end; z++) {
		for (int x = p_range.x_begin; x < p_range.x_end; x++) {
			_met[size_t(count++)] = { uint16_t(x), uint16_t(z) };
		}
	}
	return count;
}

// The tiles whose box could meet the collider's: squares grown by the farthest reach, lowest ground to highest tip.
TileRange TileManager::find_range(const Bounds &p_swept) const {
	if (p_swept.max.y() < _params.low || p_swept.min.y() > _params.height) {
		return {};
	}
	return _grid.get_range(p_swept.min.x(), p_swept.max.x(), p_swept.min.z(), p_swept.max.z(), _params.reach);
}

// What stands for the slot in Touch.
int TileManager::touch_asleep(int p_tile) {
	int place = _place_of_tile.find(p_tile);
	if (place == TileMap::NONE) {
		place = int(_to_activate.size());
		_to_activate.push_back(p_tile);
		_place_of_tile.insert(p_tile, place);
	}
	return ~place;
}

void TileManager::activate_tiles() {
	_given_slots.clear();
	for (const int tile : _to_activate) {
		int slot = _free.take_lowest();
		if (slot == SlotSet::NONE) {
			slot = take_calmest_slot(_to_activate.size() - _given_slots.size());
		}
		_given_slots.push_back(slot);
		_place_of_tile.erase(tile);
		if (slot == SlotSet::NONE) {
			_statistics.refused++;
		} else {
			activate(slot, tile);
		}
	}
}

void TileManager::activate(int p_slot, int p_tile) {
	const int x = _grid.get_x(p_tile), z = _grid.get_z(p_tile);
	_places[size_t(p_slot)] = { { uint16_t(x), uint16_t(z) }, grass_tile_start(uint32_t(x), uint32_t(z), _params.seed) };
	_times[size_t(p_slot)] = {};
	_motions[size_t(p_slot)] = {};
	_lives[size_t(p_slot)] = { _step_number, 0.0, 0.0f };
	_fresh.insert(p_slot);
	_touched.insert(p_slot); // deactivate_tiles() sets the timestamps
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
	if (p_slot < 0 || p_slot >= _params.pool_size || !_used.has(p_slot)) {
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
	for (const SlotSet *set : { &_free, &_used, &_settling, &_touched, &_stirred, &_left, &_fresh, &_unseen, &_sharp }) {
		sets += set->get_memory_usage();
	}
	return sets + bytes(_times) + bytes(_motions) + bytes(_places) + bytes(_lives) + bytes(_entries) + bytes(_bends) + bytes(_signatures) +
			bytes(_signatures_before) + _slot_of_tile.get_memory_usage() + bytes(_ranges) + bytes(_swept) + bytes(_has_met) +
			bytes(_touches) + bytes(_met) + bytes(_squares) + bytes(_to_activate) + bytes(_given_slots) +
			_place_of_tile.get_memory_usage() + bytes(_calm) + bytes(_yielding) + bytes(_records) + bytes(_colliders) +
			bytes(_collider_list) + bytes(_planes);
}

} // namespace grass
