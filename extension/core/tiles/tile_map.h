// SPDX-License-Identifier: MIT
// Maps a tile's index to a number, by open addressing. As small as its contents so far allow, so that it stays in the cache.
#pragma once

#include "core/base/hash.h"

#include <vector>

namespace grass {

class TileMap {
public:
	static constexpr int NONE = -1;

	// Empties the map.
	void clear() {
		_places.assign(FIRST_PLACES, {});
		_count = 0;
	}

	// Returns the tile's number, or NONE.
	int find(int p_tile) const { return _places[seek(p_tile)].value; }

	// Adds a tile that must not be in the map.
	void insert(int p_tile, int p_value) {
		if (++_count * 2 > _places.size()) {
			grow();
		}
		_places[seek(p_tile)] = { p_tile, p_value };
	}

	// Removes a tile. Does nothing if it is not in the map.
	void erase(int p_tile) {
		uint32_t hole = seek(p_tile);
		if (_places[hole].tile == NONE) {
			return;
		}
		_count--;
		// An entry that was pushed past the hole moves back into it, so that no search stops too early.
		for (uint32_t i = (hole + 1) & mask(); _places[i].tile != NONE; i = (i + 1) & mask()) {
			const uint32_t home = home_of(_places[i].tile);
			if (((i - home) & mask()) >= ((i - hole) & mask())) {
				_places[hole] = _places[i];
				hole = i;
			}
		}
		_places[hole] = {};
	}

	size_t get_memory_usage() const { return _places.capacity() * sizeof(Place); } // Bytes.

private:
	static constexpr size_t FIRST_PLACES = 1024; // a power of two
	static constexpr uint32_t ROW = 8;
	struct Place {
		int tile = NONE;
		int value = NONE;
	};

	// Eight neighbours in a row share a cache line, since colliders meet tiles row by row.
	uint32_t home_of(int p_tile) const { return (grass_hash(uint32_t(p_tile) / ROW) * ROW + uint32_t(p_tile) % ROW) & mask(); }

	// Returns the place of the tile, or the empty place where it belongs.
	uint32_t seek(int p_tile) const {
		uint32_t i = home_of(p_tile);
		while (_places[i].tile != p_tile && _places[i].tile != NONE) {
			i = (i + 1) & mask();
		}
		return i;
	}

	uint32_t mask() const { return uint32_t(_places.size() - 1); }

	void grow() {
		std::vector<Place> before(_places.size() * 2);
		before.swap(_places);
		for (const Place &place : before) {
			if (place.tile != NONE) {
				_places[seek(place.tile)] = place;
			}
		}
	}

	std::vector<Place> _places = std::vector<Place>(FIRST_PLACES);
	size_t _count = 0; // at most half of the places
};

} // namespace grass
