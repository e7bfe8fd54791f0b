// SPDX-License-Identifier: MIT
#include "core/tiles/tile_meetings.h"

namespace grass {

void TileMeetings::reset() {
	forget();
	_wanted.clear();
	_place_of_tile.clear();
	_meetings.clear();
	_barred.clear();
	_waiting.clear();
	_is_short = false;
	_refused = 0;
}

size_t TileMeetings::get_memory_usage() const {
	const auto bytes = [](const auto &p_vector) { return p_vector.capacity() * sizeof(p_vector[0]); };
	size_t blocks = bytes(_blocks);
	for (const Block &block : _blocks) {
		blocks += bytes(block.ways) + bytes(block.whole) + bytes(block.squares) + bytes(block.found) + bytes(block.meetings) +
				bytes(block.meetings_asleep) + bytes(block.known_slots) + bytes(block.known_slots_before) + block.met.get_memory_usage() +
				block.stirred.get_memory_usage();
	}
	return blocks + bytes(_known) + bytes(_met) + bytes(_meetings) + bytes(_wanted) + _place_of_tile.get_memory_usage() +
			bytes(_seen_ways) + bytes(_waiting) + bytes(_barred) + _unmet_seen.get_memory_usage();
}

// Begins a step. A block covers the same indices of colliders in every step, so that Known::first stays valid in its lists.
void TileMeetings::begin(size_t p_colliders) {
	for (const int tile : _wanted) {
		_place_of_tile.erase(tile);
	}
	_wanted.clear();
	_meetings.clear();
	_known.resize(p_colliders);
	bar_yielded();
	_met.assign(p_colliders, MET_NOTHING);
	_block_count = count_blocks(p_colliders);
	_blocks.resize(std::max(_blocks.size(), _block_count));
	for (Block &block : get_blocks()) {
		block.begin(_tiles->room);
	}
}

// Bars tiles that lost their slots. Other tiles have these now, so colliders that do not move must look for theirs again.
void TileMeetings::bar_yielded() {
	for (const int tile : _barred) {
		_place_of_tile.erase(tile);
	}
	_barred = _tiles->yielded;
	for (const int tile : _barred) {
		_place_of_tile.insert(tile, BARRED);
	}
	for (Known &known : _known) {
		known.is_complete = known.is_complete && _barred.empty();
	}
}

void TileMeetings::Block::begin(int p_room) {
	ways.clear();
	squares.clear();
	meetings.clear();
	meetings_asleep.clear();
	known_slots.swap(known_slots_before);
	known_slots.clear();
	met.reset(p_room, false);
	stirred.reset(p_room, false);
	bad_colliders = looked_at = refused = 0;
}

void TileMeetings::find(const Tiles &p_tiles, std::span<ColliderShape> p_colliders, const ParallelFor &p_parallel_for) {
	_tiles = &p_tiles;
	begin(p_colliders.size());
	p_parallel_for(int(_block_count), [&](int p_block) {
		const size_t first = size_t(p_block) * PARALLEL_BLOCK, end = std::min(first + PARALLEL_BLOCK, p_colliders.size());
		for (size_t i = first; i < end; i++) {
			add_collider(p_colliders[i], uint32_t(i), _blocks[size_t(p_block)]);
		}
	});
	limit_ranges(p_colliders);
	p_parallel_for(int(_block_count), [&](int p_block) { meet_awake_tiles(p_colliders, _blocks[size_t(p_block)]); });
	for (const Block &block : get_blocks()) {
		_tiles->met.insert_all(block.met);
		_tiles->stirred.insert_all(block.stirred);
	}
	meet_asleep_tiles(p_parallel_for);
	gather();
	_tiles = nullptr;
}

void TileMeetings::meet_awake_tiles(std::span<const ColliderShape> p_colliders, Block &r_block) {
	for (Way &way : r_block.ways) {
		const Known &known = _known[way.collider];
		way.is_kept = known.is_complete && known.range == way.range;
		if (!way.is_kept) {
			find_squares(way, r_block);
		}
	}
	for (Way &way : r_block.ways) {
		if (way.is_kept) {
			meet_again(way, r_block);
		} else {
			meet_awake(way, p_colliders[way.collider].has_moved(), r_block);
			end_way(way, r_block, r_block.meetings);
		}
	}
}

// Merges what all blocks found, ascending by collider.
void TileMeetings::gather() {
	for (const Block &block : get_blocks()) {
		const size_t first = _meetings.size();
		_meetings.resize(first + block.meetings.size() + block.meetings_asleep.size());
		std::ranges::merge(
				block.meetings, block.meetings_asleep, _meetings.begin() + ptrdiff_t(first), {}, &Meeting::collider, &Meeting::collider);
		_tiles->statistics.bad_colliders += block.bad_colliders;
		_tiles->statistics.looked_at += block.looked_at;
		_tiles->statistics.refused += block.refused;
	}
}

// Runs after the last of several pieces of a collider's path. Removes the collider's second meeting with the same tile, since the boxes of
// adjacent pieces overlap.
void TileMeetings::end_way(const Way &p_way, const Block &p_block, std::vector<Meeting> &r_meetings) {
	const Way *const next = &p_way + 1, *const before = &p_way - 1;
	const bool ends = next == p_block.ways.data() + p_block.ways.size() || next->collider != p_way.collider;
	if (!ends || &p_way == p_block.ways.data() || before->collider != p_way.collider) {
		return;
	}
	const auto first = std::find_if(
			r_meetings.begin(), r_meetings.end(), [&](const Meeting &p_meeting) { return p_meeting.collider == p_way.collider; });
	std::sort(first, r_meetings.end(), [](const Meeting &p_a, const Meeting &p_b) { return p_a.slot < p_b.slot; });
	const auto end = std::unique(first, r_meetings.end(), [](const Meeting &p_a, const Meeting &p_b) { return p_a.slot == p_b.slot; });
	r_meetings.erase(end, r_meetings.end());
}

// Appends the squares of the range, row by row. Runs for all colliders of a block before any of the squares is used, so that the memory is
// fetched in parallel.
void TileMeetings::find_squares(Way &r_way, Block &r_block) {
	const TileRange squares = SlotMap::squares_of(r_way.range);
	r_way.squares = uint32_t(r_block.squares.size());
	for (int z = squares.z_begin; z < squares.z_end; z++) {
		for (int x = squares.x_begin; x < squares.x_end; x++) {
			r_block.squares.push_back(&_tiles->slots.find_square(x * SlotMap::SIDE, z * SlotMap::SIDE));
		}
	}
}

// Repeats the meetings of a collider that is where it was in the last step: the tiles that it met then have kept their slots.
void TileMeetings::meet_again(const Way &p_way, Block &r_block) {
	Known &known = _known[p_way.collider];
	const std::span<const int> slots = std::span(r_block.known_slots_before).subspan(known.first, known.count);
	known.first = uint32_t(r_block.known_slots.size());
	r_block.known_slots.insert(r_block.known_slots.end(), slots.begin(), slots.end());
	for (const int slot : slots) {
		r_block.met.insert(slot);
		r_block.meetings.push_back({ slot, p_way.collider });
	}
	note_met(p_way.collider, known.count > 0 ? MET_AWAKE : MET_NOTHING);
}

// Records the awake tiles of the range whose blades' box meets the collider's. A square without awake tiles costs one look-up.
void TileMeetings::meet_awake(Way &r_way, bool p_moves, Block &r_block) {
	const TileRange range = r_way.range, squares = SlotMap::squares_of(range);
	r_block.found.resize(std::max(r_block.found.size(), size_t(range.count()) + 1));
	Found *found = r_block.found.data();
	const SlotMap::Square *const *next_square = r_block.squares.data() + r_way.squares;
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
	const int met = keep_met(count, r_way.swept, r_block);
	r_way.asleep = int(range.count()) - count;
	for (int n = 0; n < met; n++) {
		r_block.met.insert(found[n].slot);
		r_block.stirred.insert_if(found[n].slot, p_moves);
		r_block.meetings.push_back({ found[n].slot, r_way.collider });
	}
	note_met(r_way.collider, met > 0 ? MET_AWAKE : MET_NOTHING);
	if (Known &known = _known[r_way.collider]; known.stamp != 0) {
		known.range = range;
		known.first = uint32_t(r_block.known_slots.size());
		known.count = uint32_t(met);
		known.is_complete = !p_moves;
		for (int n = 0; n < met; n++) {
			r_block.known_slots.push_back(found[n].slot);
		}
	}
}

// Keeps those of the first p_count tiles in r_block.found whose blades' box meets the collider's. Returns their number.
int TileMeetings::keep_met(int p_count, const Bounds &p_swept, Block &r_block) const {
	r_block.looked_at += uint64_t(p_count);
	return _tiles->bounds ? _tiles->bounds->keep_met(r_block.found.data(), p_count, p_swept) : p_count;
}

} // namespace grass
