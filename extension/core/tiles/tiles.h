// SPDX-License-Identifier: MIT
// Which tiles are simulated: Algorithm 1 of Fan et al. 2015 (section 4.1) with the timestamps and the preallocated pool
// of section 5.2. Sees colliders and awake tiles only, never the field's other tiles.
#pragma once

#include "core/bodies/body_shape.h"
#include "core/detail/lod.h"
#include "core/solver/solver_params.h"
#include "core/solver/step.h"
#include "core/tiles/slot_map.h"
#include "core/tiles/slot_set.h"
#include "core/tiles/tile_bounds.h"
#include "core/tiles/tile_map.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace grass {

// SleepMode::TIMER: time from the last meeting to settling. Usual 1 to 5. Below 1 s blades still swing when they are put to
// rest; above 5 s tiles are simulated that nothing moves in.
inline constexpr Tunable SLEEP_DELAY{ "sleep_delay", "s", 0.0, 60.0, 0.1, 2.0 };
// SleepMode::ENERGY: how far from rest a calm blade is, or swings, at most. Usual 0.5 to 3. Above 5 mm blades are seen to
// stop; below 0.1 mm tiles are simulated that nobody sees move.
inline constexpr Tunable SLEEP_MOTION{ "sleep_motion", "mm", 0.01, 50.0, 0.01, 1.0 };
// Time on the way from wherever a blade is to rest. Usual 0.2 to 1. 0: it jumps there.
inline constexpr Tunable SETTLE_TIME{ "settle_time", "s", 0.0, 10.0, 0.05, 0.5 };

// When a tile that no collider meets goes to sleep.
enum class SleepMode {
	TIMER, // sleep_delay after the last meeting: the paper's
	ENERGY, // once its blades have been calm for a while
};

struct TileParams {
	static constexpr int MAX_POOL_SIZE = 16384; // The pool texture has a row a slot; GPUs allow 16,384 rows.

	int pool_size = 4096; // Tiles that can be awake at once; 0 to MAX_POOL_SIZE. Too small: far bodies bend nothing.
	SleepMode sleep_mode = SleepMode::ENERGY;
	double sleep_delay = SLEEP_DELAY.initial; // Seconds.
	double sleep_energy = SolverParams().energy_within(1e-3 * SLEEP_MOTION.initial); // Up to here blades are calm. J/kg.
	double settle_time = SETTLE_TIME.initial; // Seconds.
	// SleepMode::ENERGY: a tile on which nothing changed for so long is left as it is. Too short: blades stop while they still swing.
	// Seconds.
	double still_delay = SolverParams().calm_time();
	double overhang = 0.3; // Metres that blades lean out over their tile's square. Too small: bodies pass through tips.
	double low = 0.0; // Metres above the field: the lowest ground that tiles stand on.
	double height = 1.0; // Metres above the field: the highest tip. Too small: bodies pass through tips.
	uint32_t seed = 0; // Of the tiles' starts in the patch.
	double segment = 0.0; // Metres, of the longest blade. Too short: its edges meet no sharp bodies, see is_sharp().
	bool is_mapped = false; // StepInput::growth says how the blades grow.

	// The same within limits; NaN becomes the default.
	TileParams sanitised() const;
};

// now: after the last update. The rest counts since the last reset.
struct TileStatistics {
	int awake = 0; // now: tiles that have a slot
	int simulated = 0; // now: those of them that this step moves
	int settling = 0; // now: those of them that are on the way back to rest
	int still = 0; // now: awake tiles that are left as they are, since nothing on them changes
	int colliders = 0; // now: that meet an awake tile
	int list_entries = 0; // now: sum over the simulated tiles of their colliders
	int high_water = 0; // most tiles ever awake at once
	uint64_t tile_steps = 0; // awake tiles that were simulated, summed over the steps
	uint64_t unseen_steps = 0; // awake tiles that were not, since they are calm and out of view
	uint64_t still_steps = 0; // awake tiles that were not, since nothing changed on them
	uint64_t woken = 0; // tiles that got a slot
	uint64_t slept = 0; // tiles that came to rest and gave it back
	uint64_t evicted = 0; // tiles that lost it to another before they were at rest
	uint64_t refused = 0; // colliders, one a step, that met tiles without a slot when the full pool had none to give
	uint64_t looked_at = 0; // tiles tested against a collider
	uint64_t capped = 0; // tiles under a collider that were not looked at, since work a step is bounded
	uint64_t bad_colliders = 0; // shapes left out since ColliderShape::sanitise() refused them
};

class TileManager {
public:
	TileManager() { reset(); }

