// SPDX-License-Identifier: MIT
// Chooses which tiles are simulated: Algorithm 1 of Fan et al. 2015 (section 4.1) with the timestamps of section 5.2, and a pool that is as
// large as the awake tiles need. It visits colliders and awake tiles only, never the field's other tiles.
#pragma once

#include "core/lod/tile_detail.h"
#include "core/solver/step.h"
#include "core/tiles/pool_budget.h"
#include "core/tiles/room_plan.h"
#include "core/tiles/tile_colliders.h"
#include "core/tiles/tile_meetings.h"
#include "core/tiles/tile_params.h"
#include "core/tiles/tile_view.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace grass {

class TileManager {
public:
	TileManager() { reset(); }

	// Sets the grid, and the parameters. Another grid, pool size or seed puts every tile to rest at once, as reset() does.
	void set_grid(const TileGrid &p_grid);
	void set_params(const TileParams &p_params);
	// Sets the boxes around the tiles' blades; without them a tile's box is its square, enlarged by TileParams' overhang and height.
	void set_bounds(std::shared_ptr<const TileBounds> p_bounds) {
		_bounds = std::move(p_bounds);
		_meetings.forget();
	}
	const TileGrid &get_grid() const { return _grid; }
	const TileParams &get_params() const { return _params; }

	// Changes TileParams::pool_size between two steps, and returns what happened to awake tiles. If more are awake than may be, the calmest
	// come to rest at once, those out of view before others. Each keeps its slot if that still exists.
	std::vector<SlotMove> resize_pool(int p_slots);
	// Does the same for what a PoolBudget grants: the smaller number holds.
	std::vector<SlotMove> grant(int p_slots);
	int get_limit() const { return std::min(_params.pool_size, _granted); } // tiles that may be awake
	// Returns how many slots exist: none before a tile wakes, then a power of two, as long as the pool may have so many. update() makes
	// more when tiles wake.
	int get_room() const { return _room; }
	RoomPlan &get_room_plan() { return _room_plan; }
	const RoomPlan &get_room_plan() const { return _room_plan; }
	// Must be called once in each tick of p_delta seconds. Frees slots that were not needed for some seconds, and returns the tiles that
	// have others now.
	std::vector<SlotMove> trim(double p_delta);
	// Returns how many tiles the field needs slots for, after an update.
	PoolDemand find_demand();
	// Returns true if the last update found no slots for all tiles, though the pool's own size would have allowed them.
	bool lacks_grant() const { return _granted < _params.pool_size && _meetings.is_short(); }

	// Forgets all awake tiles and statistics, without making records: the backend empties its tile table too.
	void reset();

	// Gives access to the views of the field. Out of view, a tile is simulated only while something moves in it. In view again, it
	// continues where it stopped, or is at rest by then.
	TileView &get_view() { return _view; }
	// Gives access to the numbers of simulated blades. After a change, widen() must be called.
	TileDetail &get_detail() { return _detail; }
	const TileDetail &get_detail() const { return _detail; }
	// Sets how many blades of the awake tiles are drawn and simulated from now on. Returns the tiles in which more are drawn than before,
	// as records for join(). Valid until the next call.
	std::span<const GrassSlot> widen();
	bool is_field_seen() const { return _view.sees_field(_grid, _params); }
	// Must be called when the ground under these tiles has changed: the next step simulates those that are awake, even out of view.
	void stir(const TileRange &p_tiles);
	// Must be called after p_delta seconds in which no part of the field was visible and update() was not called.
	void pass_unseen(double p_delta);

	// Takes one step of p_delta seconds (not finite or negative: 0). Repairs p_colliders, see ColliderShape::sanitise(). The same calls
	// make the same records, bit for bit, with any number of threads. The results of the getters below are valid until the next call.
	void update(double p_delta, std::span<ColliderShape> p_colliders, const ParallelFor &p_parallel_for = serial_for);
	// Returns the number of the last update, 0 before the first. It never falls, not even by reset().
	uint64_t get_step_number() const { return _step_number; }

