// SPDX-License-Identifier: MIT
// Which tiles wake, and who gives way. How they sleep: tiles_sleep.cpp; what comes of it: tiles_records.cpp.
#include "core/tiles.h"

#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <numeric>

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
	params.reach = limit(reach, 100.0, defaults.reach);
	params.low = std::isfinite(low) ? low : defaults.low;
	params.height = std::isfinite(height) ? height : defaults.height;
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
	_awake.assign(size_t(_params.pool_size), {});
	_marks.assign(size_t(_params.pool_size), {});
	_places.assign(size_t(_params.pool_size), {});
	_lives.assign(size_t(_params.pool_size), {});
	_bends.clear();
	_reported_step = _bend_step = 0;
	_free.reset(_params.pool_size, true);
	_used.reset(_params.pool_size, false);
	_touched.reset(_params.pool_size, false);
	_stirred.reset(_params.pool_size, false);
	_slot_of_tile.reserve(_params.pool_size);
	_place_of_tile.clear();
	_touches.clear();
	_records.clear();
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
	deactivate_tiles(delta); // lines 18 to 25
	count_touches(p_colliders);
	write_records();
	write_list();
}

void TileManager::begin_step() {
	_touches.clear();
	_to_activate.clear();
	_yielding_known = false;
	_records.clear();
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
	const size_t before = _touches.size();
	const TileRange squares = SlotMap::squares_of(p_range);
	_met.resize(size_t(p_range.width()));
	for (int z = p_range.z_begin; z < p_range.z_end; z++) {
		const SlotMap::Square *const *row = p_squares + (z / SlotMap::SIDE - squares.z_begin) * squares.width();
		int count = p_range.width();
		if (_bounds) {
			count = _bounds->find_met(p_range.x_begin, p_range.x_end, z, p_swept, _met.data());
		} else {
			std::iota(_met.begin(), _met.end(), p_range.x_begin);
		}
		for (int n = 0; n < count; n++) {
			const int x = _met[size_t(n)], slot = row[x / SlotMap::SIDE - squares.x_begin]->at(x, z);
			if (slot != SlotMap::NONE) { // its mark is left alone, which is far away in memory
				_touched.insert(slot);
				if (p_moves) {
					_stirred.insert(slot);
				}
				_touches.push_back({ slot, p_collider });
			} else {
				touch_asleep(_grid.get_index(x, z), p_collider);
			}
		}
	}
	return _touches.size() > before;
}

// The tiles whose box could meet the collider's: squares grown by the farthest reach, lowest ground to highest tip.
TileRange TileManager::find_range(const Bounds &p_swept) const {
	if (p_swept.max.y() < _params.low || p_swept.min.y() > _params.height) {
		return {};
	}
	return _grid.get_range(p_swept.min.x(), p_swept.max.x(), p_swept.min.z(), p_swept.max.z(), _params.reach);
}

void TileManager::touch_asleep(int p_tile, uint32_t p_collider) {
	int place = _place_of_tile.find(p_tile);
	if (place == TileMap::NONE) {
		place = int(_to_activate.size());
		_to_activate.push_back(p_tile);
		_place_of_tile.insert(p_tile, place);
	}
	_touches.push_back({ ~place, p_collider });
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
	_places[size_t(p_slot)] = { x, z, p_tile, grass_tile_start(uint32_t(x), uint32_t(z), _params.seed) };
	_awake[size_t(p_slot)] = {};
	_lives[size_t(p_slot)] = { _step_number, 0.0 };
	Mark &mark = _marks[size_t(p_slot)];
	mark = {};
	mark.is_fresh = true;
	_touched.insert(p_slot); // deactivate_tiles() sets the timestamps
	_stirred.insert(p_slot);
	_slot_of_tile.insert(x, z, p_slot);
	_used.insert(p_slot);
	_statistics.woken++;
}

// The slot of the calmest tile that no object touches in this step, retired; NONE if all are touched: two tiles under
// objects would otherwise take the slot from each other in every step. p_wanted: how many slots are asked for in this
// step from now on.
int TileManager::take_calmest_slot(size_t p_wanted) {
	if (!_yielding_known) {
		_yielding_known = true;
		find_yielding(p_wanted);
	}
	if (_yielding.empty()) {
		return SlotSet::NONE;
	}
	const int slot = int(_yielding.back() & ((1 << SLOT_BITS) - 1));
	_yielding.pop_back();
	retire(slot);
	return slot;
}

