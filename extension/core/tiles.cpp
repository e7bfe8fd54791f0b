// SPDX-License-Identifier: MIT
#include "core/tiles.h"

#include <cmath>
#include <limits>

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
	params.settle_time = limit(settle_time, 60.0, defaults.settle_time);
	params.reach = limit(reach, 100.0, defaults.reach);
	params.height = limit(height, 100.0, defaults.height);
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
	_awake.assign(size_t(_params.pool_size), {});
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
	begin_step();
	find_touched_tiles(p_colliders); // lines 1 to 9
	activate_tiles(); // lines 11 to 16
	deactivate_tiles(delta); // lines 18 to 25
	write_lists(p_colliders);
	write_records();
}

void TileManager::begin_step() {
	for (int slot = _used.find(0); slot != SlotSet::NONE; slot = _used.find(slot + 1)) {
		Awake &awake = _awake[size_t(slot)];
		awake.is_touched = awake.is_fresh = false;
		awake.list_count = 0;
	}
	_touches.clear();
	_to_activate.clear();
	_yielding_known = false;
	_records.clear();
}

void TileManager::find_touched_tiles(std::span<ColliderShape> p_colliders) {
	_ranges.clear();
	_swept.clear();
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
		for (int z = range.z_begin; z < range.z_end; z++) {
			for (int x = range.x_begin; x < range.x_end; x++) {
				if (!_bounds || _bounds->meets(x, z, _swept[i])) {
					touch(_grid.get_index(x, z), uint32_t(i));
				}
			}
		}
	}
}

// The tiles whose box could meet the collider's: squares grown by the farthest reach, ground to the highest tip.
TileRange TileManager::find_range(const Bounds &p_swept) const {
	if (p_swept.max.y() < 0.0 || p_swept.min.y() > _params.height) {
		return {};
	}
	return _grid.get_range(p_swept.min.x(), p_swept.max.x(), p_swept.min.z(), p_swept.max.z(), _params.reach);
}