	// The records: retired tiles first, then the live tiles that are simulated, ascending by slot. A slot can be in both parts, if it was
	// taken away and used again at once.
	std::span<const GrassSlot> get_slots() const { return { _records.data(), _record_count }; }
	// Returns, as records for join(), the live tiles of which more blades are drawn than simulated: the others follow in this step.
	std::span<const GrassSlot> get_followers() const { return _followers; }
	std::span<const GrassCollider> get_colliders() const { return _colliders.get(); }
	std::span<const uint8_t> get_sharp() const { return _colliders.get_sharp(); } // for each collider, see is_sharp()
	std::span<const uint32_t> get_collider_list() const { return _collider_list; }
	std::span<const Eigen::Vector4f> get_planes() const { return _colliders.get_planes(); }
	const TileStatistics &get_statistics() const { return _statistics; }

	// Returns the most entries in get_collider_list(), for buffers that are made once.
	int get_list_capacity() const { return _params.list_capacity(); }

	// Determines which tiles are calm: these go to sleep, or give way in a full pool. Ignores values that are not finite, and those
	// measured before the tile was last met, which excludes energies of another tile in the same slot.
	void report_energy(const EnergyReport &p_report);

	// [Eq M5] Returns the reported bend of an awake tile; zero for a tile at rest, and until one is reported.
	Eigen::Vector3f get_bend(int p_tile) const;
	// Returns true if collider p_collider of the last update met grass: the box around the blades of a tile with any.
	bool has_met_grass(size_t p_collider) const { return _meetings.has_met_grass(p_collider); }
	// Returns true if one of these tiles is awake now.
	bool has_met_awake(size_t p_collider) const { return _meetings.has_met_awake(p_collider); }

	int get_slot_of(int p_tile) const; // GRASS_NO_SLOT if it has none.
	int get_tile_of(int p_slot) const; // TileMap::NONE if the slot is free or does not exist.
	bool is_awake(int p_tile) const; // It has a slot.
	bool is_settling(int p_tile) const; // Awake, and on the way back to rest.
	size_t get_memory_usage() const; // Bytes; does not depend on the field's size.

private:
	static constexpr float NO_ENERGY = std::numeric_limits<float>::infinity(); // not reported yet: such tiles give way last
	static constexpr double NEVER = std::numeric_limits<double>::infinity();

	// The state of an awake tile, in parts. A step visits all awake tiles, and its cost is the memory that it fetches. These are points in
	// time, seconds on _time:
	struct Times {
		double met = 0.0; // the last step in which a collider was in the tile
		double stirred = 0.0; // the last step in which a collider moved in the tile, came or left
		double calm_since = NEVER;
		double simulated = 0.0; // a duration: how long the tile has been simulated since it was stirred
		// The last step with a collider or a storm in the tile, or in which not all of the blades that are drawn were simulated.
		double chained = -NEVER;
	};

	// The motion of a tile.
	struct Motion {
		float energy = NO_ENERGY; // since the last meeting
		uint32_t met_step = 0; // lower half of the number of the step of Times::met
	};

	// The place of a tile.
	struct Place {
		TileBounds::Tile tile;
		uint32_t start = 0; // first blade in the patch
	};

	// How many blades of a tile are drawn, and how many of them are simulated; and in how many steps the others arrive where those that
	// they follow lead them.
	struct Blades {
		uint8_t drawn = 0, simulated = 0, steps_apart = 0;
	};

	// State that is seldom read.
	struct Life {
		uint64_t woken_step = 0; // number of the step
		double settle_left = 0.0; // seconds to rest, while settling
		float blend = 0.0f; // while settling: blend of this step's record; 1: at rest after it
	};

	// How calm a tile is that may give way, with its slot in the lowest bits: the calmest is least. Tiles out of view come before others,
	// then settling ones, then by energy if it was reported, then by how long ago they were met, up to some minutes.
	using Calm = uint64_t;
	static constexpr int SLOT_BITS = 14, AGE_BITS = 17; // and 31 of a positive float, and two
	static_assert(TileParams::MAX_POOL_SIZE <= 1 << SLOT_BITS);

