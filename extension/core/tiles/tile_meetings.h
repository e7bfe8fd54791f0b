// SPDX-License-Identifier: MIT
// Finds which tiles colliders meet: lines 1 to 9 of Algorithm 1 of Fan et al. 2015.
#pragma once

#include "core/base/parallel_for.h"
#include "core/bodies/body_shape.h"
#include "core/tiles/queued_squares.h"
#include "core/tiles/slot_map.h"
#include "core/tiles/slot_set.h"
#include "core/tiles/tile_bounds.h"
#include "core/tiles/tile_footprint.h"
#include "core/tiles/tile_map.h"
#include "core/tiles/tile_params.h"
#include "core/tiles/tile_view.h"
#include "core/tiles/tile_way.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace grass {

class TileMeetings {
public:
	// The data of the tiles that it reads, and the places where it records met slots and counts.
	struct Tiles {
		const TileGrid &grid;
		const TileParams &params;
		int limit; // tiles that may be awake in this step
		int room; // slots that exist
		const TileBounds *bounds; // null: a tile's box is its square, enlarged
		const TileView &view; // in this step
		const SlotMap &slots; // of awake tiles
		const SlotSet &held; // awake tiles in view, as far as that is known
		const std::vector<int> &yielded; // tiles that lost their slots at the beginning of the step, and get none in it
		SlotSet &met, &stirred; // by a collider; by one that moves
		TileStatistics &statistics;
	};

	// A collider whose box meets that of a tile's blades. A sleeping tile is identified by its place in get_wanted() until it has a slot.
	struct Meeting {
		int slot; // ~place until the tile has one
		uint32_t collider;
	};

	void reset();
	// Forgets the colliders that do not move, since the tiles' boxes or limits have changed.
	void forget() { _known.clear(); }
	// Finds the meetings. Repairs p_colliders, see ColliderShape::sanitise(). The result and its order are the same with any number of
	// threads.
	void find(const Tiles &p_tiles, std::span<ColliderShape> p_colliders, const ParallelFor &p_parallel_for);

	std::vector<Meeting> &get() { return _meetings; } // ascending by collider
	// Returns the sleeping tiles that are met, as many as can get a slot: the paper's ToActivateTileList without the active tiles.
	const std::vector<int> &get_wanted() const { return _wanted; }
	// Keeps only the first p_kept of them.
	void hold_back(size_t p_kept);
	// Returns true if collider p_collider met grass: the box around the blades of a tile with any.
	bool has_met_grass(size_t p_collider) const { return p_collider < _met.size() && _met[p_collider] != MET_NOTHING; }
	// Returns true if one of these tiles has a slot, or gets one in this step.
	bool has_met_awake(size_t p_collider) const { return p_collider < _met.size() && _met[p_collider] == MET_AWAKE; }
	// A tile that cameras see, and that found no slot.
	struct Waiting {
		int tile, band; // see TileView
	};
	// Returns some of those in this step, nearest first: as many as may get a slot in the next one.
	std::span<const Waiting> get_waiting() const { return _waiting; }
	// Returns true if there may be too few slots for the tiles that are met.
	bool is_short() const { return _is_short; }
	// Returns for about how many tiles there was no slot in this step: sleeping tiles below colliders, some of which they may not meet.
	int count_refused() const { return _refused; }
	size_t get_memory_usage() const; // bytes

private:
	static constexpr int BARRED = -2; // in place of a place: the tile gets no slot in this step

	// A tile below a collider's box.
	struct Found {
		uint16_t x, z;
		int slot;
	};
	using Way = TileWay;
	// What ways may meet together: the most that one of them may, and what is left for those that follow.
	struct Limits {
		int64_t most, left;
	};
	using LimitsBySight = std::array<Limits, 2>; // of ways out of view, and of those in view
	// What a collider has met.
	enum Met : uint8_t { MET_NOTHING, MET_GRASS, MET_AWAKE };
	using Known = KnownWay;

