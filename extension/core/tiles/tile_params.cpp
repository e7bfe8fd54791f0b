// SPDX-License-Identifier: MIT
#include "core/tiles/tile_params.h"

#include <cmath>

namespace grass {

namespace {

double limit_or(double p_value, double p_max, double p_default) {
	return std::isnan(p_value) ? p_default : std::clamp(p_value, 0.0, p_max);
}

} // namespace

TileParams TileParams::sanitised() const {
	const TileParams defaults;
	TileParams params = *this;
	params.pool_size = std::clamp(pool_size, 0, MAX_POOL_SIZE);
	params.sleep_delay = limit_or(sleep_delay, 3600.0, defaults.sleep_delay);
	params.sleep_energy = limit_or(sleep_energy, 1e6, defaults.sleep_energy);
	params.alone_time = limit_or(alone_time, 1e6, defaults.alone_time);
	params.alone_air = limit_or(alone_air, 1e6, defaults.alone_air);
	params.settle_time = limit_or(settle_time, 60.0, defaults.settle_time);
	params.still_delay = limit_or(still_delay, 3600.0, defaults.still_delay);
	params.overhang = limit_or(overhang, 100.0, defaults.overhang);
	params.low = std::isfinite(low) ? low : defaults.low;
	params.height = std::isfinite(height) ? height : defaults.height;
	params.segment = limit_or(segment, 100.0, defaults.segment);
	return params;
}

} // namespace grass
