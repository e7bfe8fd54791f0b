// SPDX-License-Identifier: MIT
#include "core/tiles/tile_meetings.h"

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

void TileMeetings::reset() {
	_wanted.clear();
	_place_of_tile.clear();
	_meetings.clear();
}

size_t TileMeetings::get_memory_usage() const {
	const auto bytes = [](const auto &p_vector) { return p_vector.capacity() * sizeof(p_vector[0]); };
	return bytes(_ranges) + bytes(_swept) + bytes(_range_colliders) + bytes(_has_met) + bytes(_asleep) + bytes(_found) + bytes(_squares) +
			bytes(_meetings) + bytes(_meetings_awake) + bytes(_meetings_asleep) + bytes(_wanted) + _place_of_tile.get_memory_usage();
}

void TileMeetings::begin() {
	for (const int tile : _wanted) {
		_place_of_tile.erase(tile);
	}
	_wanted.clear();
	_meetings.clear();
	_ranges.clear();
	_swept.clear();
	_range_colliders.clear();
	_squares.clear();
}

void TileMeetings::find(const Tiles &p_tiles, std::span<ColliderShape> p_colliders) {
	_tiles = &p_tiles;
	begin();
	_has_met.assign(p_colliders.size(), 0);
	int64_t total = 0;
	for (ColliderShape &collider : p_colliders) {
		const char *reason = nullptr;
		const bool is_good = collider.sanitise(reason);
		_tiles->statistics.bad_colliders += is_good ? 0 : 1;
		if (is_good) {
			add_ranges(collider, uint32_t(&collider - p_colliders.data()));
		}
	}
	for (const TileRange &range : _ranges) {
		total += range.count();
	}
	// A body over more tiles than the pool holds, or bodies that together fill the list, get those around their centres.
	const int64_t capacity = _tiles->params.list_capacity();
	const int64_t share = total <= capacity ? capacity : std::max<int64_t>(1, capacity / int64_t(_ranges.size()));
	const int64_t most = std::min<int64_t>(share, _tiles->params.pool_size);
	int64_t left = capacity;
	for (size_t i = 0; i < _ranges.size(); i++) {
		TileRange &range = _ranges[i];
		if (const int64_t limit = std::min(most, left); range.count() > limit) {
			const TilePlace centre = _tiles->grid.get_place(p_colliders[_range_colliders[i]].now.position);
			_tiles->statistics.capped += uint64_t(range.count());
			range = shrink(range, limit, centre.x, centre.z);
			_tiles->statistics.capped -= uint64_t(range.count());
		}
		left -= range.count();
		find_squares(range);
	}
	if (_tiles->bounds && total > GRASS_START_COUNT / 4) {
		_tiles->bounds->prefetch();
	}
	_asleep.resize(_ranges.size());
	for_each_range([&](size_t p_range, const SlotMap::Square *const *p_squares) {
		const uint32_t collider = _range_colliders[p_range];
		_asleep[p_range] = meet_awake(p_range, p_squares, p_colliders[collider].has_moved());
		end_range(p_range, _meetings);
	});
	meet_asleep_tiles();
	_tiles = nullptr;
}

// Calls p_meet with the number of each range and its squares.
template <typename F> void TileMeetings::for_each_range(F &&p_meet) {
	size_t square = 0;
	for (size_t i = 0; i < _ranges.size(); i++) {
		p_meet(i, &_squares[square]);
		square += size_t(SlotMap::squares_of(_ranges[i]).count());
	}
}