	// A new grid, another pool size or another seed puts every tile to rest at once, as reset() does.
	void set_grid(const TileGrid &p_grid);
	void set_params(const TileParams &p_params);
	// The boxes around the tiles' blades; without them a tile's box is its square grown by TileParams' overhang and height.
	void set_bounds(std::shared_ptr<const TileBounds> p_bounds) { _bounds = std::move(p_bounds); }
	const TileGrid &get_grid() const { return _grid; }
	const TileParams &get_params() const { return _params; }

	// Forgets all awake tiles and counts, without records: the backend empties its tile table too.
	void reset();

	// What is seen of the field from now on: tiles within one of the frustums (field space), or within p_margin metres of
	// it. Out of view a tile is simulated only while something moves in it; it goes on where it stopped, or is at rest
	// by then. Before the first call, and after see_all(), everything is seen.
	void see(std::span<const Frustum> p_frustums, float p_margin);
	void see_all() { _sees_all = true; }
	bool is_field_seen() const; // any of its tiles, or what stands on them
	// The ground changed under these tiles: the next step moves those that are awake, even out of view.
	void stir(const TileRange &p_tiles);
	// p_delta seconds have passed in which nobody saw any of it and update() was not called.
	void pass_unseen(double p_delta);

	// One step of p_delta seconds (not finite or negative: 0). Mends p_colliders, see ColliderShape::sanitise(). The
	// same calls make the same records, bit for bit. What the getters below return holds until the next call.
	void update(double p_delta, std::span<ColliderShape> p_colliders);
	// Of the last update, 0 before the first; never falls, not even by reset().
	uint64_t get_step_number() const { return _step_number; }

	// Retired tiles first, then the live ones that are simulated by rising slot. A slot can be in both parts: given away at once.
	std::span<const GrassSlot> get_slots() const { return { _records.data(), _record_count }; }
	std::span<const GrassCollider> get_colliders() const { return _colliders; }
	std::span<const uint8_t> get_sharp() const { return _sharp; } // of the colliders, see is_sharp()
	std::span<const uint32_t> get_collider_list() const { return _collider_list; }
	std::span<const Eigen::Vector4f> get_planes() const { return _planes; }
	const TileStatistics &get_statistics() const { return _statistics; }

	// Never more entries than this in get_collider_list(), for buffers made once.
	int get_list_capacity() const { return std::max(MIN_LIST_CAPACITY, ENTRIES_PER_SLOT * _params.pool_size); }

	// Decides who is calm: goes to sleep, or gives way in a full pool. Left out: what is not finite, and what was measured
	// before the tile was last met, thus also the energies of slots that were other tiles' then.
	void report_energy(const EnergyReport &p_report);

	// [Eq M5] Of an awake tile, as reported; zero of one at rest, and while nothing is known.
	Eigen::Vector3f get_bend(int p_tile) const;
	// Whether collider p_collider of the last update met grass: the box around the blades of a tile on which some stand.
	bool has_met_grass(size_t p_collider) const { return p_collider < _has_met.size() && _has_met[p_collider] != 0; }

	int get_slot_of(int p_tile) const; // GRASS_NO_SLOT if it has none.
	int get_tile_of(int p_slot) const; // TileMap::NONE if the slot is free or does not exist.
	bool is_awake(int p_tile) const; // Has a slot.
	bool is_settling(int p_tile) const; // Awake, and on the way back to rest.
	size_t get_memory_usage() const; // Bytes; does not depend on the field's size.

private:
	static constexpr int ENTRIES_PER_SLOT = 16; // The paper's scene has one (128 objects on 32 tiles, 4,096 slots).
	static constexpr int MIN_LIST_CAPACITY = 4096;
	static constexpr float NO_ENERGY = std::numeric_limits<float>::infinity(); // not reported yet: gives way last
	static constexpr double NEVER = std::numeric_limits<double>::infinity();

	// What is known of an awake tile, in parts: a step goes through all awake tiles, and what costs then is the memory that it has
	// to fetch. When things happened, seconds on _time:
	struct Times {
		double met = 0.0; // the last step in which a collider was in the tile
		double stirred = 0.0; // the last step in which a collider moved in the tile, came or left
		double calm_since = NEVER;
		double simulated = 0.0; // not when: for how long since it was stirred
	};

	// How calm it is.
	struct Motion {
		float energy = NO_ENERGY; // since the last meeting
		uint32_t met_step = 0; // number of the step of Times::met, its lower half
	};

	// Where it is.
	struct Place {
		TileBounds::Tile tile;
		uint32_t start = 0; // first blade in the patch
	};

	// What is seldom read.
	struct Life {
		uint64_t woken_step = 0; // number of the step
		double settle_left = 0.0; // seconds to rest, while settling
		float blend = 0.0f; // while settling: of this step's record; 1: at rest after it
	};

	// A frustum as tiles meet it: outside of a plane are those with x * first + z * second > third.
	using TileFrustum = std::array<Eigen::Vector3f, 6>;

