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

#include <algorithm>
#include <cstdint>
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
	// What is known of colliders that stand still holds no longer: the tiles' boxes or limits are other ones.
	void forget() { _known.clear(); }
	// Mends p_colliders, see ColliderShape::sanitise().
	void find(const Tiles &p_tiles, std::span<ColliderShape> p_colliders);

	std::vector<Meeting> &get() { return _meetings; } // rising by collider
	// Tiles that are met and sleep, as many as can get a slot. The paper's ToActivateTileList without the tiles already active.
	const std::vector<int> &get_wanted() const { return _wanted; }
	// Whether collider p_collider met grass: the box around the blades of a tile on which some stand.
	bool has_met_grass(size_t p_collider) const { return p_collider < _met.size() && _met[p_collider] != MET_NOTHING; }
	// Whether one of these tiles has a slot, or gets one in this step.
	bool has_met_awake(size_t p_collider) const { return p_collider < _met.size() && _met[p_collider] == MET_AWAKE; }
	size_t get_memory_usage() const; // bytes

private:
	// A tile below a collider's box.
	struct Found {
		uint16_t x, z;
		int slot;
	};
	// A collider's way in the step, or a piece of a long one.
	struct Way {
		Bounds swept; // the box around it
		TileRange range; // tiles that it may meet
		uint32_t collider;
		uint32_t squares = 0; // where those of its range begin
		int asleep = 0; // tiles of the range
		bool is_kept = false; // it meets what it met in the last step
	};
	// What a collider has met.
	enum Met : uint8_t { MET_NOTHING, MET_GRASS, MET_AWAKE };
	// Of a collider of the last step with a stamp: what follows from it.
	struct Known {
		uint64_t stamp = 0; // 0: nothing is known
		Bounds swept;
		TileRange whole, range; // as it is, and as far as the list had room
		uint32_t first = 0, count = 0; // its slots
		bool is_good = false; // else it was refused
		bool is_complete = false; // all tiles that it meets have slots
	};

	void begin(size_t p_colliders);
	void add_collider(ColliderShape &r_collider, uint32_t p_index);
	void limit_ranges(std::span<const ColliderShape> p_colliders);
	TileRange find_range(const Bounds &p_swept) const;
	void add_ways(const ColliderShape &p_collider, uint32_t p_index);
	void note_met(uint32_t p_collider, Met p_met) { _met[p_collider] = std::max(_met[p_collider], p_met); }
	void end_way(const Way &p_way, std::vector<Meeting> &r_meetings) const;
	void find_squares(Way &r_way);
	void meet_again(const Way &p_way);
	void meet_awake(Way &r_way, bool p_moves);
	int keep_met(int p_count, const Bounds &p_swept);
	void meet_asleep_tiles();
	int find_asleep(const Way &p_way, bool p_queued);
	bool queue_tiles(const Way &p_way, size_t p_room);
	bool meet_queued_tiles(const Way &p_way);
	bool meets_asleep(const Way &p_way);

	const Tiles *_tiles = nullptr; // during find()
	std::vector<Way> _ways; // of the colliders, rising
	std::vector<Known> _known; // of the colliders
	std::vector<int> _known_slots, _known_slots_before; // of the colliders with stamps, one after the other
	std::vector<Met> _met; // of the colliders
	std::vector<Found> _found; // of a range
	std::vector<const SlotMap::Square *> _squares; // of the ranges, one after the other, row by row
	std::vector<Meeting> _meetings, _meetings_awake, _meetings_asleep;
	std::vector<int> _wanted;
	TileMap _place_of_tile; // in _wanted
	QueuedSquares _queued;
};

} // namespace grass
