// SPDX-License-Identifier: MIT
// The band of heights in which a field's ground is. Fields above one another, such as the floors of a ruin, have bands of their own.
#pragma once

#include "core/base/tunable.h"

namespace grass {

// How far above and below the field ground is searched, metres.
inline constexpr double GROUND_SEARCH = 1024.0;
inline constexpr Tunable GROUND_LOW{ "ground_low", "m", -GROUND_SEARCH, GROUND_SEARCH, 0.01, -GROUND_SEARCH };
inline constexpr Tunable GROUND_HIGH{ "ground_high", "m", -GROUND_SEARCH, GROUND_SEARCH, 0.01, GROUND_SEARCH };

struct GroundBand {
	double low = GROUND_LOW.initial, high = GROUND_HIGH.initial; // metres above the field

	bool is_empty() const { return !(low < high); }
	bool is_whole() const { return low <= -GROUND_SEARCH && high >= GROUND_SEARCH; }
	// Returns whether a height is within the band. A side that was not set has no limit.
	bool contains(double p_height) const {
		return (low <= -GROUND_SEARCH || p_height >= low) && (high >= GROUND_SEARCH || p_height <= high);
	}
	bool meets(double p_low, double p_high) const {
		return (low <= -GROUND_SEARCH || p_high >= low) && (high >= GROUND_SEARCH || p_low <= high);
	}
};

} // namespace grass
