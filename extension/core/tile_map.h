// SPDX-License-Identifier: MIT
// Tile index -> number, for a bounded count of tiles whatever the field's size: open addressing in an array
// made once. Neither find nor insert nor erase ever allocates.
#pragma once

#include "core/hash.h"

#include <bit>
#include <vector>

namespace grass {

class TileMap {
public:
	static constexpr int NONE = -1;

	// Empties it, with room for p_capacity tiles.
	void reserve(int p_capacity) {
		_places.assign(std::bit_ceil(size_t(p_capacity) * 2 + 1), {});
		_mask = uint32_t(_places.size() - 1);
	}

	// The tile's number, or NONE.
	int find(int p_tile) const { return _places[seek(p_tile)].value; }

	// p_tile must not be in the map, and the map not hold its full capacity.
	void insert(int p_tile, int p_value) { _places[seek(p_tile)] = { p_tile, p_value }; }

	// Nothing if p_tile is not in the map.
	void erase(int p_tile) {
		uint32_t hole = seek(p_tile);
		if (_places[hole].tile == NONE) {
			return;
		}
		// Whoever was pushed past the hole moves back into it, so that no search stops short of him.
		for (uint32_t i = (hole + 1) & _mask; _places[i].tile != NONE; i = (i + 1) & _mask) {
			const uint32_t home = home_of(_places[i].tile);
			if (((i - home) & _mask) >= ((i - hole) & _mask)) {
				_places[hole] = _places[i];
				hole = i;
			}
		}
		_places[hole] = {};
	}

	size_t get_memory_usage() const { return _places.capacity() * sizeof(Place); } // Bytes.

private:
	static constexpr uint32_t ROW = 8;
	struct Place {
		int tile = NONE;
		int value = NONE;
	};

	// Eight neighbours in a row share a line of the cache: bodies touch tiles row by row.
	uint32_t home_of(int p_tile) const { return (grass_hash(uint32_t(p_tile) / ROW) * ROW + uint32_t(p_tile) % ROW) & _mask; }

	// Where the tile is, or the empty place where it belongs.
	uint32_t seek(int p_tile) const {
		uint32_t i = home_of(p_tile);
		while (_places[i].tile != p_tile && _places[i].tile != NONE) {
			i = (i + 1) & _mask;
		}
		return i;
	}

	std::vector<Place> _places = std::vector<Place>(1);
	uint32_t _mask = 0;
};

} // namespace grass
