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
	forget();
	_wanted.clear();
	_place_of_tile.clear();
	_meetings.clear();
}

size_t TileMeetings::get_memory_usage() const {
	const auto bytes = [](const auto &p_vector) { return p_vector.capacity() * sizeof(p_vector[0]); };
	return bytes(_ways) + bytes(_known) + bytes(_known_slots) + bytes(_known_slots_before) + bytes(_met) + bytes(_found) + bytes(_squares) +
			bytes(_meetings) + bytes(_meetings_awake) + bytes(_meetings_asleep) + bytes(_wanted) + _place_of_tile.get_memory_usage();
}

void TileMeetings::begin(size_t p_colliders) {
	for (const int tile : _wanted) {
		_place_of_tile.erase(tile);
	}
	_wanted.clear();
	_meetings.clear();
	_ways.clear();
	_squares.clear();
	_known.resize(p_colliders);
	_known_slots.swap(_known_slots_before);
	_known_slots.clear();
	_met.assign(p_colliders, MET_NOTHING);
}

void TileMeetings::find(const Tiles &p_tiles, std::span<ColliderShape> p_colliders) {
	_tiles = &p_tiles;
	begin(p_colliders.size());
	for (size_t i = 0; i < p_colliders.size(); i++) {
		add_collider(p_colliders[i], uint32_t(i));
	}
	limit_ranges(p_colliders);
	for (Way &way : _ways) {
		if (way.is_kept) {
			meet_again(way);
		} else {
			meet_awake(way, p_colliders[way.collider].has_moved());
			end_way(way, _meetings);
		}
	}
	meet_asleep_tiles();
	_tiles = nullptr;
}

void TileMeetings::add_collider(ColliderShape &r_collider, uint32_t p_index) {
	Known &known = _known[p_index];
	const bool is_same = r_collider.stamp != 0 && r_collider.stamp == known.stamp;
	if (!is_same) {
		const char *reason = nullptr;
		known.stamp = r_collider.stamp;
		known.is_good = r_collider.sanitise(reason);
		known.is_complete = false;
	}
	_tiles->statistics.bad_colliders += known.is_good ? 0 : 1;
	if (known.is_good && is_same) {
		_ways.push_back({ known.swept, known.whole, p_index });
	} else if (known.is_good) {
		add_ways(r_collider, p_index);
	}
}

// A body over more tiles than the pool holds, or bodies that together fill the list, get those around their centres.
void TileMeetings::limit_ranges(std::span<const ColliderShape> p_colliders) {
	int64_t total = 0;
	for (const Way &way : _ways) {
		total += way.range.count();
	}
	const int64_t capacity = _tiles->params.list_capacity();
	const int64_t share = total <= capacity ? capacity : std::max<int64_t>(1, capacity / int64_t(_ways.size()));
	const int64_t most = std::min<int64_t>(share, _tiles->params.pool_size);
	int64_t left = capacity;
	for (Way &way : _ways) {
		TileRange &range = way.range;
		if (const int64_t limit = std::min(most, left); range.count() > limit) {
			const TilePlace centre = _tiles->grid.get_place(p_colliders[way.collider].now.position);
			_tiles->statistics.capped += uint64_t(range.count());
			range = shrink(range, limit, centre.x, centre.z);
			_tiles->statistics.capped -= uint64_t(range.count());
		}
		left -= range.count();
		const Known &known = _known[way.collider];
		way.is_kept = known.is_complete && known.range == range;
		if (!way.is_kept) {
			find_squares(way);
		}
	}
	if (_tiles->bounds && total > GRASS_START_COUNT / 4) {
		_tiles->bounds->prefetch();
	}
}

// The tiles that the collider may meet: those under the box around all of its way. Where these are more than can be awake, those under
// boxes around pieces of it: what crosses the field aslant in one step passes over few of the tiles between its ends.
void TileMeetings::add_ways(const ColliderShape &p_collider, uint32_t p_index) {
	constexpr double MOST_PIECES = 256.0;
	const Bounds swept = p_collider.get_swept_bounds();
	const TileRange range = find_range(swept);
	const Eigen::Vector3d way = p_collider.now.position - p_collider.before.position;
	const double own = std::max(2.0 * p_collider.get_half_extents().norm(), 2.0 * _tiles->grid.get_tile_size());
	const double pieces = std::min(std::ceil(std::hypot(way.x(), way.z()) / own), MOST_PIECES);
	if (range.count() <= _tiles->params.pool_size || pieces < 2.0) {
		_ways.push_back({ swept, range, p_index });
		_known[p_index].swept = swept;
		_known[p_index].whole = range;
		return;
	}
	_known[p_index].stamp = 0;
	ColliderShape piece = p_collider;
	for (double i = 0.0; i < pieces; i += 1.0) {
		piece.before.position = p_collider.before.position + way * (i / pieces);
		piece.now.position = p_collider.before.position + way * ((i + 1.0) / pieces);
		const Bounds bounds = piece.get_swept_bounds();
		_ways.push_back({ bounds, find_range(bounds), p_index });
	}
}

