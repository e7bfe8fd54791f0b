// SPDX-License-Identifier: MIT
// Which sleeping tiles a collider meets, and which of them get a slot.
#include "core/tiles/tile_meetings.h"

namespace grass {

// Queues the tiles for activation that meet a collider and have no slot, as many as can get one: from free slots, and from tiles that no
// collider meets. A crowd that covers the pool many times over costs little more than looking up its squares, on all threads, since the
// queue no longer changes then.
void TileMeetings::meet_asleep_tiles(const ParallelFor &p_parallel_for) {
	_queued.clear();
	const size_t room = queue_seen_tiles(size_t(_tiles->limit - _tiles->met.count()));
	size_t next = 0;
	for (; next < _block_count && _wanted.size() < room; next++) {
		meet_asleep_tiles_of(_blocks[next], room);
	}
	p_parallel_for(int(_block_count - next), [&](int p_block) { meet_asleep_tiles_of(_blocks[next + size_t(p_block)], room); });
}

void TileMeetings::hold_back(size_t p_kept) {
	for (size_t place = p_kept; place < _wanted.size(); place++) {
		_place_of_tile.erase(_wanted[place]);
	}
	_wanted.resize(p_kept);
	std::erase_if(_meetings, [&](const Meeting &p_meeting) { return p_meeting.slot < 0 && size_t(~p_meeting.slot) >= p_kept; });
}

void TileMeetings::meet_asleep_tiles_of(Block &r_block, size_t p_room) {
	for (const Way &way : r_block.ways) {
		if (way.asleep > 0 && (_wanted.size() < p_room ? queue_tiles(way, p_room, r_block) : meet_queued_tiles(way, r_block))) {
			_known[way.collider].is_complete = false;
		}
		end_way(way, r_block, r_block.meetings_asleep);
	}
}

// Writes the sleeping tiles of the range to r_block.found, row by row. p_queued: only those that may be queued. Returns their number.
int TileMeetings::find_asleep(const Way &p_way, bool p_queued, Block &r_block) const {
	const TileRange range = p_way.range, squares = SlotMap::squares_of(range);
	const SlotMap::Square *const *all_squares = r_block.squares.data() + p_way.squares;
	Found *found = r_block.found.data();
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

// Queues the sleeping tiles that the collider meets. Returns whether there are any.
bool TileMeetings::queue_tiles(const Way &p_way, size_t p_room, Block &r_block) {
	const uint32_t collider = p_way.collider;
	const int met = keep_met(find_asleep(p_way, false, r_block), p_way.swept, r_block);
	note_met(collider, met > 0 ? MET_GRASS : MET_NOTHING);
	bool is_refused = false;
	for (int n = 0; n < met; n++) {
		const int x = r_block.found[size_t(n)].x, z = r_block.found[size_t(n)].z, tile = _tiles->grid.get_index(x, z);
		int place = _place_of_tile.find(tile);
		if (place == TileMap::NONE && _wanted.size() < p_room) {
			place = queue(x, z);
		}
		if (place >= 0) {
			r_block.meetings_asleep.push_back({ ~place, collider });
			note_met(collider, MET_AWAKE);
		}
		is_refused = is_refused || place < 0;
	}
	r_block.refused += is_refused;
	return met > 0;
}

// Does the same when no more slots are left.
bool TileMeetings::meet_queued_tiles(const Way &p_way, Block &r_block) {
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
		const int met = keep_met(find_asleep(p_way, true, r_block), p_way.swept, r_block);
		for (int n = 0; n < met; n++) {
			const int place = _place_of_tile.find(_tiles->grid.get_index(r_block.found[size_t(n)].x, r_block.found[size_t(n)].z));
			if (place >= 0) {
				r_block.meetings_asleep.push_back({ ~place, collider });
				joined++;
			}
		}
	}
	const bool is_refused = p_way.asleep > joined && meets_asleep(p_way, r_block);
	note_met(collider, joined > 0 ? MET_AWAKE : is_refused ? MET_GRASS : MET_NOTHING);
	r_block.refused += is_refused;
	return joined > 0 || is_refused;
}

// Returns whether the collider meets any tile that sleeps and is not queued. Tests the middle of the range first, which is most likely met.
bool TileMeetings::meets_asleep(const Way &p_way, Block &r_block) const {
	const TileRange range = p_way.range, squares = SlotMap::squares_of(range);
	const SlotMap::Square *const *all_squares = r_block.squares.data() + p_way.squares;
	const int width = range.width(), count = int(range.count());
	for (int n = 0, at = count / 2; n < count; n++, at = at + 1 < count ? at + 1 : 0) {
		const int x = range.x_begin + at % width, z = range.z_begin + at / width;
		const SlotMap::Square *square =
				all_squares[(z / SlotMap::SIDE - squares.z_begin) * squares.width() + x / SlotMap::SIDE - squares.x_begin];
		if (square->at(x, z) != SlotMap::NONE || _place_of_tile.find(_tiles->grid.get_index(x, z)) >= 0) {
			continue;
		}
		r_block.found[0] = { uint16_t(x), uint16_t(z), SlotMap::NONE };
		if (keep_met(1, p_way.swept, r_block) > 0) {
			return true;
		}
	}
	return false;
}

} // namespace grass
