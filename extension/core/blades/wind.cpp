// SPDX-License-Identifier: MIT
#include "core/blades/wind.h"

#include <cmath>
#include <numbers>

namespace grass {

void WindClock::advance(double p_delta, double p_speed, double p_gust_size) {
	sway = std::fmod(sway + p_delta, GRASS_WIND_SWAY_PERIOD);
	roll = std::fmod(roll + p_delta * p_speed / p_gust_size, GRASS_WIND_ROLL_PERIOD);
}

Eigen::Vector2d wind_in_field(const Eigen::Matrix3d &p_turn, double p_speed, double p_direction) {
	const double angle = p_direction * (std::numbers::pi / 180.0);
	const Eigen::Vector3d wind = p_turn.transpose() * Eigen::Vector3d(p_speed * std::cos(angle), 0.0, p_speed * std::sin(angle));
	return { wind.x(), wind.z() };
}

} // namespace grass