// After the last of several pieces of a collider's way: drops its second meeting with a tile, for boxes of neighbouring pieces overlap.
void TileMeetings::end_way(const Way &p_way, std::vector<Meeting> &r_meetings) const {
	const Way *const next = &p_way + 1, *const before = &p_way - 1;
	const bool ends = next == _ways.data() + _ways.size() || next->collider != p_way.collider;
	if (!ends || &p_way == _ways.data() || before->collider != p_way.collider) {
		return;
	}
	const auto first = std::find_if(
			r_meetings.begin(), r_meetings.end(), [&](const Meeting &p_meeting) { return p_meeting.collider == p_way.collider; });
	std::sort(first, r_meetings.end(), [](const Meeting &p_a, const Meeting &p_b) { return p_a.slot < p_b.slot; });
	const auto end = std::unique(first, r_meetings.end(), [](const Meeting &p_a, const Meeting &p_b) { return p_a.slot == p_b.slot; });
	r_meetings.erase(end, r_meetings.end());
}

// Appends those of the range, row by row. Runs for all colliders before any of them is used, so that the memory is fetched side by side.
void TileMeetings::find_squares(Way &r_way) {
	const TileRange squares = SlotMap::squares_of(r_way.range);
	r_way.squares = uint32_t(_squares.size());
	for (int z = squares.z_begin; z < squares.z_end; z++) {
		for (int x = squares.x_begin; x < squares.x_end; x++) {
			_squares.push_back(&_tiles->slots.find_square(x * SlotMap::SIDE, z * SlotMap::SIDE));
		}
	}
}

// The same collider, where it was in the last step: the tiles that it met then have kept their slots.
void TileMeetings::meet_again(const Way &p_way) {
	Known &known = _known[p_way.collider];
	const std::span<const int> slots = std::span(_known_slots_before).subspan(known.first, known.count);
	known.first = uint32_t(_known_slots.size());
	_known_slots.insert(_known_slots.end(), slots.begin(), slots.end());
	for (const int slot : slots) {
		_tiles->met.insert(slot);
		_meetings.push_back({ slot, p_way.collider });
	}
	note_met(p_way.collider, known.count > 0 ? MET_AWAKE : MET_NOTHING);
}

