// SPDX-License-Identifier: MIT
// A collider's way over tiles in a step, as TileMeetings keeps it.
#pragma once

#include "core/bodies/body_shape.h"
#include "core/tiles/tile_bounds.h"

#include <cstdint>

namespace grass {

// A collider's path in the step, or a piece of a long one.
struct TileWay {
	Bounds swept; // the box around it
	TileRange range; // tiles that it may meet
	uint32_t collider;
	uint32_t squares = 0; // index of the first square of its range
	int asleep = 0; // number of sleeping tiles in the range
	bool is_kept = false; // it meets what it met in the last step
	bool is_seen = false; // cameras see tiles of its range; not computed while the list has room for all
};

// What a collider was in the last step, and the results for one with a stamp.
struct KnownWay {
	uint64_t owner = 0;
	int type = -1; // unknown
	Eigen::Vector3d half_extents, place;
	uint64_t stamp = 0; // 0: unknown
	Bounds swept;
	TileRange whole, range; // the full range, and the range that the list had room for
	uint32_t first = 0, count = 0; // its slots
	bool is_good = false; // otherwise it was rejected
	bool is_complete = false; // all tiles that it meets have slots
};

} // namespace grass
