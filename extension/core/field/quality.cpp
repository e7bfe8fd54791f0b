// SPDX-License-Identifier: MIT
#include "core/field/quality.h"

#include "core/tiles/tile_params.h"

#include <algorithm>
#include <cmath>

namespace grass {

int64_t Quality::scale_pool(int64_t p_tiles) const {
	const double scaled = double(p_tiles) * factor(QUALITY_POOL_TILES);
	return scaled > 0.0 ? std::clamp<int64_t>(std::llround(scaled), 1, TileParams::MAX_POOL_SIZE) : 0;
}

} // namespace grass
