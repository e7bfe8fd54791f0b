// SPDX-License-Identifier: MIT
// Which tiles colliders meet: lines 1 to 9 of Algorithm 1 of Fan et al. 2015.
#include "core/tiles/tiles.h"

#include <algorithm>
#include <cmath>

namespace grass {

namespace {

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

void TileManager::find_met_tiles(std::span<ColliderShape> p_colliders) {
	_ranges.clear();
	_swept.clear();
	_range_colliders.clear();
	_has_met.assign(p_colliders.size(), 0);
	int64_t total = 0;
	for (ColliderShape &collider : p_colliders) {
		const char *reason = nullptr;
		const bool is_good = collider.sanitise(reason);
		_statistics.bad_colliders += is_good ? 0 : 1;
		if (is_good) {
			add_ranges(collider, uint32_t(&collider - p_colliders.data()));
		}
	}
	for (const TileRange &range : _ranges) {
		total += range.count();
	}
	// A body over more tiles than the pool holds, or bodies that together fill the list, get those around their centres.
	const int64_t capacity = get_list_capacity();
	const int64_t share = total <= capacity ? capacity : std::max<int64_t>(1, capacity / int64_t(_ranges.size()));
	const int64_t most = std::min<int64_t>(share, _params.pool_size);
	int64_t left = capacity;
	_squares.clear();
	for (size_t i = 0; i < _ranges.size(); i++) {
		TileRange &range = _ranges[i];
		if (const int64_t limit = std::min(most, left); range.count() > limit) {
			const TilePlace centre = _grid.get_place(p_colliders[_range_colliders[i]].now.position);
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
		const uint32_t collider = _range_colliders[i];
		if (_ranges[i].count() > 0) {
			const bool moves = p_colliders[collider].has_moved();
			const bool meets = meet_range(_ranges[i], &_squares[square], _swept[i], collider, moves);
			_has_met[collider] = _has_met[collider] != 0 || meets ? 1 : 0;
			square += size_t(SlotMap::squares_of(_ranges[i]).count());
		}
		const bool ends = i + 1 == _ranges.size() || _range_colliders[i + 1] != collider;
		if (ends && i > 0 && _range_colliders[i - 1] == collider) {
			meet_once(collider);
		}
	}
}

// The tiles that the collider may meet: those under the box around all of its way. Where these are more than can be awake, those under
// boxes around pieces of it: what crosses the field aslant in one step passes over few of the tiles between its ends.
void TileManager::add_ranges(const ColliderShape &p_collider, uint32_t p_index) {
	constexpr double MOST_PIECES = 256.0;
	const auto add = [&](const Bounds &p_swept, const TileRange &p_range) {
		_swept.push_back(p_swept);
		_ranges.push_back(p_range);
		_range_colliders.push_back(p_index);
	};
	const Bounds swept = p_collider.get_swept_bounds();
	const TileRange range = find_range(swept);
	const Eigen::Vector3d way = p_collider.now.position - p_collider.before.position;
	const double own = std::max(2.0 * p_collider.get_half_extents().norm(), 2.0 * _grid.get_tile_size());
	const double pieces = std::min(std::ceil(std::hypot(way.x(), way.z()) / own), MOST_PIECES);
	if (range.count() <= _params.pool_size || pieces < 2.0) {
		add(swept, range);
		return;
	}
	ColliderShape piece = p_collider;
	for (double i = 0.0; i < pieces; i += 1.0) {
		piece.before.position = p_collider.before.position + way * (i / pieces);
		piece.now.position = p_collider.before.position + way * ((i + 1.0) / pieces);
		const Bounds bounds = piece.get_swept_bounds();
		add(bounds, find_range(bounds));
	}
}

// Drops the second meeting of a collider with a tile: boxes of neighbouring pieces overlap.
void TileManager::meet_once(uint32_t p_collider) {
	const auto first =
			std::find_if(_meetings.begin(), _meetings.end(), [&](const Meeting &p_meeting) { return p_meeting.collider == p_collider; });
	std::sort(first, _meetings.end(), [](const Meeting &p_a, const Meeting &p_b) { return p_a.slot < p_b.slot; });
	const auto end = std::unique(first, _meetings.end(), [](const Meeting &p_a, const Meeting &p_b) { return p_a.slot == p_b.slot; });
	_meetings.erase(end, _meetings.end());
}

// Appends those of the range, row by row. Runs for all colliders before any of them is used, so that the memory is fetched side by side.
void TileManager::find_squares(const TileRange &p_range) {
	const TileRange squares = SlotMap::squares_of(p_range);
	for (int z = squares.z_begin; z < squares.z_end; z++) {
		for (int x = squares.x_begin; x < squares.x_end; x++) {
			_squares.push_back(&_slot_of_tile.find_square(x * SlotMap::SIDE, z * SlotMap::SIDE));
		}
	}
}

// Notes the tiles of the range whose blades' box meets the collider's. p_squares: the range's. Returns whether there are any.
bool TileManager::meet_range(
		const TileRange &p_range, const SlotMap::Square *const *p_squares, const Bounds &p_swept, uint32_t p_collider, bool p_moves) {
	const size_t count = size_t(find_met(p_range, p_swept)), before = _meetings.size();
	const TileRange squares = SlotMap::squares_of(p_range);
	const int width = squares.width();
	_meetings.resize(before + count);
	for (size_t n = 0; n < count; n++) {
		const int x = _met_in_range[n].x, z = _met_in_range[n].z;
		const int slot = p_squares[(z / SlotMap::SIDE - squares.z_begin) * width + x / SlotMap::SIDE - squares.x_begin]->at(x, z);
		if (slot != SlotMap::NONE) {
			_met.insert(slot);
			_stirred.insert_if(slot, p_moves);
		}
		_meetings[before + n] = { slot != SlotMap::NONE ? slot : ~_grid.get_index(x, z), p_collider };
	}
	return count > 0;
}

// Writes to _met_in_range the tiles of the range whose blades' box meets the collider's. Returns how many.
int TileManager::find_met(const TileRange &p_range, const Bounds &p_swept) {
	_met_in_range.resize(std::max(_met_in_range.size(), size_t(p_range.count())));
	if (_bounds) {
		return _bounds->find_met(p_range, p_swept, _met_in_range.data());
	}
	int count = 0;
	for (int z = p_range.z_begin; z < p_range.z_end; z++) {
		for (int x = p_range.x_begin; x < p_range.x_end; x++) {
			_met_in_range[size_t(count++)] = { uint16_t(x), uint16_t(z) };
		}
	}
	return count;
}

// The tiles whose box could meet the collider's: squares grown by the widest overhang, lowest ground to highest tip.
TileRange TileManager::find_range(const Bounds &p_swept) const {
	if (p_swept.max.y() < _params.low || p_swept.min.y() > _params.height) {
		return {};
	}
	return _grid.get_range(p_swept.min.x(), p_swept.max.x(), p_swept.min.z(), p_swept.max.z(), _params.overhang);
}

// Queues the tiles for activation that meet a collider without a slot, as many as can get one: slots that are free, and those of tiles
// that nobody meets. Drops the meetings of the others, which cost no more than that: a crowd meets many times the pool.
void TileManager::queue_met_tiles() {
	const size_t room = size_t(_params.pool_size - _met.count());
	size_t kept = 0;
	for (const Meeting &meeting : _meetings) {
		int slot = meeting.slot;
		if (slot < 0) {
			const int tile = ~slot;
			int place = _to_activate.empty() ? TileMap::NONE : _place_of_tile.find(tile);
			if (place == TileMap::NONE && _to_activate.size() < room) {
				place = int(_to_activate.size());
				_to_activate.push_back(tile);
				_place_of_tile.insert(tile, place);
			}
			if (place == TileMap::NONE) {
				_statistics.refused++;
				continue;
			}
			slot = ~place;
		}
		_meetings[kept++] = { slot, meeting.collider };
	}
	_meetings.resize(kept);
}

} // namespace grass
