// SPDX-License-Identifier: MIT
// Which tiles colliders meet: lines 1 to 9 of Algorithm 1 of Fan et al. 2015.
#pragma once

#include "core/bodies/body_shape.h"
#include "core/tiles/queued_squares.h"
#include "core/tiles/slot_map.h"
#include "core/tiles/slot_set.h"
#include "core/tiles/tile_bounds.h"
#include "core/tiles/tile_map.h"
#include "core/tiles/tile_params.h"

#include <span>
#include <vector>

namespace grass {

class TileMeetings {
public:
	// What it reads of the tiles, and where it notes slots that are met and what it counts.
	struct Tiles {
		const TileGrid &grid;
		const TileParams &params;
		const TileBounds *bounds; // null: a tile's box is its square, grown
		const SlotMap &slots; // of awake tiles
		SlotSet &met, &stirred; // by a collider; by one that moves
		TileStatistics &statistics;
	};

	// A collider whose box meets that of a tile's blades. A tile that sleeps goes by its place in get_wanted() until it has a slot.
	struct Meeting {
		int slot; // ~place until the tile has one
		uint32_t collider;
	};

	void reset();
	// Mends p_colliders, see ColliderShape::sanitise().
	void find(const Tiles &p_tiles, std::span<ColliderShape> p_colliders);

	std::vector<Meeting> &get() { return _meetings; } // rising by collider
	// Tiles that are met and sleep, as many as can get a slot. The paper's ToActivateTileList without the tiles already active.
	const std::vector<int> &get_wanted() const { return _wanted; }
	// Whether collider p_collider met grass: the box around the blades of a tile on which some stand.
	bool has_met_grass(size_t p_collider) const { return p_collider < _has_met.size() && _has_met[p_collider] != 0; }
	size_t get_memory_usage() const; // bytes

private:
	// A tile below a collider's box.
	struct Found {
		uint16_t x, z;
		int slot;
	};

	void begin();
	TileRange find_range(const Bounds &p_swept) const;
	void add_ranges(const ColliderShape &p_collider, uint32_t p_index);
	template <typename F> void for_each_range(F &&p_meet);
	void end_range(size_t p_range, std::vector<Meeting> &r_meetings) const;
	void find_squares(const TileRange &p_range);
	int meet_awake(size_t p_range, const SlotMap::Square *const *p_squares, bool p_moves);
	int keep_met(int p_count, const Bounds &p_swept);
	void meet_asleep_tiles();
	int find_asleep(const TileRange &p_range, const SlotMap::Square *const *p_squares, bool p_queued);
	void queue_tiles(size_t p_range, const SlotMap::Square *const *p_squares, size_t p_room);
	void meet_queued_tiles(size_t p_range, const SlotMap::Square *const *p_squares);
	bool meets_asleep(const TileRange &p_range, const SlotMap::Square *const *p_squares, const Bounds &p_swept);

	const Tiles *_tiles = nullptr; // during find()
	// Of the colliders, one each or one for each piece of a long way: tiles, boxes, whose.
	std::vector<TileRange> _ranges;
	std::vector<Bounds> _swept;
	std::vector<uint32_t> _range_colliders;
	std::vector<uint8_t> _has_met; // of the colliders: grass
	std::vector<int> _asleep; // of the ranges: tiles
	std::vector<Found> _found; // of a range
	std::vector<const SlotMap::Square *> _squares; // of the ranges, one after the other
	std::vector<Meeting> _meetings, _meetings_awake, _meetings_asleep;
	std::vector<int> _wanted;
	TileMap _place_of_tile; // in _wanted
	QueuedSquares _queued;
};

} // namespace grass
