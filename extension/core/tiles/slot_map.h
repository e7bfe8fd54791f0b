// SPDX-License-Identifier: MIT
// Maps a tile to its slot in the pool, for a bounded number of tiles whatever the field's size. Each square of 4 x 4 tiles fits one cache
// line and is found by open addressing: a collider looks up a few squares, not each of its tiles.
#pragma once

#include "core/base/hash.h"
#include "core/base/resize_exactly.h"
#include "core/base/tile_grid.h"
#include "core/tiles/slot_set.h"

#include <array>
#include <cstdint>
#include <vector>

namespace grass {

class SlotMap {
public:
	static constexpr int NONE = -1;
	static constexpr int SIDE = 4; // tiles

	// The slots of a square's tiles.
	struct alignas(64) Square {
		std::array<int32_t, size_t(SIDE) * SIDE> slots;

		int at(int p_x, int p_z) const { return slots[place(p_x, p_z)]; }
		static size_t place(int p_x, int p_z) { return size_t(p_z) % SIDE * SIDE + size_t(p_x) % SIDE; }
	};

	// Returns the range of squares that contain tiles of the range (which has no negative numbers).
	static TileRange squares_of(const TileRange &p_tiles) {
		return { p_tiles.x_begin / SIDE, (p_tiles.x_end + SIDE - 1) / SIDE, p_tiles.z_begin / SIDE, (p_tiles.z_end + SIDE - 1) / SIDE };
	}

	// Empties the map and makes room for p_capacity tiles.
	void reserve(int p_capacity) {
		_entries.assign(FIRST_ENTRIES, {});
		resize_exactly(_squares, size_t(p_capacity));
		_free.reset(p_capacity, true);
		_mask = uint32_t(_entries.size() - 1);
		_count = 0;
	}

	// Makes room for p_capacity tiles, at least as many as it had room for. Keeps its tiles.
	void grow_to(int p_capacity) {
		_free.resize(int(_squares.size()), p_capacity, true);
		_squares.resize(size_t(p_capacity));
	}

	// Returns true if none of its tiles has a slot.
	static bool is_empty(const Square *p_square) { return p_square == &NO_SLOTS; }

	// Returns the square of a tile (no negative numbers); a square without slots if none of its tiles has one.
	const Square &find_square(int p_x, int p_z) const {
		const Entry &entry = _entries[seek(key_of(p_x, p_z))];
		const Square &square = entry.key == NO_KEY ? NO_SLOTS : _squares[entry.square];
#ifdef __GNUC__
		__builtin_prefetch(&square); // it is read soon
#endif
		return square;
	}

	int find(int p_x, int p_z) const {
		return find_square(p_x, p_z).at(p_x, p_z);
	}

	// Adds a tile. The map must have room for it.
	void insert(int p_x, int p_z, int p_slot) {
		const uint32_t key = key_of(p_x, p_z);
		uint32_t place = seek(key);
		if (_entries[place].key == NO_KEY) {
			if (++_count * 2 > _entries.size()) {
				grow();
				place = seek(key);
			}
			_entries[place] = { key, uint32_t(_free.take_lowest()) };
			_squares[_entries[place].square] = NO_SLOTS;
		}
		_squares[_entries[place].square].slots[Square::place(p_x, p_z)] = p_slot;
	}

	// Removes a tile. Does nothing if the tile is not in the map.
	void erase(int p_x, int p_z) {
		const uint32_t place = seek(key_of(p_x, p_z));
		if (_entries[place].key == NO_KEY) {
			return;
		}
		Square &square = _squares[_entries[place].square];
		square.slots[Square::place(p_x, p_z)] = NONE;
		if (square.slots == NO_SLOTS.slots) {
			_free.give_back(int(_entries[place].square));
			_count--;
			remove(place);
		}
	}

	// Returns bytes.
	size_t get_memory_usage() const {
		return _entries.capacity() * sizeof(Entry) + _squares.capacity() * sizeof(Square) + _free.get_memory_usage();
	}

private:
	static constexpr size_t FIRST_ENTRIES = 256; // a power of two
	static constexpr uint32_t NO_KEY = 0xffffffffu; // fields have up to 2^13 tiles along a side
	struct Entry {
		uint32_t key = NO_KEY;
		uint32_t square = 0; // index in _squares
	};
	static constexpr Square NO_SLOTS = [] {
		Square square;
		square.slots.fill(NONE);
		return square;
	}();

	static uint32_t key_of(int p_x, int p_z) {
		return uint32_t(p_x) / SIDE | uint32_t(p_z) / SIDE << 16;
	}
	uint32_t home_of(uint32_t p_key) const {
		return grass_hash(p_key) & _mask;
	}

	// Returns the index of the square's entry, or of the free place where it belongs.
	uint32_t seek(uint32_t p_key) const {
		uint32_t i = home_of(p_key);
		while (_entries[i].key != p_key && _entries[i].key != NO_KEY) {
			i = (i + 1) & _mask;
		}
		return i;
	}

	// Removes an entry. One that was pushed past the hole moves back into it, so that no search stops too early.
	void remove(uint32_t p_hole) {
		for (uint32_t i = (p_hole + 1) & _mask; _entries[i].key != NO_KEY; i = (i + 1) & _mask) {
			if (((i - home_of(_entries[i].key)) & _mask) >= ((i - p_hole) & _mask)) {
				_entries[p_hole] = _entries[i];
				p_hole = i;
			}
		}
		_entries[p_hole] = {};
	}

	void grow() {
		std::vector<Entry> before(_entries.size() * 2);
		before.swap(_entries);
		_mask = uint32_t(_entries.size() - 1);
		for (const Entry &entry : before) {
			if (entry.key != NO_KEY) {
				_entries[seek(entry.key)] = entry;
			}
		}
	}

	std::vector<Entry> _entries = std::vector<Entry>(2); // as few as its contents so far allow, so that they stay in the cache
	size_t _count = 0; // squares in use, at most half of the entries
	std::vector<Square> _squares; // those in use come first, so that what a step needs is close together
	SlotSet _free;
	uint32_t _mask = 1;
};

} // namespace grass
