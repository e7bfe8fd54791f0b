// SPDX-License-Identifier: MIT
// What every reference problem is made of.
#pragma once

#include "blade_scene.h"
#include "tape.h"

#include <chrono>

namespace grass::test {

inline constexpr double FRAME = 1.0 / 60.0; // seconds

struct Config {
	Method method;
	Step step;
	int substeps; // a frame
	int iterations; // a substep
};

// On tape, p_keep is what of the problem is wanted back after every p_stride steps.
inline BladeScene make_scene(const Config &p_config, Keep p_keep, int p_stride, double p_damping_ratio, double p_frequency = 1.2) {
	BladeScene scene;
	if (p_config.step == step_on_tape) {
		tape->begin(p_keep, p_stride);
	}
	scene.params.method = p_config.method;
	scene.params.iterations = p_config.iterations;
	scene.params.damping_ratio = p_damping_ratio;
	scene.params.natural_frequency = p_frequency;
	scene.params.taper = 0.0; // the references are even rods, and round
	scene.params.width_to_thickness = 1.0;
	scene.step_function = p_config.step;
	return scene;
}

inline void step_frame(BladeScene &r_scene, const Config &p_config) {
	r_scene.step_for(FRAME, p_config.substeps / FRAME);
}

// Returns milliseconds that a frame of 65,536 blades takes as they are stepped now: the best of many, on one core.
inline double frame_time(BladeScene &r_scene, const Config &p_config) {
	double best = 1e9;
	for (int frame = 0; frame < 40; frame++) {
		const auto start = std::chrono::steady_clock::now();
		step_frame(r_scene, p_config);
		best = std::min(best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
	}
	return best * 65536.0 / GRASS_BLADES_PER_TILE;
}

using Track = std::vector<Eigen::Vector3f>; // all knots of all blades, frame after frame, metres

inline void append_knots(const BladeScene &p_scene, Track &r_path) {
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			r_path.push_back(p_scene.knot(b, k));
		}
	}
}

// Root of the mean square of the distance, blade lengths.
inline double difference(const Track &p_a, const Track &p_b) {
	double sum = 0.0;
	for (size_t i = 0; i < p_a.size(); i++) {
		sum += double((p_a[i] - p_b[i]).squaredNorm());
	}
	return std::sqrt(sum / double(p_a.size())) / 0.5;
}

} // namespace grass::test