void TileManager::touch(int p_tile, uint32_t p_collider) {
	const int slot = _slot_of_tile.find(p_tile);
	if (slot != TileMap::NONE) {
		_awake[size_t(slot)].is_touched = true;
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
			slot = take_calmest_slot();
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
	awake.is_fresh = awake.is_touched = true;
	_slot_of_tile.insert(p_tile, p_slot);
	_used.insert(p_slot);
	_statistics.woken++;
}

// The slot of the calmest tile that no object touches in this step, retired; NONE if all are touched: two tiles under
// objects would otherwise take the slot from each other in every step.
int TileManager::take_calmest_slot() {
	const auto is_less = [this](int p_a, int p_b) { return is_calmer(p_b, p_a); };
	if (!_yielding_known) {
		_yielding_known = true;
		_yielding.clear();
		for (int slot = _used.find(0); slot != SlotSet::NONE; slot = _used.find(slot + 1)) {
			if (!_awake[size_t(slot)].is_touched) {
				_yielding.push_back(slot);
			}
		}
		std::make_heap(_yielding.begin(), _yielding.end(), is_less);
	}
	if (_yielding.empty()) {
		return SlotSet::NONE;
	}
	std::pop_heap(_yielding.begin(), _yielding.end(), is_less);
	const int slot = _yielding.back();
	_yielding.pop_back();
	retire(slot);
	return slot;
}

// Settling tiles before others, then by energy where it was reported, then by who was touched longest ago.
bool TileManager::is_calmer(int p_slot, int p_other) const {
	const Awake &a = _awake[size_t(p_slot)], &b = _awake[size_t(p_other)];
	if (a.is_settling != b.is_settling) {
		return a.is_settling;
	}
	if (a.energy != b.energy) {
		return a.energy < b.energy;
	}
	return a.touched != b.touched ? a.touched < b.touched : p_slot < p_other;
}

void TileManager::deactivate_tiles(double p_delta) {
	for (int slot = _used.find(0); slot != SlotSet::NONE; slot = _used.find(slot + 1)) {
		Awake &awake = _awake[size_t(slot)];
		if (awake.is_touched) {
			awake.touched = _time;
			awake.is_settling = false;
			awake.blend = 0.0f;
		} else if (awake.blend >= 1.0f) {
			retire(slot);
			_free.insert(slot);
		} else if (should_settle(awake)) {
			settle(awake, p_delta);
		}
	}
}

// The policy of going to sleep: the paper's delay since the last touch.
bool TileManager::should_settle(const Awake &p_awake) const {
	return p_awake.is_settling || _time - p_awake.touched >= _params.sleep_delay;
}

// Takes the share of what is left of the way that brings the tile to rest in settle_time at even pace.
void TileManager::settle(Awake &r_awake, double p_delta) {
	if (!r_awake.is_settling) {
		r_awake.is_settling = true;
		r_awake.settle_left = _params.settle_time;
	}
	// What rounding leaves of a step is no step of its own.
	const bool arrives = r_awake.settle_left <= p_delta * 1.0001;
	r_awake.blend = arrives ? 1.0f : float(p_delta / r_awake.settle_left);
	r_awake.settle_left -= p_delta;
}

// Announces that the slot's tile is at rest from now on. The slot is its caller's.
void TileManager::retire(int p_slot) {
	Awake &awake = _awake[size_t(p_slot)];
	(awake.blend >= 1.0f ? _statistics.slept : _statistics.evicted)++;
	_records.push_back({ awake.tile, { awake.start, 0, 0, GRASS_SLOT_RETIRED }, {} });
	_slot_of_tile.erase(awake.tile.z);
	_used.erase(p_slot);
	awake = {};
}

// Sorts the touches by slot, each tile's objects in the order in which they were given; packs the objects in use.
void TileManager::write_lists(std::span<const ColliderShape> p_colliders) {
	_colliders.clear();
	_planes.clear();
	size_t kept = 0;
	uint32_t last = std::numeric_limits<uint32_t>::max();
	for (const Touch &touch : _touches) { // rising by collider
		const int slot = touch.slot >= 0 ? touch.slot : _given_slots[size_t(~touch.slot)];
		if (slot != SlotSet::NONE) {
			if (touch.collider != last) {
				last = touch.collider;
				pack_collider(p_colliders[last]);
			}
			_awake[size_t(slot)].list_count++;
			_touches[kept++] = { slot, uint32_t(_colliders.size() - 1) };
		}
	}
	_touches.resize(kept);
	uint32_t end = 0;
	for (int slot = _used.find(0); slot != SlotSet::NONE; slot = _used.find(slot + 1)) {
		_awake[size_t(slot)].list_begin = end;
		end += _awake[size_t(slot)].list_count;
		_awake[size_t(slot)].list_count = 0;
	}
	_collider_list.resize(kept);
	for (const Touch &touch : _touches) {
		Awake &awake = _awake[size_t(touch.slot)];
		_collider_list[awake.list_begin + awake.list_count++] = touch.collider;
	}
	_statistics.colliders = int(_colliders.size());
	_statistics.list_entries = int(kept);
}

void TileManager::pack_collider(const ColliderShape &p_collider) {
	_colliders.push_back(p_collider.pack(_grid, int(_planes.size())));
	if (p_collider.type == GRASS_HULL) {
		_planes.insert(_planes.end(), p_collider.planes.begin(), p_collider.planes.end());
	}
}

void TileManager::write_records() {
	_statistics.awake = _statistics.settling = 0;
	for (int slot = _used.find(0); slot != SlotSet::NONE; slot = _used.find(slot + 1)) {
		const Awake &awake = _awake[size_t(slot)];
		const uint32_t flags = (awake.is_fresh ? GRASS_SLOT_FRESH : 0) | (awake.is_settling ? GRASS_SLOT_SETTLING : 0);
		_records.push_back({ awake.tile, { awake.start, awake.list_begin, awake.list_count, flags }, { awake.blend, 0.0f, 0.0f, 0.0f } });
		(awake.is_settling ? _statistics.settling : _statistics.awake)++;
	}
	_statistics.high_water = std::max(_statistics.high_water, _statistics.awake + _statistics.settling);
}

void TileManager::report_energy(int p_slot, int p_tile, float p_energy) {
	if (get_tile_of(p_slot) == p_tile && p_tile != TileMap::NONE && std::isfinite(p_energy)) {
		_awake[size_t(p_slot)].energy = std::max(p_energy, 0.0f);
	}
}

int TileManager::get_tile_of(int p_slot) const {
	return p_slot >= 0 && p_slot < _params.pool_size ? _awake[size_t(p_slot)].tile.z : TileMap::NONE;
}

bool TileManager::is_awake(int p_tile) const {
	const int slot = get_slot_of(p_tile);
	return slot != GRASS_NO_SLOT && !_awake[size_t(slot)].is_settling;
}

size_t TileManager::get_memory_usage() const {
	const auto bytes = [](const auto &p_vector) { return p_vector.capacity() * sizeof(p_vector[0]); };
	return bytes(_awake) + _free.get_memory_usage() + _used.get_memory_usage() + _slot_of_tile.get_memory_usage() + bytes(_ranges) +
			bytes(_swept) + bytes(_touches) + bytes(_to_activate) + bytes(_given_slots) + _place_of_tile.get_memory_usage() +
			bytes(_yielding) + bytes(_records) + bytes(_colliders) + bytes(_collider_list) + bytes(_planes);
}

} // namespace grass
