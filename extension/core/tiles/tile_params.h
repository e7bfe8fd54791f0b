// SPDX-License-Identifier: MIT
// The parameters for choosing awake tiles, and statistics of that choice.
#pragma once

#include "core/solver/solver_params.h"

#include <algorithm>
#include <cstdint>

namespace grass {

// SleepMode::TIMER: time from the last meeting to settling. Usually 1 to 5. Below 1 s blades still swing when they are put to rest; above 5
// s tiles are simulated in which nothing moves.
inline constexpr Tunable SLEEP_DELAY{ "sleep_delay", "s", 0.0, 60.0, 0.1, 2.0 };
// SleepMode::ENERGY: the most by which a calm blade is away from rest, or swings. Usually 0.5 to 3. Above 5 mm blades visibly stop; below
// 0.1 mm tiles are simulated whose motion is invisible.
inline constexpr Tunable SLEEP_MOTION{ "sleep_motion", "mm", 0.01, 50.0, 0.01, 1.0 };
// Time in which a blade returns to rest. Usually 0.2 to 1. 0: it jumps there.
inline constexpr Tunable SETTLE_TIME{ "settle_time", "s", 0.0, 10.0, 0.05, 0.5 };

// When a tile that no collider meets goes to sleep.
enum class SleepMode {
	TIMER, // sleep_delay after the last meeting, as in the paper
	ENERGY, // once its blades have been calm for a while
};

struct TileParams {
	static constexpr int MAX_POOL_SIZE = 16384; // The pool texture has one row for each slot; GPUs allow 16,384 rows.

	int pool_size = 4096; // Tiles that can be awake at once; 0 to MAX_POOL_SIZE. Too small: distant bodies bend nothing.
	SleepMode sleep_mode = SleepMode::ENERGY;
	double contact_distance = 0.0; // From an eye: contact_rate applies up to there. Metres; 0: everywhere.
	double sleep_delay = SLEEP_DELAY.initial; // Seconds.
	double sleep_energy = SolverParams().energy_within(1e-3 * SLEEP_MOTION.initial); // Largest energy of calm blades. J/kg.
	// Seconds for which no collider was in a tile, before its blades move by their strains. Less: they jump then, by more than a
	// millimetre. More: they cost twice as much for longer.
	double alone_time = 0.5;
	double alone_air = 20.0; // Air that forces move faster than this bends blades more sharply than strains can describe. m/s.
	double settle_time = SETTLE_TIME.initial; // Seconds.
	// SleepMode::ENERGY: a tile on which nothing changed for this time is no longer simulated. Too short: blades stop while they still
	// swing. Seconds.
	double still_delay = SolverParams().calm_time();
	double overhang = 0.3; // Metres that blades lean out over their tile's square. Too small: bodies pass through tips.
	double low = 0.0; // Metres above the field: the lowest ground below a tile.
	double height = 1.0; // Metres above the field: the highest tip. Too small: bodies pass through tips.
	uint32_t seed = 0; // Of the tiles' starts in the patch.
	double segment = 0.0; // Metres, of the longest blade. Too short: its edges meet no sharp bodies, see is_sharp().
	bool is_mapped = false; // StepInput::growth describes how the blades grow.

	// Returns the same parameters within limits; NaN becomes the default.
	TileParams sanitised() const;
	// While the pool is too small, a tile gets a slot before others if it is as near to the picture as the first of these, and keeps it
	// as long as it is as near as the second. Equal: tiles at the edge take slots from each other as a camera trembles. Metres.
	static constexpr float SEEN_MARGIN = 1.0f, HELD_MARGIN = 3.0f;
	// And takes one from a tile farther away if the bands of their distances (see TileView) differ by so much: 1.15 to 1.5 times as far.
	static constexpr int FARTHER_BANDS = 2;
	// Most slots that tiles under bodies lose in a step to tiles that are seen better. Fewer: a camera that turns quickly sees bodies in
	// grass that they have not bent for longer than a quarter of a second. More: a step wakes many tiles at once.
	int most_yielding() const { return std::max(MIN_YIELDING, pool_size / YIELDING_PART); }
	// Returns the most pairs of a tile and a collider, for buffers that are made once.
	int list_capacity() const { return std::max(MIN_LIST_CAPACITY, ENTRIES_PER_SLOT * pool_size); }
	bool operator==(const TileParams &) const = default;

private:
	static constexpr int ENTRIES_PER_SLOT = 16; // The paper's scene has one (128 objects on 32 tiles, 4,096 slots).
	static constexpr int MIN_LIST_CAPACITY = 4096;
	static constexpr int YIELDING_PART = 16, MIN_YIELDING = 16;
};

// now: after the last update. Everything else is counted since the last reset.
struct TileStatistics {
	int awake = 0; // now: tiles that have a slot
	int simulated = 0; // now: awake tiles that this step simulates
	int settling = 0; // now: awake tiles on the way back to rest
	int still = 0; // now: awake tiles that are not simulated, since nothing on them changes
	int colliders = 0; // now: colliders that meet an awake tile
	int list_entries = 0; // now: total number of colliders of the simulated tiles
	int high_water = 0; // most tiles ever awake at once
	uint64_t tile_steps = 0; // simulated tiles, summed over the steps
	uint64_t left_out_blades = 0; // blades of simulated tiles that were not simulated since no camera needs them, summed over the steps
	uint64_t followed_blades = 0; // those of left_out_blades that are drawn all the same, and follow others
	uint64_t widened = 0; // times that a tile's drawn blades became more
	uint64_t woken = 0; // tiles that got a slot
	uint64_t slept = 0; // tiles that came to rest and gave it back
	uint64_t evicted = 0; // tiles that lost it to another before they were at rest
	uint64_t yielded = 0; // tiles under colliders that lost it to one that cameras see better
	uint64_t refused = 0; // colliders, one a step, that met tiles without a slot when the full pool had none to give
	uint64_t looked_at = 0; // tiles tested against a collider
	uint64_t ranked = 0; // tiles and ways of colliders that were tested for who sees them, since the pool was too small
	uint64_t capped = 0; // tiles under a collider that were not looked at, since work a step is bounded
	uint64_t bad_colliders = 0; // shapes left out since ColliderShape::sanitise() refused them
};

} // namespace grass