	void begin_step();
	void activate_tiles();
	void activate(int p_slot, int p_tile);
	int take_calmest_slot(size_t p_wanted);
	Calm calm_of(int p_slot) const;
	void find_yielding(size_t p_wanted);
	std::vector<SlotMove> fit_limit();
	void rest_calmest(int p_count, std::vector<SlotMove> &r_moves);
	void set_room(int p_slots, std::vector<SlotMove> &r_moves);
	void forget_step();
	int take_slot(size_t p_wanted);
	void move_slot(int p_from, int p_to);
	std::array<SlotSet *, 10> slot_sets() {
		return { &_free, &_used, &_settling, &_held, &_met, &_stirred, &_unmet, &_fresh, &_skipped, &_simulated };
	}
	void yield_to_waiting();

	void sign_meetings(std::span<const ColliderShape> p_colliders);
	void deactivate_tiles(double p_delta);
	void keep_awake(int p_slot, bool p_is_stirred);
	bool is_calm(int p_slot) const;
	bool is_unstirred(int p_slot) const;
	bool is_still(int p_slot) const;
	bool should_settle(int p_slot) const;
	void settle(int p_slot, double p_delta);
	float blend_of(int p_slot) const { return _settling.has(p_slot) ? _lives[size_t(p_slot)].blend : 0.0f; }
	void retire(int p_slot, bool p_is_at_rest);
	bool is_seen(int p_slot) const;
	bool is_past(int p_slot) const;

	void count_meetings(std::span<const ColliderShape> p_colliders);
	void write_records();
	bool is_alone(int p_slot, uint32_t p_colliders);
	void write_follower(const GrassSlot &p_record);
	void write_list();

	TileGrid _grid;
	TileParams _params;
	std::shared_ptr<const TileBounds> _bounds;
	TileView _view;
	TileDetail _detail;
	bool _has_passed_unseen = false; // since the last step
	double _time = 0.0; // seconds since reset
	uint64_t _step_number = 0;

	// The pool: the state of every slot that exists. _used is the paper's ActivatedTileList.
	int _room = 0;
	int _granted = PoolBudget::MOST_TILES; // tiles
	RoomPlan _room_plan;
	std::vector<Times> _times;
	std::vector<Motion> _motions;
	std::vector<Place> _places;
	std::vector<Life> _lives;
	std::vector<Blades> _blades;
	std::vector<uint32_t> _entries; // in this step: number of colliders; later the index in the collider list for the next one
	std::vector<uint16_t> _forces; // in this step: bits of the forces that move the tile
	std::vector<float> _air; // of these: the sum of their speeds, m/s
	SlotSet _free, _used, _settling;
	SlotSet _held; // in view, at the begin of a step in which slots are short; else empty
	// Of this step: met by a collider; by one that moves, comes or has left; by none; awake since; not simulated, since calm and out of
	// view or since still; the others.
	SlotSet _met, _stirred, _unmet, _fresh, _skipped, _simulated;
	std::vector<uint64_t> _signatures,
			_signatures_before; // by slot: a hash of the colliders in its tile and of their poses, in this step and the last one
	SlotMap _slot_of_tile;
	uint64_t _reported_step = 0, _bend_step = 0; // steps of the last report, and of the last one with bends
	uint64_t _moved_step = 0; // tiles changed slots after it: reports of earlier steps are of others
	std::vector<Eigen::Vector3f> _bends; // by slot, as reported

	// For one step.
	TileMeetings _meetings;
	std::vector<int> _given_slots; // for the tiles that the meetings want
	std::vector<Calm> _calm; // all that may give way
	std::vector<Calm> _yielding; // those that will give way, calmest last
	bool _yielding_known = false;
	std::vector<int> _yielded; // tiles that lost their slots to others that cameras see better
	std::vector<int> _seen_worst; // awake tiles: band of their distance (see TileView) and slot

	std::vector<GrassSlot> _widened; // of widen()
	std::vector<GrassSlot> _followers; // of this step
	std::vector<GrassSlot> _records; // two for each slot, which may be taken away and used again in the same step
	size_t _record_count = 0;
	TileColliders _colliders;
	std::vector<uint32_t> _collider_list;
	TileStatistics _statistics;
};

} // namespace grass
