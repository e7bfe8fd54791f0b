// SPDX-License-Identifier: MIT
#include "core/blades/wind.h"

#include <cmath>

namespace grass {

void WindClock::advance(double p_delta, double p_speed, double p_gust_size) {
	sway = std::fmod(sway + p_delta, GRASS_WIND_SWAY_PERIOD);
	roll = std::fmod(roll + p_delta * p_speed / p_gust_size, GRASS_WIND_ROLL_PERIOD);
}

} // namespace grass
