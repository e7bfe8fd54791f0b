// SPDX-License-Identifier: MIT
// Paint by hand covers what rules fill, and no rule changes it (docs/history/0007). MAP_PAINT stores the painted density h and how much
// of the rule it covers, c; what grows, MAP_DENSITY, is rule (1 - c) + h c.
#pragma once

#include "core/map/map_channels.h"

#include <algorithm>

namespace grass {

// Returns the code p_weight of the way from one code to another, moving by at least one code, so that a weak brush reaches its target too.
inline int32_t toward(int32_t p_from, int32_t p_to, double p_weight) {
	const double way = double(p_to) - p_from;
	const double step = std::round(way * p_weight);
	if (step == 0.0 && way != 0.0 && p_weight * 255.0 >= 1.0) {
		return p_from + (way > 0.0 ? 1 : -1);
	}
	return p_from + int32_t(step);
}

struct HandPaint {
	static constexpr int32_t FULL = 255;
	int32_t density = 0, cover = 0; // codes

	bool operator==(const HandPaint &) const = default;

	// Returns what grows where a rule fills p_rule.
	int32_t over(int32_t p_rule) const { return (p_rule * (FULL - cover) + density * cover + FULL / 2) / FULL; }

	// Returns the paint after a brush moved p_weight of the way to density p_aim. over() then moves equally far, whatever the rule fills.
	HandPaint brushed(int32_t p_aim, double p_weight) const {
		HandPaint after;
		after.cover = toward(cover, FULL, p_weight);
		if (after.cover > 0) {
			const double share = p_weight * FULL / after.cover;
			after.density = cover == 0 ? p_aim : toward(density, p_aim, std::min(share, 1.0));
		}
		return after;
	}
};

} // namespace grass
