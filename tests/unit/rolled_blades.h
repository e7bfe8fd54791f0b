// SPDX-License-Identifier: MIT
// Single blades that a ball rolls through, at every offset, and how far they are from where they converge to.
#pragma once

#include "blade_scene.h"
#include "rolled.h"

#include <algorithm>
#include <cmath>

namespace grass::test {

using namespace rolled;

inline constexpr float ROLLED_RADIUS = 0.15f; // of the ball, metres
inline constexpr float FARTHEST = 0.1f; // metres, of a root from the way of the ball's centre

// Returns blades at every offset, on both sides of the ball's way. By turns one is straight, one leans and one is curved, to any side.
inline BladeScene make_rolled(const Roll &p_roll) {
	BladeScene scene;
	scene.params.width_to_thickness = p_roll.is_leaf ? WIDTH_TO_THICKNESS.initial : 1.0;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const float lean = b % 3 == 1 ? 0.5f : 0.0f, curve = b % 3 == 2 ? 1.0f : 0.0f, heading = 2.4f * float(b); // radians
		scene.tile->width[0][b] = -sin_of(heading);
		scene.tile->width[1][b] = cos_of(heading);
		scene.tile->root[2][b] = FARTHEST * (float(b) + 0.5f) / GRASS_BLADES_PER_TILE * (b % 2 == 0 ? 1.0f : -1.0f);
		Eigen::Vector3f knot = Eigen::Vector3f::Zero();
		for (int k = 0; k < GRASS_KNOTS; k++) {
			scene.set_rest(b, k, knot);
			const float angle = lean + curve * float(knot_share(k));
			knot += scene.length * float(segment_share(k)) *
					Eigen::Vector3f(sin_of(angle) * cos_of(heading), cos_of(angle), sin_of(angle) * sin_of(heading));
		}
	}
	return scene;
}

inline Look look_at_places(const BladeScene &p_scene) {
	Look look;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		for (int place = FIRST_PLACE; place <= LAST_PLACE; place++) {
			look.push_back(p_scene.place(b, double(place) / LAST_PLACE));
		}
	}
	return look;
}

// Returns the blades p_looks times a second while a ball rolls through them, and for as long after it as makes whole thirtieths.
inline std::vector<Look> roll_through(const Roll &p_roll, const Stepping &p_stepping, double p_looks) {
	BladeScene scene = make_rolled(p_roll);
	scene.params.iterations = p_stepping.iterations;
	scene.params.contact_rate = p_stepping.contact_rate;
	scene.add(GRASS_SPHERE, { -0.7f, ROLLED_RADIUS, 0.0f }, { ROLLED_RADIUS, 0.0f, 0.0f });
	const double rate = p_stepping.rate, seconds = std::min(1.5, std::ceil(30.0 * (1.2 / double(p_roll.speed) + 0.3)) / 30.0);
	std::vector<Look> looks;
	for (int i = 0; i < int(seconds * rate + 1e-6); i++) {
		const auto place = [&](int p_step) { return Eigen::Vector3f(-0.7f + p_roll.speed * float(p_step / rate), ROLLED_RADIUS, 0.0f); };
		BladeScene::place(scene.colliders[0], place(i), place(i + 1));
		scene.colliders[0].position.w = p_roll.friction;
		scene.step(1.0 / rate);
		if ((i + 1) % int(rate / p_looks) == 0) {
			looks.push_back(look_at_places(scene));
		}
	}
	return looks;
}

// Adds each blade's root mean square over places and time to r_errors, blade lengths of half a metre. p_limit: of p_finer times as many
// looks.
inline void add_errors(const std::vector<Look> &p_looks, const std::vector<Look> &p_limit, size_t p_finer, std::vector<double> &r_errors) {
	for (size_t b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		double sum = 0.0;
		for (size_t i = 0; i < p_looks.size(); i++) {
			const Look &limit = p_limit.at((i + 1) * p_finer - 1);
			for (size_t j = b * PLACES; j < (b + 1) * PLACES; j++) {
				sum += double((p_looks[i][j] - limit[j]).squaredNorm());
			}
		}
		r_errors.push_back(std::sqrt(sum / double(p_looks.size() * PLACES)) / 0.5);
	}
}

// Returns the error that the share p_share of them do not exceed.
inline double pick(std::vector<double> p_errors, double p_share) {
	const auto place = p_errors.begin() + ptrdiff_t(p_share * double(p_errors.size()));
	std::nth_element(p_errors.begin(), place, p_errors.end());
	return *place;
}

inline double median_of(const std::vector<double> &p_errors) {
	return pick(p_errors, 0.5);
}

} // namespace grass::test
