// SPDX-License-Identifier: MIT
// Blades that swing at two frequencies with their base, leaves that a load aside twists, blades that a load lets go.
#pragma once

#include "blade_scene.h"
#include "swings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace grass::test {

using namespace swings;

// Of eight shapes, each to eight sides: upright, leaning, curved, S-shaped and wound ones.
inline BladeScene make_swinging(SwingKind p_kind) {
	BladeScene scene;
	scene.params.width_to_thickness = p_kind == TWISTED ? 5.0 : 2.0;
	scene.params.taper = 0.3;
	scene.params.natural_frequency = 1.2;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const float heading = float(b % 8) * 0.785398f + 0.1f;
		scene.tile->width[0][b] = -sin_of(heading);
		scene.tile->width[1][b] = cos_of(heading);
		Eigen::Vector3f knot = Eigen::Vector3f::Zero();
		for (int k = 0; k < GRASS_KNOTS; k++) {
			scene.set_rest(b, k, knot);
			const float m = float(knot_share(k) + 0.5 * segment_share(k));
			const float leans[] = { 0.02f, 0.4f, 0.8f * m, 1.4f * m, 0.6f * sin_of(6.2831853f * m), 0.15f + 0.5f * m, 0.2f + 0.7f * m,
				0.1f + 0.9f * m * m };
			const float turns[] = { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.6f * m, -2.6f * m, 0.5f * m };
			const float lean = leans[b / 8], bearing = heading + turns[b / 8];
			knot += scene.length * float(segment_share(k)) *
					Eigen::Vector3f(sin_of(lean) * cos_of(bearing), cos_of(lean), sin_of(lean) * sin_of(bearing));
		}
	}
	return scene;
}

// p_step(seconds) takes a step with r_params; p_offset(blade, knot), metres.
template <class Step, class Offset>
Swing swing_through(SwingKind p_kind, double p_rate, SolverParams &r_params, const Step &p_step, const Offset &p_offset) {
	constexpr double FRAME = 1.0 / 60.0, DAMPING[] = { 0.3, 0.4, 0.2 }, GAMMA[] = { 1.1, 4.0, 5.0 };
	constexpr int FRAMES[] = { 150, 180, 72 };
	const Eigen::Vector3d ways[] = { { 0.8, 0.1, 0.59 }, { 0.3, 0.05, 0.95 }, { 0.9, -0.2, 0.38 } };
	const double share = 2.0 * std::numbers::pi * 1.2 / 3.5160152685, load = GAMMA[p_kind] * share * share * 0.5;
	const auto set_load = [&](double p_share) {
		for (int c = 0; c < 3; c++) {
			r_params.load[c] = ways[p_kind].normalized()[c] * load * p_share;
		}
	};
	if (p_kind == LET_GO) { // where they stand under the load
		r_params.damping_ratio = 1.2;
		for (int i = 0; i < 600; i++) {
			set_load(std::min(1.0, (i + 1) / 90.0));
			p_step(FRAME);
		}
		set_load(0.0);
	}
	r_params.damping_ratio = DAMPING[p_kind];
	const int parts = int(std::lround(p_rate * FRAME));
	Swing path;
	for (int i = 0; i < FRAMES[p_kind] * parts; i++) {
		const double time = i / p_rate;
		if (p_kind == SHAKEN) {
			set_load(std::sin(6.2831853 * 1.08 * time) + 0.7 * std::sin(6.2831853 * 3.4 * time));
		} else if (p_kind == TWISTED) {
			set_load(std::min(1.0, time / 0.25));
		}
		p_step(1.0 / p_rate);
		for (int b = 0; b < GRASS_BLADES_PER_TILE && (i + 1) % parts == 0; b++) {
			for (int place = 1; place <= SWING_PLACES; place++) {
				path.push_back(between_knots(double(place) / SWING_PLACES, [&](int p_knot) { return p_offset(b, p_knot); }) / 0.5f);
			}
		}
	}
	return path;
}

// Of chains.
inline Swing swing_chains(SwingKind p_kind, double p_rate) {
	BladeScene scene = make_swinging(p_kind);
	return swing_through(
			p_kind, p_rate, scene.params, [&](double p_seconds) { scene.step(p_seconds); },
			[&](int p_blade, int p_knot) { return (scene.knot(p_blade, p_knot) - scene.rest(p_blade, p_knot)).eval(); });
}

// Root of the mean square of how far apart two paths are, blade lengths.
inline double apart_by(const Swing &p_a, const Swing &p_b) {
	double sum = 0.0;
	for (size_t i = 0; i < p_a.size(); i++) {
		sum += double((p_a[i] - p_b[i]).squaredNorm());
	}
	return std::sqrt(sum / double(p_a.size()));
}

} // namespace grass::test
