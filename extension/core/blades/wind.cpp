// SPDX-License-Identifier: MIT
#include "core/blades/wind.h"

#include <algorithm>
#include <cmath>

namespace grass {

namespace {

float smoothstep(float p_from, float p_to, float p_value) {
	const float t = std::clamp((p_value - p_from) / (p_to - p_from), 0.0f, 1.0f);
	return t * t * (3.0f - 2.0f * t);
}

} // namespace

void WindClock::advance(double p_delta, double p_speed, double p_gust_size) {
	sway = std::fmod(sway + p_delta, GRASS_WIND_SWAY_PERIOD);
	roll = std::fmod(roll + p_delta * p_speed / p_gust_size, GRASS_WIND_ROLL_PERIOD);
}

float gust_at(const Eigen::Vector2f &p_place, const WindClock &p_clock, const WindParams &p_wind) {
	const float speed = p_wind.velocity.norm();
	const Eigen::Vector2f ahead = p_wind.velocity / speed;
	const Eigen::Vector2f aside(-ahead.y(), ahead.x());
	Eigen::Vector2f rolled = Eigen::Vector2f(p_place.dot(ahead), 0.4f * p_place.dot(aside)) / p_wind.gust_size;
	rolled.x() -= float(p_clock.roll);
	rolled.x() += 0.35f * std::sin(2.1f * rolled.y() + float(GRASS_WIND_WINDING) * rolled.x());
	const Eigen::Array4f noise = 0.65f * value_noise(rolled * 2.0f) + 0.35f * value_noise(rolled * 4.6f + Eigen::Vector2f(3.7f, 8.1f));
	return smoothstep(0.38f, 0.68f, noise[0]);
}

Wind wind_at(
		const Eigen::Vector2f &p_place, float p_along, const Eigen::Array4f &p_random, const WindClock &p_clock, const WindParams &p_wind) {
	Wind here;
	const float time = float(p_clock.sway);
	const float speed = p_wind.velocity.norm();
	if (!(speed > 0.0f)) {
		return here;
	}
	here.gust = gust_at(p_place, p_clock, p_wind);
	const float local = speed * (1.0f + p_wind.gust_strength * (1.6f * here.gust - 0.6f)) * (0.8f + 0.4f * p_random[0]);
	const float half = float(GRASS_WIND_HALF);
	const float push = float(GRASS_WIND_MOST) * local * local / (local * local + half * half);

	const Eigen::Vector2f ahead = p_wind.velocity / speed;
	const Eigen::Vector2f aside(-ahead.y(), ahead.x());
	const float phase = 3.0f * p_random[1] + 0.9f * p_place.dot(ahead) - 0.7f * p_along;
	float with = 0.5f * std::sin(5.1f * time + phase) + 0.3f * std::sin(8.9f * time + 1.7f * phase);
	with += 0.2f * std::sin(14.3f * time + 2.3f * phase);
	const float across = 0.6f * std::sin(4.3f * time + 1.3f * phase + 6.0f * p_random[2]) + 0.4f * std::sin(10.7f * time + 2.9f * phase);
	here.tilt = p_along * push * ((1.0f + 0.3f * with) * ahead + (0.25f * across + 0.4f * (p_random[3] - 0.5f)) * aside);
	return here;
}

Eigen::Vector3f wind_point(const Eigen::Vector3f &p_point, const Eigen::Vector3f &p_reach, const Eigen::Vector2f &p_tilt) {
	const Eigen::Vector3f bow = 0.57735027f * (p_point - p_reach);
	const Eigen::Vector3f near_root = tilt_change(p_point + bow, 0.21132487f * p_tilt);
	const Eigen::Vector3f near_point = tilt_change(p_point - bow, 0.78867513f * p_tilt);
	Eigen::Vector3f bent = p_point + 0.5f * (near_root + near_point);
	bent.y() = std::max(bent.y(), std::min(p_point.y(), 0.01f));
	return bent;
}

float wind_hold(const Eigen::Vector3f &p_point, const Eigen::Vector3f &p_reach) {
	return smoothstep(0.0f, 0.35f, p_point.y() / std::max(p_reach.norm(), 1e-6f));
}

} // namespace grass