// The tiles that the collider may meet: those under the box around all of its way. Where these are more than can be awake, those under
// boxes around pieces of it: what crosses the field aslant in one step passes over few of the tiles between its ends.
void TileMeetings::add_ranges(const ColliderShape &p_collider, uint32_t p_index) {
	constexpr double MOST_PIECES = 256.0;
	const auto add = [&](const Bounds &p_swept, const TileRange &p_range) {
		_swept.push_back(p_swept);
		_ranges.push_back(p_range);
		_range_colliders.push_back(p_index);
	};
	const Bounds swept = p_collider.get_swept_bounds();
	const TileRange range = find_range(swept);
	const Eigen::Vector3d way = p_collider.now.position - p_collider.before.position;
	const double own = std::max(2.0 * p_collider.get_half_extents().norm(), 2.0 * _tiles->grid.get_tile_size());
	const double pieces = std::min(std::ceil(std::hypot(way.x(), way.z()) / own), MOST_PIECES);
	if (range.count() <= _tiles->params.pool_size || pieces < 2.0) {
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

// After the last of several ranges of a collider: drops its second meeting with a tile, for boxes of neighbouring pieces overlap.
void TileMeetings::end_range(size_t p_range, std::vector<Meeting> &r_meetings) const {
	const uint32_t collider = _range_colliders[p_range];
	const bool ends = p_range + 1 == _ranges.size() || _range_colliders[p_range + 1] != collider;
	if (!ends || p_range == 0 || _range_colliders[p_range - 1] != collider) {
		return;
	}
	const auto first =
			std::find_if(r_meetings.begin(), r_meetings.end(), [&](const Meeting &p_meeting) { return p_meeting.collider == collider; });
	std::sort(first, r_meetings.end(), [](const Meeting &p_a, const Meeting &p_b) { return p_a.slot < p_b.slot; });
	const auto end = std::unique(first, r_meetings.end(), [](const Meeting &p_a, const Meeting &p_b) { return p_a.slot == p_b.slot; });
	r_meetings.erase(end, r_meetings.end());
}

// Appends those of the range, row by row. Runs for all colliders before any of them is used, so that the memory is fetched side by side.
void TileMeetings::find_squares(const TileRange &p_range) {
	const TileRange squares = SlotMap::squares_of(p_range);
	for (int z = squares.z_begin; z < squares.z_end; z++) {
		for (int x = squares.x_begin; x < squares.x_end; x++) {
			_squares.push_back(&_tiles->slots.find_square(x * SlotMap::SIDE, z * SlotMap::SIDE));
		}
	}
}

// Notes the awake tiles of the range whose blades' box meets the collider's. Squares without any cost one look. Returns how many of the
// range's tiles are asleep.
int TileMeetings::meet_awake(size_t p_range, const SlotMap::Square *const *p_squares, bool p_moves) {
	const TileRange range = _ranges[p_range], squares = SlotMap::squares_of(range);
	_found.resize(std::max(_found.size(), size_t(range.count()) + 1));
	Found *found = _found.data();
	int count = 0;
	for (int z = squares.z_begin; z < squares.z_end; z++) {
		for (int x = squares.x_begin; x < squares.x_end; x++) {
			const SlotMap::Square *square = *p_squares++;
			if (SlotMap::is_empty(square)) {
				continue;
			}
			const int x_begin = std::max(x * SlotMap::SIDE, range.x_begin), x_end = std::min((x + 1) * SlotMap::SIDE, range.x_end),
					  z_begin = std::max(z * SlotMap::SIDE, range.z_begin), z_end = std::min((z + 1) * SlotMap::SIDE, range.z_end);
			for (int tile_z = z_begin; tile_z < z_end; tile_z++) {
				for (int tile_x = x_begin; tile_x < x_end; tile_x++) {
					const int slot = square->at(tile_x, tile_z);
					found[count] = { uint16_t(tile_x), uint16_t(tile_z), slot };
					count += slot != SlotMap::NONE;
				}
			}
		}
	}
	const int met = keep_met(count, _swept[p_range]);
	const uint32_t collider = _range_colliders[p_range];
	SlotSet &all_met = _tiles->met, &stirred = _tiles->stirred;
	for (int n = 0; n < met; n++) {
		all_met.insert(found[n].slot);
		stirred.insert_if(found[n].slot, p_moves);
		_meetings.push_back({ found[n].slot, collider });
	}
	_has_met[collider] |= uint8_t(met > 0);
	return int(range.count()) - count;
}

// Keeps those of the first p_count tiles in _found whose blades' box meets the collider's. Returns how many.
int TileMeetings::keep_met(int p_count, const Bounds &p_swept) {
	_tiles->statistics.looked_at += uint64_t(p_count);
	return _tiles->bounds ? _tiles->bounds->keep_met(_found.data(), p_count, p_swept) : p_count;
}

// Queues the tiles for activation that meet a collider without a slot, as many as can get one: slots that are free, and those of tiles
// that nobody meets. Beyond that a crowd that covers many times the pool costs little more than looking up its squares.
void TileMeetings::meet_asleep_tiles() {
	const size_t room = size_t(_tiles->params.pool_size - _tiles->met.count());
	_meetings_asleep.clear();
	_queued.clear();
	for_each_range([&](size_t p_range, const SlotMap::Square *const *p_squares) {
		if (_asleep[p_range] > 0) {
			_wanted.size() < room ? queue_tiles(p_range, p_squares, room) : meet_queued_tiles(p_range, p_squares);
		}
		end_range(p_range, _meetings_asleep);
	});
	if (!_meetings_asleep.empty()) {
		_meetings_awake.swap(_meetings);
		_meetings.resize(_meetings_awake.size() + _meetings_asleep.size());
		std::merge(_meetings_awake.begin(), _meetings_awake.end(), _meetings_asleep.begin(), _meetings_asleep.end(), _meetings.begin(),
				[](const Meeting &p_a, const Meeting &p_b) { return p_a.collider < p_b.collider; });
	}
}

// Writes those of the range's tiles that sleep to _found, row by row. p_queued: only those that may be queued. Returns how many.
int TileMeetings::find_asleep(const TileRange &p_range, const SlotMap::Square *const *p_squares, bool p_queued) {
	const TileRange squares = SlotMap::squares_of(p_range);
	Found *found = _found.data();
	int count = 0;
	for (int z = p_range.z_begin; z < p_range.z_end; z++) {
		for (int x = p_range.x_begin; x < p_range.x_end; x++) {
			const int square_x = x / SlotMap::SIDE, square_z = z / SlotMap::SIDE;
			const SlotMap::Square *square = p_squares[(square_z - squares.z_begin) * squares.width() + square_x - squares.x_begin];
			found[count] = { uint16_t(x), uint16_t(z), SlotMap::NONE };
			count += square->at(x, z) == SlotMap::NONE && (!p_queued || _queued.may_have(square_x, square_z));
		}
	}
	return count;
}

void TileMeetings::queue_tiles(size_t p_range, const SlotMap::Square *const *p_squares, size_t p_room) {
	const uint32_t collider = _range_colliders[p_range];
	const int met = keep_met(find_asleep(_ranges[p_range], p_squares, false), _swept[p_range]);
	bool is_refused = false;
	for (int n = 0; n < met; n++) {
		const int x = _found[size_t(n)].x, z = _found[size_t(n)].z, tile = _tiles->grid.get_index(x, z);
		int place = _place_of_tile.find(tile);
		if (place == TileMap::NONE && _wanted.size() < p_room) {
			place = int(_wanted.size());
			_wanted.push_back(tile);
			_place_of_tile.insert(tile, place);
			_queued.add(x / SlotMap::SIDE, z / SlotMap::SIDE);
		}
		if (place != TileMap::NONE) {
			_meetings_asleep.push_back({ ~place, collider });
		}
		is_refused = is_refused || place == TileMap::NONE;
	}
	_has_met[collider] |= uint8_t(met > 0);
	_tiles->statistics.refused += is_refused;
}

// The same once no more slots are left.
void TileMeetings::meet_queued_tiles(size_t p_range, const SlotMap::Square *const *p_squares) {
	const TileRange range = _ranges[p_range], squares = SlotMap::squares_of(range);
	const uint32_t collider = _range_colliders[p_range];
	bool any_queued = false;
	for (int z = squares.z_begin; z < squares.z_end; z++) {
		for (int x = squares.x_begin; x < squares.x_end; x++) {
			any_queued = any_queued || _queued.may_have(x, z);
		}
	}
	int joined = 0;
	if (any_queued) {
		const int met = keep_met(find_asleep(range, p_squares, true), _swept[p_range]);
		for (int n = 0; n < met; n++) {
			const int place = _place_of_tile.find(_tiles->grid.get_index(_found[size_t(n)].x, _found[size_t(n)].z));
			if (place != TileMap::NONE) {
				_meetings_asleep.push_back({ ~place, collider });
				joined++;
			}
		}
	}
	const bool is_refused = _asleep[p_range] > joined && meets_asleep(range, p_squares, _swept[p_range]);
	_has_met[collider] |= uint8_t(joined > 0 || is_refused);
	_tiles->statistics.refused += is_refused;
}

// Whether the collider meets any tile that sleeps and is not queued. Those in the middle of the range are met most likely.
bool TileMeetings::meets_asleep(const TileRange &p_range, const SlotMap::Square *const *p_squares, const Bounds &p_swept) {
	const TileRange squares = SlotMap::squares_of(p_range);
	const int width = p_range.width(), count = int(p_range.count());
	for (int n = 0, at = count / 2; n < count; n++, at = at + 1 < count ? at + 1 : 0) {
		const int x = p_range.x_begin + at % width, z = p_range.z_begin + at / width;
		const SlotMap::Square *square =
				p_squares[(z / SlotMap::SIDE - squares.z_begin) * squares.width() + x / SlotMap::SIDE - squares.x_begin];
		if (square->at(x, z) != SlotMap::NONE || _place_of_tile.find(_tiles->grid.get_index(x, z)) != TileMap::NONE) {
			continue;
		}
		_found[0] = { uint16_t(x), uint16_t(z), SlotMap::NONE };
		if (keep_met(1, p_swept) > 0) {
			return true;
		}
	}
	return false;
}

// The tiles whose box could meet the collider's: squares grown by the widest overhang, lowest ground to highest tip.
TileRange TileMeetings::find_range(const Bounds &p_swept) const {
	if (p_swept.max.y() < _tiles->params.low || p_swept.min.y() > _tiles->params.height) {
		return {};
	}
	return _tiles->grid.get_range(p_swept.min.x(), p_swept.max.x(), p_swept.min.z(), p_swept.max.z(), _tiles->params.overhang);
}

} // namespace grass