	// A group of PARALLEL_BLOCK consecutive colliders, for one thread at a time. All of it but known_slots_before is for one step.
	struct Block {
		std::vector<Way> ways; // of the colliders, ascending
		std::vector<Way> whole; // the same before limits were applied
		std::vector<const SlotMap::Square *> squares; // of the ranges, in order, row by row
		std::vector<Found> found; // of a range
		std::vector<Meeting> meetings, meetings_asleep; // with tiles that have slots, and with tiles that have none
		std::vector<int> known_slots, known_slots_before; // of the colliders with stamps, in order; in this step and the last one
		SlotSet met, stirred; // as in Tiles
		uint64_t bad_colliders = 0, looked_at = 0, refused = 0; // as in TileStatistics

		void begin(int p_room);
	};
	// A way over tiles of which cameras see some.
	struct SeenWay {
		const Way *way;
		Block *block;
		int band; // see TileView
	};

	std::span<Block> get_blocks() { return std::span(_blocks).first(_block_count); }
	void begin(size_t p_colliders);
	void bar_yielded();
	void meet_awake_tiles(std::span<const ColliderShape> p_colliders, Block &r_block);
	static void end_way(const Way &p_way, const Block &p_block, std::vector<Meeting> &r_meetings);
	void find_squares(Way &r_way, Block &r_block);
	void meet_again(const Way &p_way, Block &r_block);
	void meet_awake(Way &r_way, bool p_moves, Block &r_block);
	int keep_met(int p_count, const Bounds &p_swept, Block &r_block) const;
	void note_met(uint32_t p_collider, Met p_met) { _met[p_collider] = std::max(_met[p_collider], p_met); }
	void gather();
	// tile_meetings_ways.cpp
	void add_collider(ColliderShape &r_collider, uint32_t p_index, Block &r_block);
	static void follow_growth(ColliderShape &r_collider, Known &r_known);
	void add_ways(const ColliderShape &p_collider, uint32_t p_index, Block &r_block);
	void limit_ranges(std::span<const ColliderShape> p_colliders);
	LimitsBySight find_limits(int64_t p_total, size_t p_ways);
	void limit_ways(std::span<const ColliderShape> p_colliders, int64_t p_wide, LimitsBySight &r_limits, Block &r_block);
	int64_t narrow(const ColliderShape &p_collider, const Way &p_way, int64_t p_limit, Block &r_block);
	void add_outline(const TileFootprint &p_footprint, const Way &p_way, int p_middle, bool p_seen, int64_t &r_left, Block &r_block) const;
	void add_span(const Way &p_way, int p_z, const TileFootprint::Span &p_span, bool p_seen, int64_t &r_left, Block &r_block) const;
	TileRange find_range(const Bounds &p_swept) const;
	// tile_meetings_asleep.cpp
	void meet_asleep_tiles(const ParallelFor &p_parallel_for);
	void meet_asleep_tiles_of(Block &r_block, size_t p_room);
	int find_asleep(const Way &p_way, bool p_queued, Block &r_block) const;
	bool queue_tiles(const Way &p_way, size_t p_room, Block &r_block);
	bool meet_queued_tiles(const Way &p_way, Block &r_block);
	bool meets_asleep(const Way &p_way, Block &r_block) const;
	// tile_meetings_seen.cpp
	size_t queue_seen_tiles(size_t p_room);
	void find_seen_ways();
	void queue_seen_tiles_of(const SeenWay &p_seen, size_t p_room, size_t p_most_waiting);
	int queue(int p_x, int p_z);

	const Tiles *_tiles = nullptr; // during find()
	std::vector<Block> _blocks; // in this step the first _block_count are used
	size_t _block_count = 0;
	std::vector<Known> _known; // of the colliders
	std::vector<Met> _met; // of the colliders
	std::vector<Meeting> _meetings;
	std::vector<int> _wanted;
	TileMap _place_of_tile; // in _wanted; BARRED
	std::vector<int> _barred; // tiles
	QueuedSquares _queued;
	std::vector<SeenWay> _seen_ways; // of this step
	std::vector<Waiting> _waiting;
	SlotSet _unmet_seen; // awake tiles in view that no collider meets
	bool _is_short = false;
	int _refused = 0; // see count_refused()
};

} // namespace grass
