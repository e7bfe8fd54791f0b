// SPDX-License-Identifier: MIT
// Which tiles wake, and who gives way. How they sleep: tiles_sleep.cpp; what comes of it: tiles_records.cpp.
#include "core/tiles.h"

#include <cmath>
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
	_free.reset(_params.pool_size, true);
	_used.reset(_params.pool_size, false);
	_slot_of_tile.reserve(_params.pool_size);
	_place_of_tile.reserve(get_list_capacity());
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
	for (size_t i = 0; i < _ranges.size(); i++) {
		const TilePlace centre = _ranges[i].count() > 0 ? _grid.get_place(p_colliders[i].now.position) : TilePlace{};
		const TileRange range = shrink(_ranges[i], std::min(most, capacity - int64_t(_touches.size())), centre.x, centre.z);
		_statistics.capped += uint64_t(_ranges[i].count() - range.count());
		_statistics.looked_at += uint64_t(range.count());
		if (range.count() > 0) {
			_has_met[i] = touch_range(range, _swept[i], uint32_t(i), p_colliders[i].has_moved()) ? 1 : 0;
		}
	}
}

// Touches the tiles of the range whose blades' box the collider's meets; whether there is any.
bool TileManager::touch_range(const TileRange &p_range, const Bounds &p_swept, uint32_t p_collider, bool p_moves) {
	const size_t before = _touches.size();
	_met.resize(size_t(p_range.width()));
	for (int z = p_range.z_begin; z < p_range.z_end; z++) {
		int count = p_range.width();
		if (_bounds) {
			count = _bounds->find_met(p_range.x_begin, p_range.x_end, z, p_swept, _met.data());
		} else {
			std::iota(_met.begin(), _met.end(), p_range.x_begin);
		}
		for (int n = 0; n < count; n++) {
			touch(_grid.get_index(_met[size_t(n)], z), p_collider, p_moves);
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

void TileManager::touch(int p_tile, uint32_t p_collider, bool p_moves) {
	const int slot = _slot_of_tile.find(p_tile);
	if (slot != TileMap::NONE) {
		Mark &mark = _marks[size_t(slot)];
		mark.is_touched = true;
		mark.is_stirred = mark.is_stirred || p_moves;
		_touches.push_back({ slot, p_collider });
		return;
	}
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
	Awake &awake = _awake[size_t(p_slot)];
	awake = {};
	awake.tile = { x, z, p_tile, p_slot };
	awake.start = grass_tile_start(uint32_t(x), uint32_t(z), _params.seed);
	awake.woken_step = _step_number;
	Mark &mark = _marks[size_t(p_slot)];
	mark.is_fresh = mark.is_touched = mark.is_stirred = true; // touched: deactivate_tiles() sets the timestamps
	_slot_of_tile.insert(p_tile, p_slot);
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
	const int slot = _yielding.back().slot;
	_yielding.pop_back();
	retire(slot);
	return slot;
}

// The calmest p_wanted tiles, calmest last.
void TileManager::find_yielding(size_t p_wanted) {
	_yielding.resize(size_t(_params.pool_size));
	size_t count = 0;
	for (const int slot : _used) {
		const Awake &awake = _awake[size_t(slot)];
		_yielding[count] = { awake.touched, awake.energy, slot, awake.is_settling };
		count += _marks[size_t(slot)].is_touched ? 0 : 1; // no jump: it could not be foreseen
	}
	_yielding.resize(count);
	const auto is_calmer = [](const Yielding &p_a, const Yielding &p_b) { return p_a.is_calmer(p_b); };
	if (p_wanted < _yielding.size()) {
		std::nth_element(_yielding.begin(), _yielding.begin() + std::ptrdiff_t(p_wanted), _yielding.end(), is_calmer);
		_yielding.resize(p_wanted);
	}
	std::sort(_yielding.begin(), _yielding.end(), is_calmer);
	std::reverse(_yielding.begin(), _yielding.end());
}

int TileManager::get_tile_of(int p_slot) const {
	return p_slot >= 0 && p_slot < _params.pool_size ? _awake[size_t(p_slot)].tile.z : TileMap::NONE;
}

bool TileManager::is_awake(int p_tile) const {
	return get_slot_of(p_tile) != GRASS_NO_SLOT;
}

bool TileManager::is_settling(int p_tile) const {
	const int slot = get_slot_of(p_tile);
	return slot != GRASS_NO_SLOT && _awake[size_t(slot)].is_settling;
}

Eigen::Vector3f TileManager::get_bend(int p_tile) const {
	const int slot = get_slot_of(p_tile);
	return slot == GRASS_NO_SLOT ? Eigen::Vector3f(Eigen::Vector3f::Zero()) : _awake[size_t(slot)].bend;
}

size_t TileManager::get_memory_usage() const {
	const auto bytes = [](const auto &p_vector) { return p_vector.capacity() * sizeof(p_vector[0]); };
	return bytes(_awake) + bytes(_marks) + _free.get_memory_usage() + _used.get_memory_usage() + _slot_of_tile.get_memory_usage() +
			bytes(_ranges) + bytes(_swept) + bytes(_has_met) + bytes(_touches) + bytes(_met) + bytes(_to_activate) + bytes(_given_slots) +
			_place_of_tile.get_memory_usage() + bytes(_yielding) + bytes(_records) + bytes(_colliders) + bytes(_collider_list) +
			bytes(_planes);
}

} // namespace grass