// Notes the awake tiles of the range whose blades' box meets the collider's. Squares without any cost one look.
void TileMeetings::meet_awake(Way &r_way, bool p_moves) {
	const TileRange range = r_way.range, squares = SlotMap::squares_of(range);
	_found.resize(std::max(_found.size(), size_t(range.count()) + 1));
	Found *found = _found.data();
	const SlotMap::Square *const *next_square = _squares.data() + r_way.squares;
	int count = 0;
	for (int z = squares.z_begin; z < squares.z_end; z++) {
		for (int x = squares.x_begin; x < squares.x_end; x++) {
			const SlotMap::Square *square = *next_square++;
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
	const int met = keep_met(count, r_way.swept);
	r_way.asleep = int(range.count()) - count;
	SlotSet &all_met = _tiles->met, &stirred = _tiles->stirred;
	for (int n = 0; n < met; n++) {
		all_met.insert(found[n].slot);
		stirred.insert_if(found[n].slot, p_moves);
		_meetings.push_back({ found[n].slot, r_way.collider });
	}
	note_met(r_way.collider, met > 0 ? MET_AWAKE : MET_NOTHING);
	if (Known &known = _known[r_way.collider]; known.stamp != 0) {
		known.range = range;
		known.first = uint32_t(_known_slots.size());
		known.count = uint32_t(met);
		known.is_complete = !p_moves;
		for (int n = 0; n < met; n++) {
			_known_slots.push_back(found[n].slot);
		}
	}
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
	for (const Way &way : _ways) {
		if (way.asleep > 0 && (_wanted.size() < room ? queue_tiles(way, room) : meet_queued_tiles(way))) {
			_known[way.collider].is_complete = false;
		}
		end_way(way, _meetings_asleep);
	}
	if (!_meetings_asleep.empty()) {
		_meetings_awake.swap(_meetings);
		_meetings.resize(_meetings_awake.size() + _meetings_asleep.size());
		std::merge(_meetings_awake.begin(), _meetings_awake.end(), _meetings_asleep.begin(), _meetings_asleep.end(), _meetings.begin(),
				[](const Meeting &p_a, const Meeting &p_b) { return p_a.collider < p_b.collider; });
	}
}

// Writes those of the range's tiles that sleep to _found, row by row. p_queued: only those that may be queued. Returns how many.
int TileMeetings::find_asleep(const Way &p_way, bool p_queued) {
	const TileRange range = p_way.range, squares = SlotMap::squares_of(range);
	const SlotMap::Square *const *all_squares = _squares.data() + p_way.squares;
	Found *found = _found.data();
	int count = 0;
	for (int z = range.z_begin; z < range.z_end; z++) {
		for (int x = range.x_begin; x < range.x_end; x++) {
			const int square_x = x / SlotMap::SIDE, square_z = z / SlotMap::SIDE;
			const SlotMap::Square *square = all_squares[(square_z - squares.z_begin) * squares.width() + square_x - squares.x_begin];
			found[count] = { uint16_t(x), uint16_t(z), SlotMap::NONE };
			count += square->at(x, z) == SlotMap::NONE && (!p_queued || _queued.may_have(square_x, square_z));
		}
	}
	return count;
}

// Returns whether it meets any that sleeps.
bool TileMeetings::queue_tiles(const Way &p_way, size_t p_room) {
	const uint32_t collider = p_way.collider;
	const int met = keep_met(find_asleep(p_way, false), p_way.swept);
	note_met(collider, met > 0 ? MET_GRASS : MET_NOTHING);
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
			note_met(collider, MET_AWAKE);
		}
		is_refused = is_refused || place == TileMap::NONE;
	}
	_tiles->statistics.refused += is_refused;
	return met > 0;
}

// The same once no more slots are left.
bool TileMeetings::meet_queued_tiles(const Way &p_way) {
	const TileRange squares = SlotMap::squares_of(p_way.range);
	const uint32_t collider = p_way.collider;
	bool any_queued = false;
	for (int z = squares.z_begin; z < squares.z_end; z++) {
		for (int x = squares.x_begin; x < squares.x_end; x++) {
			any_queued = any_queued || _queued.may_have(x, z);
		}
	}
	int joined = 0;
	if (any_queued) {
		const int met = keep_met(find_asleep(p_way, true), p_way.swept);
		for (int n = 0; n < met; n++) {
			const int place = _place_of_tile.find(_tiles->grid.get_index(_found[size_t(n)].x, _found[size_t(n)].z));
			if (place != TileMap::NONE) {
				_meetings_asleep.push_back({ ~place, collider });
				joined++;
			}
		}
	}
	const bool is_refused = p_way.asleep > joined && meets_asleep(p_way);
	note_met(collider, joined > 0 ? MET_AWAKE : is_refused ? MET_GRASS : MET_NOTHING);
	_tiles->statistics.refused += is_refused;
	return joined > 0 || is_refused;
}

// Whether the collider meets any tile that sleeps and is not queued. Those in the middle of the range are met most likely.
bool TileMeetings::meets_asleep(const Way &p_way) {
	const TileRange range = p_way.range, squares = SlotMap::squares_of(range);
	const SlotMap::Square *const *all_squares = _squares.data() + p_way.squares;
	const int width = range.width(), count = int(range.count());
	for (int n = 0, at = count / 2; n < count; n++, at = at + 1 < count ? at + 1 : 0) {
		const int x = range.x_begin + at % width, z = range.z_begin + at / width;
		const SlotMap::Square *square =
				all_squares[(z / SlotMap::SIDE - squares.z_begin) * squares.width() + x / SlotMap::SIDE - squares.x_begin];
		if (square->at(x, z) != SlotMap::NONE || _place_of_tile.find(_tiles->grid.get_index(x, z)) != TileMap::NONE) {
			continue;
		}
		_found[0] = { uint16_t(x), uint16_t(z), SlotMap::NONE };
		if (keep_met(1, p_way.swept) > 0) {
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