TileManager::Calm TileManager::calm_of(int p_slot) const {
	const Awake &awake = _awake[size_t(p_slot)];
	constexpr uint32_t OLDEST = (1u << AGE_BITS) - 1;
	const uint32_t age = std::min(uint32_t(_step_number) - awake.touched_step, OLDEST); // steps since the last touch
	const Calm is_up = _marks[size_t(p_slot)].is_settling ? 0 : 1;
	return (((is_up << 31 | std::bit_cast<uint32_t>(awake.energy)) << AGE_BITS) | (OLDEST - age)) << SLOT_BITS | Calm(p_slot);
}

// The calmest p_wanted tiles, calmest last.
void TileManager::find_yielding(size_t p_wanted) {
	constexpr size_t SAMPLES = 64;
	_calm.resize(size_t(_params.pool_size));
	_yielding.resize(size_t(_params.pool_size));
	size_t count = 0;
	for (const int slot : _used) {
		_calm[count] = calm_of(slot);
		count += _touched.has(slot) ? 0 : 1; // no jump: it could not be foreseen
	}
	// Few of many are wanted: a sample tells about how calm they are, and all others are out without being sorted.
	Calm bound = ~Calm(0);
	if (count > SAMPLES * 4) {
		std::array<Calm, SAMPLES> samples;
		for (size_t i = 0; i < SAMPLES; i++) {
			samples[i] = _calm[i * count / SAMPLES];
		}
		std::sort(samples.begin(), samples.end());
		const size_t rank = p_wanted * SAMPLES / count + SAMPLES / 16;
		bound = rank < SAMPLES ? samples[rank] : bound;
	}
	size_t chosen = 0;
	for (size_t i = 0; i < count; i++) {
		_yielding[chosen] = _calm[i];
		chosen += _calm[i] <= bound ? 1 : 0;
	}
	if (chosen < p_wanted) { // the sample was wrong
		std::copy_n(_calm.begin(), count, _yielding.begin());
		chosen = count;
	}
	_yielding.resize(chosen);
	if (p_wanted < chosen) {
		std::nth_element(_yielding.begin(), _yielding.begin() + std::ptrdiff_t(p_wanted), _yielding.end());
		_yielding.resize(p_wanted);
	}
	std::sort(_yielding.begin(), _yielding.end(), std::greater());
}

int TileManager::get_slot_of(int p_tile) const {
	const bool exists = p_tile >= 0 && p_tile < _grid.get_tile_count();
	return exists ? _slot_of_tile.find(_grid.get_x(p_tile), _grid.get_z(p_tile)) : GRASS_NO_SLOT;
}

int TileManager::get_tile_of(int p_slot) const {
	return p_slot >= 0 && p_slot < _params.pool_size ? _places[size_t(p_slot)].tile : TileMap::NONE;
}

bool TileManager::is_awake(int p_tile) const {
	return get_slot_of(p_tile) != GRASS_NO_SLOT;
}

bool TileManager::is_settling(int p_tile) const {
	const int slot = get_slot_of(p_tile);
	return slot != GRASS_NO_SLOT && _marks[size_t(slot)].is_settling;
}

Eigen::Vector3f TileManager::get_bend(int p_tile) const {
	const int slot = get_slot_of(p_tile);
	const bool is_known = slot != GRASS_NO_SLOT && size_t(slot) < _bends.size() && _bend_step >= _lives[size_t(slot)].woken_step;
	return is_known && _bends[size_t(slot)].allFinite() ? _bends[size_t(slot)] : Eigen::Vector3f(Eigen::Vector3f::Zero());
}

size_t TileManager::get_memory_usage() const {
	const auto bytes = [](const auto &p_vector) { return p_vector.capacity() * sizeof(p_vector[0]); };
	return bytes(_awake) + bytes(_marks) + bytes(_places) + bytes(_lives) + bytes(_bends) + _free.get_memory_usage() +
			_used.get_memory_usage() + _touched.get_memory_usage() + _stirred.get_memory_usage() + _slot_of_tile.get_memory_usage() +
			bytes(_ranges) + bytes(_swept) + bytes(_has_met) + bytes(_touches) + bytes(_met) + bytes(_squares) + bytes(_to_activate) +
			bytes(_given_slots) + _place_of_tile.get_memory_usage() + bytes(_calm) + bytes(_yielding) + bytes(_records) +
			bytes(_colliders) + bytes(_collider_list) + bytes(_planes);
}

} // namespace grass
