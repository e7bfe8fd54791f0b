// SPDX-License-Identifier: MIT
// Wear in 256ths of a code. A thousand light steps add up to a path, though each is less than a code: MAP_WEAR_REST stores the remainder.
#pragma once

#include "core/map/map_channels.h"

#include <algorithm>

namespace grass {

struct FineWear {
	static constexpr int32_t PARTS = 256; // of a code
	static constexpr int32_t MOST = info_of(MAP_WEAR).highest * PARTS;
	int32_t parts = 0; // 0..MOST

	static FineWear of_codes(int32_t p_wear, int32_t p_rest) { return { std::min(p_wear * PARTS + p_rest, MOST) }; }
	int32_t wear() const { return parts / PARTS; }
	int32_t rest() const { return parts % PARTS; }

	// Moves p_share of the way up to a higher code; a lower one changes nothing.
	FineWear raised(int32_t p_to, double p_share) const {
		return { parts + int32_t(std::round(std::max(p_to * PARTS - parts, 0) * p_share)) };
	}
	FineWear lowered(double p_codes) const { return { std::clamp(parts - int32_t(std::round(p_codes * PARTS)), 0, MOST) }; }
};

} // namespace grass