	// A collider whose box meets that of a tile's blades. The tile goes by its place in _to_activate until it has a slot.
	struct Meeting {
		int slot; // ~place until the tile has one
		uint32_t collider;
	};

	// A tile below a collider's box.
	struct Found {
		uint16_t x, z;
		int slot;
	};
	static constexpr size_t QUEUED_BITS = 4096;

	// How calm a tile is that may give way, and its slot in the lowest bits: the calmest is least. Settling tiles before others,
	// then by energy where it was reported, then by who was met longest ago, up to some minutes.
	using Calm = uint64_t;
	static constexpr int SLOT_BITS = 14, AGE_BITS = 18; // and 31 of a positive float, and one
	static_assert(TileParams::MAX_POOL_SIZE <= 1 << SLOT_BITS);

	void begin_step();
	void find_met_tiles(std::span<ColliderShape> p_colliders);
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
	static size_t queued_bit(int p_square_x, int p_square_z) {
		return (uint32_t(p_square_x) * 73856093u ^ uint32_t(p_square_z) * 19349663u) % QUEUED_BITS;
	}
	void set_queued(int p_square_x, int p_square_z) {
		const size_t bit = queued_bit(p_square_x, p_square_z);
		_queued_squares[bit / 64] |= uint64_t(1) << bit % 64;
	}
	bool may_be_queued(int p_square_x, int p_square_z) const {
		const size_t bit = queued_bit(p_square_x, p_square_z);
		return (_queued_squares[bit / 64] >> bit % 64 & 1) != 0;
	}

	void activate_tiles();
	void activate(int p_slot, int p_tile);
	int take_calmest_slot(size_t p_wanted);
	Calm calm_of(int p_slot) const;
	void find_yielding(size_t p_wanted);

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

	void find_tile_frustums();
	bool is_seen(const Place &p_place) const;
	bool is_past(int p_slot) const;

	void count_meetings(std::span<const ColliderShape> p_colliders);
	void pack_collider(const ColliderShape &p_collider);
	void write_records();
	void write_list();

	TileGrid _grid;
	TileParams _params;
	std::shared_ptr<const TileBounds> _bounds;
	bool _sees_all = true;
	bool _has_passed_unseen = false; // since the last step
	std::vector<Frustum> _frustums;
	float _margin = 0.0f; // metres
	std::vector<TileFrustum> _tile_frustums; // of _frustums, in this step
	double _time = 0.0; // seconds since reset
	uint64_t _step_number = 0;

	// The pool: memory of every slot, made once. _used is the paper's ActivatedTileList.
	std::vector<Times> _times;
	std::vector<Motion> _motions;
	std::vector<Place> _places;
	std::vector<Life> _lives;
	std::vector<uint32_t> _entries; // of this step: colliders; then where in the collider list the next of them is written
	std::vector<uint16_t> _forces; // of this step: bits of those that move the tile
	SlotSet _free, _used, _settling;
	// Of this step: met by a collider; by one that moves, comes or has left; by none; awake since; not simulated, since calm and out of
	// view or since still; the others.
	SlotSet _met, _stirred, _unmet, _fresh, _skipped, _simulated;
	std::vector<uint64_t> _signatures,
			_signatures_before; // by slot: which colliders stand where in its tile, in this step and the last one
	SlotMap _slot_of_tile;
	uint64_t _reported_step = 0, _bend_step = 0; // of the last report, and of the one that had bends
	std::vector<Eigen::Vector3f> _bends; // by slot, as reported

	// Of one step. _to_activate is the paper's ToActivateTileList without the tiles already active.
	// Of the colliders, one each or one for each piece of a long way: tiles, boxes, whose.
	std::vector<TileRange> _ranges;
	std::vector<Bounds> _swept;
	std::vector<uint32_t> _range_colliders;
	std::vector<uint8_t> _has_met; // of the colliders: grass
	std::vector<int> _asleep; // of the ranges: tiles
	std::vector<Found> _found; // of a range
	std::vector<const SlotMap::Square *> _squares; // of the ranges, one after the other
	std::vector<Meeting> _meetings, _meetings_awake, _meetings_asleep;
	std::array<uint64_t, QUEUED_BITS / 64> _queued_squares{}; // a bit for the squares that hold a tile of _to_activate, and for others
	std::vector<int> _to_activate, _given_slots;
	TileMap _place_of_tile;
	std::vector<Calm> _calm; // of all that may give way
	std::vector<Calm> _yielding; // those that will, calmest last
	bool _yielding_known = false;

	std::vector<GrassSlot> _records; // room for all there can be
	size_t _record_count = 0;
	std::vector<GrassCollider> _colliders;
	std::vector<uint8_t> _sharp; // of the colliders, see is_sharp()
	std::vector<uint32_t> _collider_list;
	std::vector<Eigen::Vector4f> _planes;
	TileStatistics _statistics;
};

} // namespace grass
