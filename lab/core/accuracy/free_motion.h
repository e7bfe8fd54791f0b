// SPDX-License-Identifier: MIT
// The reference problems without colliders.
#pragma once

#include "problem.h"
#include "references.h"

namespace grass::test {

// Error of the straight blade's sag under an even load across it, share.
inline double static_error(const Config &p_config, double p_gamma) {
	constexpr int FRAMES = 300;
	BladeScene scene = make_scene(p_config, Keep::TIP, FRAMES * p_config.substeps, 1.0);
	scene.params.load[0] = load_of_gamma(p_gamma, scene.params.natural_frequency, double(scene.length));
	for (int frame = 0; frame < FRAMES; frame++) {
		step_frame(scene, p_config);
	}
	return std::abs(double(scene.knot(0, GRASS_KNOTS - 1).x() / scene.length) / elastica_drop(p_gamma) - 1.0);
}

// Error of the straight blade's first frequency, share; r_kept: amplitude kept a period.
inline double frequency_error(const Config &p_config, double &r_kept) {
	const double frequency = 2.5;
	BladeScene scene = make_scene(p_config, Keep::TIP, 1, 1.0, frequency);
	scene.params.load[0] = load_of_gamma(0.1, frequency, double(scene.length));
	for (int frame = 0; frame < 120; frame++) {
		step_frame(scene, p_config);
	}
	scene.params.load[0] = 0.0;
	scene.params.damping_ratio = 0.0;
	const double delta = FRAME / p_config.substeps;
	double before = 0.0, first = 0.0, last = 0.0, most = 0.0, first_most = 0.0, last_most = 0.0;
	int periods = -1;
	for (int i = 0; i < int(3.0 / delta); i++) {
		scene.step(delta);
		const double now = double(scene.knot(0, GRASS_KNOTS - 1).x());
		most = std::max(most, std::abs(now));
		if (before < 0.0 && now >= 0.0) {
			last = (double(i) - now / (now - before)) * delta;
			last_most = most;
			if (++periods == 0) {
				first = last;
				first_most = most;
			}
			most = 0.0;
		}
		before = now;
	}
	r_kept = periods > 0 ? std::pow(last_most / first_most, 1.0 / periods) : 0.0;
	return periods > 0 ? std::abs(periods / (last - first) / frequency - 1.0) : 1.0;
}

// Released from an arc, for a second.
inline Track transient(const Config &p_config) {
	BladeScene scene = make_scene(p_config, Keep::KNOTS, p_config.substeps, 0.1);
	scene.bend(1.0f);
	Track path;
	for (int frame = 0; frame < 60; frame++) {
		step_frame(scene, p_config);
		append_knots(scene, path);
	}
	return path;
}

} // namespace grass::test
